#include "reports/pages/page_scene.hpp"

#include <fmt/format.h>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "corpus/families.hpp"
#include "corpus/format/case_io.hpp"
#include "corpus/format/names.hpp"
#include "engines/guarantees.hpp"
#include "properties/edit/case.hpp"
#include "properties/judge/judge.hpp"
#include "reports/drawing/draw.hpp"
#include "reports/drawing/drawn_scene.hpp"
#include "reports/pages/features.hpp"
#include "reports/pages/mesh.hpp"
#include "reports/pages/mesh_json.hpp"

namespace graze::show {
namespace {

using corpus::Case;
using draw::Pose;
using draw::Real;
using draw::Vec;
using engine::Answer;
using engine::Method;

// JSON has no infinities.
Json number(double x) {
  if (std::isnan(x)) return nullptr;
  if (std::isinf(x)) return x > 0 ? "inf" : "-inf";
  return x;
}
Json triple(const Vec3<double>& x) { return {x[0], x[1], x[2]}; }
Json triple(const Vec& x) { return triple(Vec3<double>(x.cast<double>())); }
Json interval(double lower, double upper) { return {{"lower", number(lower)}, {"upper", number(upper)}}; }
Json enclosure(const oracle::Enclosure& x) { return interval(x.low, x.high); }

struct ShapeName {
  const char* operator()(const Point<double>&) const { return "point"; }
  const char* operator()(const Segment<double>&) const { return "segment"; }
  const char* operator()(const Triangle<double>&) const { return "triangle"; }
  const char* operator()(const Sphere<double>&) const { return "sphere"; }
  const char* operator()(const Capsule<double>&) const { return "capsule"; }
  const char* operator()(const Box<double>&) const { return "box"; }
  const char* operator()(const Ellipsoid<double>&) const { return "ellipsoid"; }
  const char* operator()(const Cylinder<double>&) const { return "cylinder"; }
  const char* operator()(const Cone<double>&) const { return "cone"; }
  const char* operator()(const Hull<double>&) const { return "hull"; }
  const char* operator()(const Posed<double>& posed) const { return std::visit(*this, posed.shape->shape); }
  const char* operator()(const Rounded<double>&) const { return "rounded"; }
  const char* operator()(const Sum<double>&) const { return "sum"; }
  const char* operator()(const HullOf<double>&) const { return "hull_of"; }
};

std::string label_of(const Method& method) { return method.is_ours() ? method.question_name() : method.name; }

// A method's answer and its judgement, or the reason why it is not judged.
struct Judged {
  Answer answer;
  std::optional<law::Judgement> judgement = {};
  std::string unjudged = {};
};
//
// The judge accepts every answer of a method without a guarantee. Here its answers are held to visible errors.
constexpr double kSeen = 1e-6;  // over scale

Judged ask_and_judge(const Method& asked, const Case& problem) {
  Method method = asked;
  engine::Guarantee held;
  if (asked.guarantee == nullptr || asked.guarantee->is_open) {
    if (asked.guarantee != nullptr) held = *asked.guarantee;
    held.is_open = false;
    held.relative_tolerance = kSeen;
    method.guarantee = &held;
  }
  const Request request = method.is_ours() ? Request::everything : engine::kPlain;
  Judged judged{.answer = method.ask(problem, {.request = request})};
  const Case seen = method.seen(problem);
  if (!law::in_domain(seen)) {
    judged.unjudged = "outside the range that is judged";
    return judged;
  }
  try {
    law::Truth truth(seen);
    judged.judgement = law::judge(truth, method, judged.answer, request, true);
  } catch (const std::invalid_argument& refused) {
    judged.unjudged = refused.what();
  }
  return judged;
}

class Document {
 public:
  Document(const Case& problem, const SceneSettings& settings)
      : problem_(problem), settings_(settings), scene_(draw::make_scene(problem)), truth_(problem) {}

  Json operator()(std::span<const Method* const> claimed) {
    out_ = {{"schema", "graze.shown/1"},
            {"id", problem_.id},
            {"family", problem_.family},
            {"comment", problem_.comment},
            {"source", problem_.source},
            {"query", corpus::name_of(problem_.query)},
            {"case", corpus::write_case(problem_)},
            {"command", settings_.command},
            {"result", scene_.result}};
    if (problem_.hardness) out_["hardness"] = *problem_.hardness;
    out_["drawable"] = scene_.drawable;
    if (!scene_.drawable) return std::move(out_);
    geometry();
    truth();
    reference();
    Json answers = Json::array();
    for (const Method* method : claimed) {
      if (takes(*method, problem_)) answers.push_back(answer_json(*method));
    }
    out_["answers"] = std::move(answers);
    if (settings_.has_still) out_["still"] = draw::draw_svg(problem_);
    return std::move(out_);
  }

 private:
  [[nodiscard]] bool is_cast() const { return problem_.query == corpus::Query::cast; }
  [[nodiscard]] Pose at(bool is_b, Real t) const {
    return is_b ? scene_.pose_b(t, Vec::Zero()) : scene_.pose_a(t, Vec::Zero());
  }
  [[nodiscard]] Vec relative(const Vec3<double>& world) const { return world.cast<Real>() - scene_.origin; }

  Json body(bool is_b) const {
    const Body<double>& body = is_b ? problem_.b : problem_.a;
    const corpus::Spin& spin = is_b ? problem_.spin_b : problem_.spin_a;
    const Pose then = at(is_b, scene_.moment), start = at(is_b, 0);
    const Vec outward = is_b ? Vec(-scene_.normal) : scene_.normal;
    // As fine at the contact as the length that the case hangs on asks for: a hundredth of it can be seen.
    const auto diagonal = static_cast<double>(is_b ? scene_.diagonal_b : scene_.diagonal_a);
    const double seen = 0.01 * static_cast<double>(scene_.margin.value_or(scene_.scale / 1000));
    const Grid grid = {32, 16, rings_for(seen, diagonal)};
    Eigen::Quaternion<Real> turn(start.rotation);
    turn.normalize();
    return {{"shape", std::visit(ShapeName(), body.shape)},
            {"position", triple(start.position)},
            {"orientation",
             {static_cast<double>(turn.w()), static_cast<double>(turn.x()), static_cast<double>(turn.y()),
              static_cast<double>(turn.z())}},
            {"displacement", triple(body.displacement)},
            {"rotation", triple(spin.rotation)},
            {"pivot", triple(spin.pivot)},
            {"diagonal", diagonal},
            {"touching", triple(is_b ? scene_.touching_b : scene_.touching_a)},
            {"mesh", mesh_json(mesh_of(body.shape, then.rotation.transpose() * outward, grid))}};
  }

  void geometry() {
    const draw::View view = draw::make_view(scene_, {});
    out_["origin"] = triple(scene_.origin);
    out_["scale"] = static_cast<double>(scene_.scale);
    out_["t_max"] = number(problem_.t_max);
    out_["target_distance"] = problem_.target_distance;
    out_["turns"] = scene_.turns;
    out_["contact"] = scene_.has_contact;
    out_["moment"] = static_cast<double>(scene_.moment);
    out_["end"] = static_cast<double>(scene_.end);
    out_["focus"] = triple(scene_.focus);
    out_["normal"] = triple(scene_.normal);
    out_["view"] = {
        {"right", triple(view.right)}, {"up", triple(view.up)}, {"towards", triple(view.towards)}};
    if (scene_.margin)
      out_["margin"] = {{"name", scene_.margin_name}, {"length", static_cast<double>(*scene_.margin)}};
    out_["a"] = body(false);
    out_["b"] = body(true);
    // For rotating bodies, C depends on the time. It is shown at the moment.
    const Real when = scene_.turns ? scene_.moment : Real(0);
    Mesh difference = mesh_of_difference(problem_.a.shape, at(false, when), problem_.b.shape, at(true, when),
                                         problem_.target_distance, scene_.normal);
    // The creases of a sampled difference are where samples happen to lie.
    if (difference.curved) difference.edges.clear();
    out_["cso"] = {{"time", static_cast<double>(when)}, {"mesh", mesh_json(difference)}};
  }

  void truth() {
    if (!is_cast()) return;
    try {
      if (scene_.turns) {
        const oracle::RotatingTruth& true_one = truth_.bracket();
        put_truth(true_one, "a proved bracket, in ball arithmetic");
      } else {
        const oracle::CaseTruth& true_one = truth_.cast();
        put_truth(true_one,
                  true_one.is_exact() ? "the exact oracle" : "a proved bracket, in ball arithmetic");
      }
    } catch (const std::invalid_argument& refused) {
      out_["truth"] = {{"outcome", nullptr},
                       {"by", std::string("no oracle takes the case: ") + refused.what()}};
    }
  }
  template <class T>
  void put_truth(const T& true_one, const char* by) {
    const Outcome outcome = true_one.outcome();
    out_["truth"] = {{"outcome", corpus::name_of(outcome)},
                     {"toi", interval(true_one.toi_lower(), true_one.toi_upper())},
                     {"by", by}};
    if (outcome == Outcome::miss) out_["truth"]["clearance"] = enclosure(true_one.clearance());
    if (outcome == Outcome::hit) out_["truth"]["depth"] = enclosure(true_one.depth());
  }

  // Our answer with the strongest proof, and the checker's result.
  void reference() {
    if (!is_cast()) return;
    const Method* method =
        scene_.turns ? engine::find_method(engine::Kind::rotating, "certified")
                     : engine::find_method(engine::Kind::linear,
                                           engine::is_exact_question(problem_) ? "exact" : "certified");
    if (method == nullptr) return;
    const Answer answer = method->ask(problem_, {.request = Request::everything});
    out_["reference"] = plain_answer(*method, answer);
    if (answer.proof) out_["proof"] = linear_proof(*method, *answer.proof);
    if (answer.rotating_proof) out_["proof"] = rotating_proof(*method, *answer.rotating_proof);
  }

  Json linear_proof(const Method& method, const Proof& proof) const {
    const oracle::Verdict verdict = oracle::check_proof(problem_, proof);
    const Vec velocity = problem_.b.displacement.cast<Real>() - problem_.a.displacement.cast<Real>();
    const Pose a = at(false, 0), b = at(true, 0);
    const Vec axis = axis_of(proof, problem_.a.shape, a, problem_.b.shape, b, velocity);
    std::vector<Vec> corners;
    for (int k = 0; k < proof.portal_size; ++k)
      corners.push_back(
          difference_of(proof.portal[static_cast<std::size_t>(k)], problem_.a.shape, a, problem_.b.shape, b));
    // Corners of the cores are shown on C, along the axis from where they are.
    if (proof.of_cores && proof.has_axis && !corners.empty()) {
      const Vec top =
          a.position + a.rotation * draw::support_point(problem_.a.shape, a.rotation.transpose() * axis) -
          (b.position + b.rotation * draw::support_point(problem_.b.shape, -(b.rotation.transpose() * axis)));
      Real highest = axis.dot(corners.front());
      for (const Vec& corner : corners) highest = std::max(highest, axis.dot(corner));
      const Real lift = axis.dot(top) + Real(problem_.target_distance) - highest;
      for (Vec& corner : corners) corner += lift * axis;
    }
    Json portal = Json::array();
    for (const Vec& corner : corners) portal.push_back(triple(corner));
    return {{"kind", "linear"},
            {"by", method.full_name()},
            {"accepted", verdict.accepted()},
            {"refusal", verdict.detail},
            {"claims", interval(proof.toi_lower, proof.toi_upper)},
            {"axis", triple(axis)},
            {"symbolic", proof.symbolic},
            {"portal", portal}};
  }

  Json rotating_proof(const Method& method, const RotatingProof& proof) const {
    const oracle::RotatingVerdict verdict = oracle::check_rotating_proof(problem_, proof);
    Json chain = Json::array();
    // Evenly thinned. Each one that is kept is drawn within its own slice only.
    const std::size_t step =
        (proof.chain.size() + settings_.most_chain - 1) / std::max<std::size_t>(1, settings_.most_chain);
    double begin = 0;
    for (std::size_t k = 0; k < proof.chain.size(); ++k) {
      const TimeSlice& slice = proof.chain[k];
      if (step == 0 || k % step == 0 || k + 1 == proof.chain.size()) {
        chain.push_back({{"begin", number(begin)},
                         {"end", number(slice.end)},
                         {"axis", triple(slice.axis)},
                         {"frame", to_text(slice.frame)}});
      }
      begin = slice.end;
    }
    return {{"kind", "rotating"},
            {"by", method.question_name()},
            {"accepted", verdict.accepted()},
            {"refusal", verdict.detail},
            {"claims", interval(proof.toi_lower, proof.toi_upper)},
            {"slices", proof.chain.size()},
            {"crossing", proof.crossing},
            {"chain", chain}};
  }

  Json plain_answer(const Method& method, const Answer& answer) const {
    Json out = {{"label", label_of(method)},
                {"scalar", method.scalar},
                {"tier", method.tier},
                {"ours", method.is_ours()}};
    if (answer.failure != engine::Failure::none) {
      out["outcome"] = to_text(answer.failure);
      out["failed"] = true;
      out["message"] = answer.message;
      return out;
    }
    out["outcome"] = answer.declined ? "declined" : std::string(corpus::name_of(answer.outcome));
    const bool has_time = answer.outcome == Outcome::hit || answer.outcome == Outcome::not_converged ||
                          answer.outcome == Outcome::initially_overlapping;
    if (is_cast() && has_time) out["toi"] = interval(answer.toi_lower, answer.toi_upper);
    if (answer.separation) out["distance"] = interval(answer.separation->lower, answer.separation->upper);
    if (answer.depth) out["depth"] = interval(answer.depth->lower, answer.depth->upper);
    if (answer.t_in) out["t_in"] = interval(answer.t_in->lower, answer.t_in->upper);
    if (answer.t_out) out["t_out"] = interval(answer.t_out->lower, answer.t_out->upper);
    if (answer.has_normal()) out["normal"] = triple(answer.normal);
    if (answer.outcome == Outcome::hit && method.holds.witnesses) {
      out["point_a"] = triple(relative(answer.point_a));
      out["point_b"] = triple(relative(answer.point_b));
      out["world_a"] = triple(answer.point_a);
      out["world_b"] = triple(answer.point_b);
    }
    if (!answer.message.empty()) out["message"] = answer.message;
    out["supports"] = answer.counters.supports;
    return out;
  }

  Json answer_json(const Method& method) const {
    const Judged judged = ask_and_judge(method, problem_);
    Json out = plain_answer(method, judged.answer);
    if (!judged.judgement) {
      out["unjudged"] = judged.unjudged;
      return out;
    }
    const law::Judgement& judgement = *judged.judgement;
    out["fault"] = judgement.fault();
    for (const law::FaultKind& kind : law::kFaultKinds) {
      if (!(judgement.*kind.why).empty()) out["faults"].push_back(kind.name);
    }
    out["promises"] = method.guarantee != nullptr && !method.guarantee->is_open;
    out["stalled"] = judgement.stalled;
    out["excused"] = judgement.within_tolerance;
    const law::Errors& errors = judgement.errors;
    out["errors"] = {{"forward", number(errors.forward)}, {"backward", number(errors.backward)},
                     {"normal", number(errors.normal)},   {"witness", number(errors.witness)},
                     {"passed", number(errors.passed)},   {"over_limit", number(errors.over_limit)}};
    return out;
  }

  const Case& problem_;
  const SceneSettings& settings_;
  draw::Scene scene_;
  law::Truth truth_;
  Json out_;
};

}  // namespace

std::string generating_command(const Case& problem) {
  const corpus::Family* family = corpus::find_family(problem.family);
  const std::size_t place = problem.id.rfind("/s");
  if (family == nullptr || !problem.hardness || place == std::string::npos) return "";
  const std::string seed = problem.id.substr(place + 2);
  if (seed.empty() || seed.size() > 19 || seed.find_first_not_of("0123456789") != std::string::npos)
    return "";
  if (!corpus::same_case(problem, family->generate(*problem.hardness, std::stoull(seed)))) return "";
  return fmt::format("graze generate {} --hardness {} --seed {} --count 1", problem.family, *problem.hardness,
                     seed);
}

bool takes(const Method& method, const Case& problem) {
  if (method.query != problem.query) return false;
  if (method.refuses != nullptr && !method.refuses(problem).empty()) return false;
  if (problem.query != corpus::Query::cast) return true;
  if (method.is_exact() && !engine::is_exact_question(method.seen(problem))) return false;
  const bool turns = engine::turns(problem);
  return method.kind == (turns ? engine::Kind::rotating : engine::Kind::linear);
}

std::vector<Claim> claims_of(const Case& problem, std::span<const Method* const> methods) {
  std::vector<Claim> claims;
  for (const Method* method : methods) {
    if (!takes(*method, problem)) continue;
    const Judged judged = ask_and_judge(*method, problem);
    const Answer& answer = judged.answer;
    Claim claim;
    const bool has_answer = answer.failure == engine::Failure::none && !answer.declined;
    claim.words = fmt::format("{}: {}", label_of(*method),
                              answer.failure != engine::Failure::none ? to_text(answer.failure)
                              : answer.declined                       ? "declined"
                                                                      : corpus::name_of(answer.outcome));
    if (has_answer && (answer.outcome == Outcome::hit || answer.outcome == Outcome::not_converged) &&
        problem.query == corpus::Query::cast) {
      claim.words += fmt::format(" at t = {}", answer.toi_lower);
      claim.time = answer.toi_lower;
    }
    if (judged.judgement) {
      claim.is_wrong = judged.judgement->faulty();
      claim.words += claim.is_wrong ? ": " + judged.judgement->fault() : ", within its limit";
    }
    claims.push_back(std::move(claim));
  }
  return claims;
}

Json scene_of(const Case& problem, std::span<const Method* const> claimed, const SceneSettings& settings) {
  return Document(problem, settings)(claimed);
}

}  // namespace graze::show
