// A real number between two doubles.
#pragma once

namespace graze::oracle {

// low <= x <= high. They are neighbouring doubles wherever x is the root of a rational. Each function that
// returns a wider enclosure documents it.
struct Enclosure {
  double low = 0, high = 0;
};

}  // namespace graze::oracle
