#include "scene/format/report_json.hpp"

#include "corpus/format/json_value.hpp"
#include "corpus/format/proof_io.hpp"
#include "corpus/format/shape_json.hpp"

namespace graze::scene {
namespace {

using corpus::json_number;
using corpus::json_quote;

std::string field(const char* key, const std::string& value) {
  return std::string(", \"") + key + "\": " + value;
}
std::string text_field(const char* key, std::string_view value) { return field(key, json_quote(value)); }

std::string reasons_text(std::uint16_t reasons) {
  std::string text;
  for (int k = 0; k < kPlanReasons; ++k) {
    if ((reasons >> k & 1) == 0) continue;
    text += (text.empty() ? "" : ", ") + json_quote(to_text(static_cast<PlanReason>(k)));
  }
  return "[" + text + "]";
}

std::string event_text(const Event& event, const std::string& a, const std::string& b, const char* key_of_a,
                       Request request) {
  std::string text = std::string("{\"") + key_of_a + "\": " + json_quote(a) + text_field("b", b);
  text += text_field("outcome", to_text(event.outcome));
  text += field("toi", "{\"lower\": " + json_number(event.toi_lower) +
                           ", \"upper\": " + json_number(event.toi_upper) + "}");
  text += field("distance", json_number(event.distance));
  if (event.outcome == Outcome::hit && asks_for(request, Request::normal)) {
    text += field("normal", corpus::write_vec3(event.normal));
  }
  if (event.outcome == Outcome::hit && asks_for(request, Request::witnesses)) {
    text += field("point_a", corpus::write_vec3(event.point_a)) +
            field("point_b", corpus::write_vec3(event.point_b));
  }
  return text + text_field("simulated", to_text(event.effects)) +
         field("because", reasons_text(event.reasons)) + "}";
}

std::string counts_text(const Counts& counts) {
  std::string text = "{\"bodies\": " + std::to_string(counts.bodies);
  const auto number = [&](const char* key, std::uint64_t value) {
    text += field(key, std::to_string(value));
  };
  number("resting", counts.resting);
  number("turning", counts.turning);
  number("pairs", counts.pairs);
  number("filtered", counts.filtered);
  number("apart", counts.apart);
  number("never_meet", counts.never_meet);
  number("moot", counts.moot);
  number("unfinished", counts.unfinished);
  number("shortened", counts.shortened);
  std::string effects, reasons;
  for (std::size_t k = 0; k < counts.effects.size(); ++k) {
    effects += (k > 0 ? ", " : "") + json_quote(to_text(static_cast<Effects>(k))) + ": " +
               std::to_string(counts.effects[k]);
  }
  for (std::size_t k = 0; k < counts.reasons.size(); ++k) {
    if (counts.reasons[k] == 0) continue;
    reasons += (reasons.empty() ? "" : ", ") + json_quote(to_text(static_cast<PlanReason>(k))) + ": " +
               std::to_string(counts.reasons[k]);
  }
  text += field("simulated", "{" + effects + "}") + field("because", "{" + reasons + "}");
  number("probes", counts.probes);
  number("probe_casts", counts.probe_casts);
  number("probe_moot", counts.probe_moot);
  return text + "}";
}

std::string head_text(const Document& document) {
  return "{\"schema\": \"graze.events/1\"" + text_field("id", document.id) +
         text_field("tier", to_text(document.options.tier)) +
         text_field("ask", to_text(document.options.ask)) +
         field("t_max", json_number(document.options.t_max)) +
         field("target_distance", json_number(document.options.target_distance));
}

template <class Items, class Write>
std::string list_text(const Items& items, const Write& write) {
  std::string text;
  for (const auto& item : items) {
    if (!text.empty()) text += ", ";
    text += write(item);
  }
  return "[" + text + "]";
}

std::string named(const std::string& name, const RotatingBody<double>& moving) {
  const std::string body = corpus::write_body(moving.body, {moving.rotation, moving.pivot});
  return "{\"name\": " + json_quote(name) + ", " + body.substr(1, body.size() - 2);
}

}  // namespace

std::string write_report(const Document& document, const Report& report) {
  const Scene& scene = document.scene;
  const Request request = document.options.request;
  std::string text = head_text(document) + text_field("status", to_text(report.status));
  text += field("bodies", list_text(scene.bodies, [](const Member& member) {
                  return named(member.name, member.body) + "}";
                }));
  text += field("probes", list_text(scene.probes, [](const Probe& probe) {
                  return named(probe.name, probe.body) + field("t_max", json_number(probe.t_max)) + "}";
                }));
  text +=
      field("events", list_text(report.events, [&](const Event& event) {
              return event_text(event, scene.bodies[event.a].name, scene.bodies[event.b].name, "a", request);
            }));
  text += field("probe_events", list_text(report.probe_events, [&](const Event& event) {
                  return event_text(event, scene.probes[event.a].name, scene.bodies[event.b].name, "probe",
                                    request);
                }));
  return text + field("plan", counts_text(report.counts)) + "}";
}

std::string write_plan(const Document& document, const Planned& planned) {
  const Scene& scene = document.scene;
  std::string text = head_text(document) + field("plan", counts_text(planned.counts));
  text += field("pairs", list_text(planned.pairs, [&](const PairPlan& pair) {
                  return "{\"a\": " + json_quote(scene.bodies[pair.a].name) +
                         text_field("b", scene.bodies[pair.b].name) +
                         text_field("simulated", to_text(pair.plan.effects)) +
                         field("because", reasons_text(pair.plan.reasons)) +
                         field("begin", json_number(pair.begin)) + "}";
                }));
  return text + "}";
}

std::string write_event_proof(const Document& document, const Event& event, bool of_probe) {
  const Scene& scene = document.scene;
  const RotatingBody<double>& b = scene.bodies[event.b].body;
  const RotatingBody<double>& a = of_probe ? scene.probes[event.a].body : scene.bodies[event.a].body;
  corpus::ProofRecord record;
  corpus::Case& problem = record.problem;
  problem.id =
      document.id + (of_probe ? "/probe-" : "/") + std::to_string(event.a) + "-" + std::to_string(event.b);
  problem.a = a.body;
  problem.spin_a = {a.rotation, a.pivot};
  problem.b = b.body;
  problem.spin_b = {b.rotation, b.pivot};
  if (of_probe) {
    problem.b.displacement = problem.spin_b.rotation = Vec3<double>::Zero();
  }
  problem.t_max = of_probe ? scene.probes[event.a].t_max : document.options.t_max;
  problem.target_distance = document.options.target_distance;
  record.method = "scene";
  record.scalar = "double";
  record.tier = document.options.tier;
  record.outcome = event.outcome;
  record.toi = corpus::StatedBracket{event.toi_lower, event.toi_upper};
  if (event.proof->linear) record.proof = *event.proof->linear;
  record.rotating = event.proof->rotating;
  return corpus::write_proof(record);
}

}  // namespace graze::scene
