// The number of allocations by operator new so far, in an executable that links count_allocations.cpp.
#pragma once

namespace graze::test {

[[nodiscard]] long long allocations();

}  // namespace graze::test
