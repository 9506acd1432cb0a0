// Of without_assertions.cpp, for assertions_test.cpp. It names nothing of graze: the two see another one.
#pragma once

float round_down_without_assertions(double x);
