#include "properties/scenes/generate.hpp"

namespace graze::law {
namespace {

// [Steele, Lea, Flood 2014: SplitMix64]
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}
  std::uint64_t next() {
    std::uint64_t z = (state_ += 0x9e3779b97f4a7c15u);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }
  std::uint32_t below(std::uint32_t n) { return static_cast<std::uint32_t>(next() % n); }
  bool one_in(std::uint32_t n) { return below(n) == 0; }
  int between(int low, int high) {
    return low + static_cast<int>(below(static_cast<std::uint32_t>(high - low + 1)));
  }

 private:
  std::uint64_t state_;
};

class Generator {
 public:
  explicit Generator(std::uint64_t seed) : random_(seed), step_(random_.one_in(2) ? 0.125 : 0.1) {}

  RandomScene operator()() {
    RandomScene out;
    scene::Options& options = out.options;
    const std::uint32_t kind = random_.below(8);
    options.tier = kind == 0 ? Tier::standard : kind <= 2 ? Tier::exact : Tier::certified;
    options.ask = random_.one_in(2) ? scene::Ask::pair : static_cast<scene::Ask>(random_.below(scene::kAsks));
    options.request = random_.one_in(3) ? Request::verdict : Request::normal | Request::witnesses;
    options.t_max = random_.one_in(4) ? 0.1 * random_.between(0, 30) : 1;
    if (random_.one_in(4)) options.target_distance = 0.1 * random_.between(1, 3);
    if (options.tier != Tier::exact && random_.one_in(2)) options.tolerance = 1e-3;
    exact_ = options.tier == Tier::exact;
    slow_ = options.tolerance > 0;
    filtered_ = random_.one_in(4);
    // Within a rounding of a touch, tier standard may decide either way: the numbers are then in general
    // position.
    generic_ = options.tier == Tier::standard;
    const int bodies = random_.between(2, 12);
    for (int k = 0; k < bodies; ++k) out.scene.bodies.push_back(member(k, out.scene.bodies));
    const int probes = random_.one_in(2) ? random_.between(1, 4) : 0;
    for (int k = 0; k < probes; ++k) out.scene.probes.push_back(probe(k));
    return out;
  }

 private:
  double number(int low, int high) {
    const double x = step_ * random_.between(low, high);
    return generic_ ? x + 0x1p-24 * random_.between(0, 1 << 20) : x;
  }
  Vec3<double> vector(int most) { return {number(-most, most), number(-most, most), number(-most, most)}; }
  double size() { return number(random_.one_in(8) ? 0 : 1, 8); }
  Quaternion<double> orientation() {
    switch (random_.below(4)) {
      case 0:
        return {1, 1, 0, 0};
      case 1:
        return {double(random_.between(1, 4)), double(random_.between(-3, 3)), double(random_.between(-3, 3)),
                double(random_.between(-3, 3))};
      default:
        return {};
    }
  }

  Shape<double> polytope() {
    switch (random_.below(6)) {
      case 0:
        return Point<double>{};
      case 1:
        return Segment<double>{vector(6), vector(6)};
      case 2:
        return Triangle<double>{vector(6), vector(6), vector(6)};
      case 3: {
        std::vector<Vec3<double>> vertices;
        for (int k = random_.between(4, 10); k > 0; --k) vertices.push_back(vector(7));
        return Hull<double>(std::span<const Vec3<double>>(vertices));
      }
      default:
        return Box<double>{Vec3<double>(size(), size(), size())};
    }
  }
  Shape<double> shape() {
    const std::uint32_t kind = random_.below(10);
    if (exact_ && kind >= 3 && kind <= 5) return polytope();
    switch (kind) {
      case 0:
        return Sphere<double>{size()};
      case 1:
      case 2:
        return Capsule<double>{size(), size()};
      case 3:
        return Cylinder<double>{size(), size()};
      case 4:
        return Cone<double>{size(), size()};
      case 5:
        return Ellipsoid<double>{Vec3<double>(size(), size(), size())};
      case 6:
        return rounded<double>(polytope(), size());
      case 7:
        return posed<double>(polytope(), vector(4), orientation());
      default:
        return polytope();
    }
  }

  void set_motion(RotatingBody<double>& moving) {
    Body<double>& body = moving.body;
    switch (random_.below(exact_ ? 4 : 10)) {
      case 0:
      case 1:
        return;  // at rest
      case 2:
        body.displacement = vector(20);
        return;
      case 3:
        body.displacement = random_.one_in(2) ? vector(400) : Vec3<double>(number(-30, 30), 0, 0);
        return;
      case 4:  // about an axis of its own frame, through its origin
        body.displacement = vector(15);
        if (random_.one_in(2)) body.orientation = {};
        moving.rotation = Vec3<double>::Unit(random_.between(0, 2)) * number(-40, 40);
        return;
      case 5:
        moving.rotation = vector(1) * (slow_ ? 1e-3 : 1.0);
        body.displacement = vector(15);
        return;
      case 6:
        moving.rotation = vector(30);
        moving.pivot = vector(10);
        return;
      default:
        moving.rotation = vector(15);
        body.displacement = vector(15);
        return;
    }
  }

  scene::Filter filter() {
    if (!filtered_) return {};
    return {1u << random_.below(3), random_.one_in(2) ? 7u : 1u << random_.below(3) | 1u << random_.below(3)};
  }

  scene::Member member(int k, const std::vector<scene::Member>& before) {
    scene::Member out;
    // Not in the order of the indices, so that ties show their sort key.
    out.name = std::string(1, static_cast<char>('a' + (7 * k + 3) % 26)) + std::to_string(k);
    Body<double>& body = out.body.body;
    body.shape = shape();
    body.position = vector(random_.one_in(6) ? 60 : 20);
    body.orientation = orientation();
    set_motion(out.body);
    if (!before.empty() && random_.one_in(4)) {
      // Side by side with another one, or as one with it: about one pivot, at one speed.
      const RotatingBody<double>& other =
          before[random_.below(static_cast<std::uint32_t>(before.size()))].body;
      body.position = other.body.position + vector(8);
      body.displacement = other.body.displacement;
      out.body.rotation = other.rotation;
      body.orientation = {};
      if (other.body.orientation.is_identity() && random_.one_in(2)) {
        out.body.pivot = other.body.position + other.pivot - body.position;
      }
    }
    out.filter = filter();
    return out;
  }

  scene::Probe probe(int k) {
    const std::string name = "probe " + std::to_string(9 - k);
    const Vec3<double> way = vector(20);
    scene::Probe out = scene::ray(name, vector(40), way);
    if (random_.one_in(2)) {
      out.body.body.shape = shape();
      out.t_max = random_.between(1, 3);
      if (!exact_ && random_.one_in(3)) out.body.rotation = vector(15);
    }
    out.first_only = random_.one_in(2);
    out.filter = filter();
    if (random_.one_in(8)) out.body.rotation = out.body.body.displacement = Vec3<double>::Zero();
    return out;
  }

  Random random_;
  double step_;
  bool exact_ = false, slow_ = false, filtered_ = false, generic_ = false;
};

}  // namespace

RandomScene random_scene(std::uint64_t seed) { return Generator(seed)(); }

}  // namespace graze::law
