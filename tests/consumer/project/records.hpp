// Writes an answer, and its proof in the text form graze.proof/1, one line each, to two files: line k of the
// one belongs to line k of the other.
//
//   answers    outcome toi_lower toi_upper normal point_a point_b, numbers as hexfloats
#pragma once

#include <cstdio>

#include "scenes.hpp"

class Records {
 public:
  // directory/answers.txt and directory/proofs.jsonl
  explicit Records(const std::string& directory)
      : answers_(std::fopen((directory + "/answers.txt").c_str(), "w")),
        proofs_(std::fopen((directory + "/proofs.jsonl").c_str(), "w")) {}
  Records(const Records&) = delete;
  Records& operator=(const Records&) = delete;
  ~Records() { close(); }

  [[nodiscard]] bool open() const { return answers_ != nullptr && proofs_ != nullptr; }
  // False if anything could not be written.
  bool close() {
    bool good = true;
    for (std::FILE** file : {&answers_, &proofs_}) {
      if (*file != nullptr) good = std::ferror(*file) == 0 && std::fclose(*file) == 0 && good;
      *file = nullptr;
    }
    return good;
  }

  template <class S>
  void write(const std::string& id, const char* method, const Scene<S>& scene,
             const graze::CastResult<S>& result) {
    std::fputs(name_of(result.outcome), answers_);
    for (const S x : {result.toi_lower, result.toi_upper}) number(answers_, x);
    for (const auto* v : {&result.normal, &result.point_a, &result.point_b}) {
      for (int i = 0; i < 3; ++i) number(answers_, (*v)[i]);
    }
    std::fputs("\n", answers_);

    std::fprintf(proofs_, R"({"schema": "graze.proof/1", "case": {"schema": "graze.case/1", "id": "%s")",
                 id.c_str());
    body("a", scene.a);
    body("b", scene.b);
    field("t_max", scene.t_max);
    field("target_distance", scene.target_distance);
    std::fprintf(proofs_, R"(}, "method": "%s", "scalar": "%s", "outcome": "%s", "proof": {"toi_lower": )",
                 method, sizeof(S) == 4 ? "float" : "double", name_of(result.outcome));
    const graze::Proof& proof = *result.proof;
    value(proof.toi_lower);
    if (proof.has_axis) axis(proof);
    field("toi_upper", proof.toi_upper);
    std::fprintf(proofs_, R"(, "%s": )", proof.of_cores ? "cores" : "portal");
    pairs(proof.portal, proof.portal_size);
    std::fputs("}}\n", proofs_);
  }

  static const char* name_of(graze::Outcome outcome) {
    switch (outcome) {
      case graze::Outcome::initially_overlapping:
        return "initially_overlapping";
      case graze::Outcome::hit:
        return "hit";
      case graze::Outcome::miss:
        return "miss";
      case graze::Outcome::not_converged:
        return "not_converged";
      case graze::Outcome::invalid_input:
        break;
    }
    return "invalid_input";
  }

 private:
  template <class S>
  static void number(std::FILE* file, S x) {
    std::fprintf(file, " %a", static_cast<double>(x));
  }
  template <class S>
  void value(S x) {
    if (std::isinf(x)) {
      std::fputs("\"inf\"", proofs_);
    } else {
      std::fprintf(proofs_, "\"%a\"", static_cast<double>(x));
    }
  }
  template <class S>
  void value(const graze::Vec3<S>& v) {
    for (int i = 0; i < 3; ++i) {
      std::fputs(i == 0 ? "[" : ", ", proofs_);
      value(v[i]);
    }
    std::fputs("]", proofs_);
  }
  template <class T>
  void field(const char* name, const T& x) {
    std::fprintf(proofs_, R"(, "%s": )", name);
    value(x);
  }
  void feature(const graze::Feature& feature) {
    std::fprintf(proofs_, R"({"vertex": %u)", static_cast<unsigned>(feature.vertex));
    field("offset", feature.offset);
    std::fputs("}", proofs_);
  }
  void support_pair(const graze::SupportPair& pair) {
    std::fputs(R"({"a": )", proofs_);
    feature(pair.a);
    std::fputs(R"(, "b": )", proofs_);
    feature(pair.b);
    std::fputs("}", proofs_);
  }
  template <class Pairs>
  void pairs(const Pairs& all, int size) {
    std::fputs("[", proofs_);
    for (int i = 0; i < size; ++i) {
      if (i > 0) std::fputs(", ", proofs_);
      support_pair(all[static_cast<std::size_t>(i)]);
    }
    std::fputs("]", proofs_);
  }
  void nearest(const graze::Proof& proof) {
    std::fputs(R"(, "axis": {"nearest": )", proofs_);
    pairs(proof.nearest.pair, proof.nearest.size);
    field("time", proof.nearest.time);
    if (proof.nearest.motion) std::fputs(R"(, "motion": true)", proofs_);
    if (proof.then) {
      std::fputs(R"(, "then": )", proofs_);
      factor(proof.factor[0]);
    }
    std::fputs("}", proofs_);
  }
  void axis(const graze::Proof& proof) {
    if (!proof.symbolic) return field("axis", proof.axis);
    if (proof.nearest.size > 0) return nearest(proof);
    std::fprintf(proofs_, R"(, "axis": {"sign": %d, "cross": [)", proof.axis_sign);
    factor(proof.factor[0]);
    std::fputs(", ", proofs_);
    factor(proof.factor[1]);
    std::fputs("]}", proofs_);
  }
  void factor(const graze::AxisFactor& factor) {
    switch (factor.kind) {
      case graze::AxisFactor::Kind::given:
        return value(factor.given);
      case graze::AxisFactor::Kind::motion:
        std::fputs(R"("motion")", proofs_);
        return;
      case graze::AxisFactor::Kind::difference:
        break;
    }
    std::fputs(R"({"from": )", proofs_);
    support_pair(factor.from);
    std::fputs(R"(, "to": )", proofs_);
    support_pair(factor.to);
    std::fputs("}", proofs_);
  }
  template <class S>
  void body(const char* name, const graze::Body<S>& body) {
    std::fprintf(proofs_, R"(, "%s": {"shape": )", name);
    shape(body.shape);
    field("position", body.position);
    const graze::Quaternion<S>& q = body.orientation;
    std::fprintf(proofs_, R"(, "orientation": ["%a", "%a", "%a", "%a"])", static_cast<double>(q.w),
                 static_cast<double>(q.x), static_cast<double>(q.y), static_cast<double>(q.z));
    field("displacement", body.displacement);
    std::fputs("}", proofs_);
  }
  template <class S>
  void shape(const graze::Shape<S>& shape) {
    if (const auto* sphere = std::get_if<graze::Sphere<S>>(&shape)) {
      std::fputs(R"({"type": "sphere")", proofs_);
      field("radius", sphere->radius);
    } else if (const auto* box = std::get_if<graze::Box<S>>(&shape)) {
      std::fputs(R"({"type": "box")", proofs_);
      field("half_extents", box->half_extents);
    } else if (const auto* hull = std::get_if<graze::Hull<S>>(&shape)) {
      std::fputs(R"({"type": "hull", "vertices": [)", proofs_);
      for (std::size_t i = 0; i < hull->size(); ++i) {
        if (i > 0) std::fputs(", ", proofs_);
        value(hull->vertex(i));
      }
      std::fputs("]", proofs_);
    } else {
      std::fputs(R"({"type": "point")", proofs_);
    }
    std::fputs("}", proofs_);
  }

  std::FILE* answers_;
  std::FILE* proofs_;
};
