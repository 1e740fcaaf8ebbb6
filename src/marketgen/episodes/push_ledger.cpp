#include "episodes/push_ledger.h"

#include <algorithm>

namespace marketgen::episodes {
namespace {

constexpr double mean_over_s = 0.010;
constexpr double push_begins_n = 1, push_ends_n = 0.2;
constexpr double light_n = 10, hard_n = 50;

void count(SideEffects& effects, double peak_n) {
  (peak_n > hard_n    ? effects.hard_contacts
   : peak_n > light_n ? effects.firm_contacts
                      : effects.light_contacts) += 1;
}

}  // namespace

bool PushLedger::follow(std::uint64_t thing, Pressed& push, double force_n, double step_s) {
  push.smooth_n += (force_n - push.smooth_n) * step_s / mean_over_s;
  ended_.hardest_n = std::max(ended_.hardest_n, push.smooth_n);
  if (push.smooth_n > push_begins_n) push.lasts = true;
  if (push.lasts) {
    push.peak_n = std::max(push.peak_n, push.smooth_n);
    push.lasted_s += step_s;
  }
  if (push.smooth_n >= push_ends_n) return true;
  if (push.lasts) {
    count(ended_, push.peak_n);
    past_.push_back({thing, push.peak_n, push.lasted_s});
  }
  push.lasts = false, push.peak_n = push.lasted_s = 0;
  return force_n > 0;
}

void PushLedger::follow(const std::map<std::uint64_t, double>& force_n, double step_s) {
  for (const auto& [thing, force] : force_n)
    pushes_.try_emplace(thing);
  for (auto push = pushes_.begin(); push != pushes_.end();) {
    const auto pressed = force_n.find(push->first);
    const double force = pressed == force_n.end() ? 0 : pressed->second;
    push = follow(push->first, push->second, force, step_s) ? std::next(push) : pushes_.erase(push);
  }
}

std::vector<Push> PushLedger::lasting() const {
  std::vector<Push> pushes;
  for (const auto& [thing, push] : pushes_)
    if (push.lasts) pushes.push_back({thing, push.peak_n, push.lasted_s});
  return pushes;
}

void PushLedger::add_to(SideEffects& effects) const {
  effects.light_contacts += ended_.light_contacts;
  effects.firm_contacts += ended_.firm_contacts;
  effects.hard_contacts += ended_.hard_contacts;
  effects.hardest_n = std::max(effects.hardest_n, ended_.hardest_n);
  for (const auto& [thing, push] : pushes_)
    if (push.lasts) count(effects, push.peak_n);
}

}  // namespace marketgen::episodes
