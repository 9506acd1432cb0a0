#include "corpus/workloads.hpp"

#include "corpus/workloads/workloads_list.hpp"

namespace graze::corpus {

void answer_question(Draw& draw, double place, Scene& scene, Case& problem) {
  // A kilometre away, on no axis.
  const Vec3<double> far = place > 0 ? Vec3<double>(640, -480, 600) : Vec3<double>(Vec3<double>::Zero());
  // Nothing here is an integer but the numbers of steps.
  if (draw.coordinates == Coordinates::integers) draw.coordinates = Coordinates::doubles;
  std::uint64_t passed = 0;
  for (;;) {
    Simulation world(draw, far);
    scene.set_up(world);
    for (int step = 0; step < scene.steps(); ++step) {
      scene.drive(world);
      std::vector<Case> questions = world.questions();
      if (draw.question < passed + questions.size()) {
        Case& asked = questions[draw.question - passed];
        problem.a = asked.a;
        problem.b = asked.b;
        problem.spin_a = asked.spin_a;
        problem.spin_b = asked.spin_b;
        problem.t_max = asked.t_max;
        problem.start_policy = asked.start_policy;
        return;
      }
      passed += questions.size();
      world.move();
    }
  }
}

std::span<const Family> workloads() {
#define GRAZE_WORKLOAD(name) workload::name,
  static const Family kWorkloads[] = {GRAZE_WORKLOADS(GRAZE_WORKLOAD)};
#undef GRAZE_WORKLOAD
  return kWorkloads;
}

}  // namespace graze::corpus
