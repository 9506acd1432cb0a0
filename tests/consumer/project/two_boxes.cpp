// One header, one query: when do two boxes touch? The rest of the object file is the cost of that query.
#include <graze/cast.hpp>

int main() {
  graze::Body<double> a, b;
  a.shape = b.shape = graze::Box<double>{{1, 1, 1}};
  b.position = {0, 4, 0};
  b.orientation = {2, 1, 0, 0};
  b.displacement = {0, -4, 0};
  return graze::cast(a, b).outcome == graze::Outcome::hit ? 0 : 1;
}
