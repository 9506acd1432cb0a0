// A real number between two doubles.
#pragma once

namespace graze::oracle {

// low <= x <= high, neighbouring doubles wherever x is the root of a rational; each function that returns one
// says where it is wider.
struct Enclosure {
  double low = 0, high = 0;
};

}  // namespace graze::oracle
