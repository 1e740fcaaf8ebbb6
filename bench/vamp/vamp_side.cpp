#include "bench/vamp/vamp_side.h"

#include <vamp/collision/factory.hh>
#include <vamp/planning/rrtc.hh>
#include <vamp/planning/simplify.hh>
#include <vamp/planning/validate.hh>
#include <vamp/random/halton.hh>
#include <vamp/robots/panda.hh>

#include <algorithm>
#include <chrono>
#include <memory>

using Panda = vamp::robots::Panda;
static constexpr std::size_t rake = vamp::FloatVectorWidth;
using Environment = vamp::collision::Environment<vamp::FloatVector<rake>>;

VampAnswer vamp_solve(const std::vector<VampBox>& boxes,
                      const std::array<float, 7>& start,
                      const std::array<float, 7>& goal,
                      int calls) {
  vamp::collision::Environment<float> plain;
  for (const VampBox& box : boxes)
    plain.cuboids.emplace_back(
        vamp::collision::factory::cuboid::array(box.middle, {0, 0, 0}, box.half_size));
  plain.sort();
  const Environment world(plain);
  Panda::ConfigurationArray from_values, to_values;
  std::copy(start.begin(), start.end(), from_values.begin());
  std::copy(goal.begin(), goal.end(), to_values.begin());
  const Panda::Configuration from(from_values), to(to_values);
  const auto free = [&](const Panda::Configuration& q) {
    return vamp::planning::validate_motion<Panda, rake, Panda::resolution>(q, q, world);
  };
  VampAnswer answer;
  answer.asked = free(from) && free(to);
  answer.search_us = answer.simplify_us = 1e30;
  for (int call = 0; call < calls && answer.asked; ++call) {
    const auto rng = std::make_shared<vamp::rng::Halton<Panda>>();
    const auto t0 = std::chrono::steady_clock::now();
    const auto found = vamp::planning::RRTC<Panda, rake, Panda::resolution>::solve(
        from, to, world, vamp::planning::RRTCSettings{}, rng);
    const auto t1 = std::chrono::steady_clock::now();
    answer.solved = found.path.size() > 0;
    if (!answer.solved) break;
    const auto simple = vamp::planning::simplify<Panda, rake, Panda::resolution>(
        found.path, world, vamp::planning::SimplifySettings{}, rng);
    const auto t2 = std::chrono::steady_clock::now();
    using Microseconds = std::chrono::duration<double, std::micro>;
    answer.search_us = std::min(answer.search_us, Microseconds(t1 - t0).count());
    answer.simplify_us = std::min(answer.simplify_us, Microseconds(t2 - t1).count());
    answer.path.clear();
    for (const auto& q : simple.path) {
      const auto values = q.to_array();
      answer.path.emplace_back();
      std::copy_n(values.begin(), 7, answer.path.back().begin());
    }
  }
  return answer;
}
