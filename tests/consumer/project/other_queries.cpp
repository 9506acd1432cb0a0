// The other end of two_boxes.cpp: a program that does use other queries, whose symbols must be found.
#include <graze/penetration.hpp>
#include <graze/swept_overlap.hpp>

int main() {
  graze::Body<double> a, b;
  a.shape = b.shape = graze::Box<double>{{1, 1, 1}};
  b.position = {0, 1, 0};
  const auto least = graze::penetration(a, b);
  const auto swept = graze::swept_overlap(a, b);
  return least.invalid == graze::Invalid::none && swept.invalid == graze::Invalid::none ? 0 : 1;
}
