// A crate, then a ball, falls past the side of a table, and exactly along it, in each tier.
//
// Side on side, the bodies touch on the way, and one unit in the last place decides. The exact and the certified tier decide
// every such tie of polytopes and of round bodies. The standard tier answers for shapes within its guarantee, a few units in
// the last place of the scene.
#include <graze/cast.hpp>
#include <graze/invalid_text.hpp>

#include <cmath>
#include <cstdio>

namespace {

template <graze::Scalar S>
void drop(const char* name, const graze::Shape<S>& shape, double x, const graze::CastOptions<S>& options) {
  const graze::Quaternion<S> turned = {3, 0, 0, 1};  // x to (0.8, 0.6, 0), exactly
  const graze::Body<S> table{.shape = graze::Box<S>{{S(0.75), S(0.75), S(0.5)}}, .orientation = turned};
  const graze::Body<S> falling{
      .shape = shape, .position = {S(x), S(0.75), 2}, .orientation = turned, .displacement = {0, 0, -3}};

  const graze::CastResult<S> r = graze::cast(table, falling, options);
  std::printf("  %-10s %s", name, to_text(r.outcome).data());
  if (r.outcome == graze::Outcome::invalid_input) {
    std::printf(": %s", to_text(r.invalid_at).c_str());
  } else if (r.outcome != graze::Outcome::miss) {
    std::printf(", %.17g to %.17g", double(r.toi_lower), double(r.toi_upper));
  }
  if (r.outcome == graze::Outcome::not_converged) std::printf(", %.1e from contact", double(r.distance));
  std::printf("\n");
}

template <template <class> class Kind>
void drop_by_each_tier(const char* text, const Kind<float>& single, const Kind<double>& shape, double x) {
  std::printf("%s\n", text);
  drop<float>("float", single, x, {.tolerance = 1e-3F});
  drop<double>("standard", shape, x, {});
  drop<double>("certified", shape, x, {.tier = graze::Tier::certified});
  drop<double>("exact", shape, x, {.tier = graze::Tier::exact});
}

}  // namespace

int main() {
  const double next = std::nextafter(1.0, 2.0);  // at x = 1 the sides are in one plane
  const graze::Box<float> small_crate{{0.5, 0.5, 0.5}};
  const graze::Box<double> crate{{0.5, 0.5, 0.5}};
  drop_by_each_tier("a crate onto the table", small_crate, crate, 0.5);
  drop_by_each_tier("a crate, side on side", small_crate, crate, 1);
  drop_by_each_tier("a crate, one unit in the last place beside", small_crate, crate, next);
  drop_by_each_tier("a ball, exactly along the side", graze::Sphere<float>{0.5}, graze::Sphere<double>{0.5},
                    1);
  drop_by_each_tier("a ball, one unit in the last place beside", graze::Sphere<float>{0.5},
                    graze::Sphere<double>{0.5}, next);
}
