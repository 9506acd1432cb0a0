// The functions of without_assertions.cpp, for assertions_test.cpp. This header names nothing of graze,
// because the two files see different versions of it.
#pragma once

float round_down_without_assertions(double x);
