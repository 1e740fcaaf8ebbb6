#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include <fmt/format.h>

#include "episodes/checkout/checkout_goals.h"
#include "oracle/checkout_oracle.h"
#include "oracle/oracle_places.h"
#include "oracle/rehearsal.h"
#include "skills/basket_moves.h"
#include "skills/hand_reach.h"

namespace marketgen::oracle {
namespace {

constexpr double escape_m = 0.12, home_approach_m = 0.02;
constexpr double min_time_s = 8;  // no new grasp with less time left

bool same_place(const Pose& a, const Pose& b) {
  constexpr double same_m = 0.0005, same_turn = 0.003;
  const Quaternion turn = inverse(a.rotation) * b.rotation;
  return length(a.position - b.position) < same_m && std::hypot(turn.x, turn.y, turn.z) < same_turn;
}

Result<void> checked(const Result<const ItemGrasps*>& grasps) {
  return grasps.ok() ? Result<void>{} : Result<void>{grasps.error()};
}

}  // namespace

// Targets that are not there yet or fell there, and what is there and should not be.
bool CheckoutOracle::is_due(std::size_t item) const {
  const bool there = scene_->in_unloading(item);
  if (!scene_->is_target(item)) return there;
  return !there || world_->watched(item).impact_m_s > episodes::max_impact_m_s;
}

Result<void> CheckoutOracle::choose() {
  if (is_rehearsal_) {  // what it rehearses is over
    memory_.done = true;
    return {};
  }
  std::vector<std::size_t> due;
  for (std::size_t item = 0; item < scene_->items(); ++item)
    if (is_due(item)) due.push_back(item);
  if (due.empty()) {
    memory_.failure = episodes::FailureCode::none;
    memory_.done = true;
    return {};
  }
  if (now_.time_s + min_time_s > task_.limit_s) {
    memory_.failure = episodes::FailureCode::timeout;
    memory_.done = true;
    return {};
  }
  grasps_.clear();
  refused_.clear();
  rehearsals_.clear();
  best_.reset();
  return take_first(due);
}

// Of the item as everything lies now. Looked for once while the item lies still.
Result<const ItemGrasps*> CheckoutOracle::grasps_of(std::size_t item) {
  if (const auto found = grasps_.find(item); found != grasps_.end()) return &found->second;
  const Pose pose = world_->item_pose(item);
  const auto kept = lone_.find(item);
  if (kept == lone_.end() || !same_place(kept->second.pose, pose)) {
    MARKETGEN_TRY(std::vector<motion::GraspCandidate> found, lone_grasps(*scene_, item));
    lone_[item] = {pose, std::move(found)};
  }
  return &grasps_.emplace(item, item_grasps(*scene_, item, lone_[item].found)).first->second;
}

// What is due and free; then what blocks it; then whatever is free, nearest first; then what is
// due though something lies over it or beside it.
Result<void> CheckoutOracle::take_first(std::vector<std::size_t> due) {
  for (const std::size_t item : due)
    MARKETGEN_CHECK(checked(grasps_of(item)));
  std::ranges::stable_sort(due, std::greater<>{}, [&](std::size_t item) {
    const auto& choices = grasps_.at(item).choices;
    return choices.empty() ? -1e9 : choices.front().score;
  });
  if (search_.other_order) std::ranges::reverse(due);
  MARKETGEN_TRY(const bool begun, take_any(due));
  if (begun) return {};
  if (best_) {
    memory_ = std::move(best_->begun);
    say(fmt::format("does so with harm of {}", best_->harm));
    return {};
  }
  if (!escape()) give_up(due);
  return {};
}

Result<bool> CheckoutOracle::take_any(const std::vector<std::size_t>& due) {
  const std::vector<std::size_t> blockers = blockers_of(due), others = nearest_to(due);
  const std::vector<std::pair<const std::vector<std::size_t>*, Ease>> stages{
      {&due, Ease::clear},
      {&blockers, Ease::clear},
      {&blockers, Ease::free},
      {&others, Ease::clear},
      {&due, Ease::any},
      {&others, Ease::free}};
  for (const auto& [items, how] : stages) {
    for (const std::size_t item : *items) {
      MARKETGEN_TRY(const bool begun, take_if(item, how));
      if (begun) return true;
    }
  }
  return false;
}

void CheckoutOracle::give_up(const std::vector<std::size_t>& due) {
  for (const std::size_t item : due)
    say(fmt::format(
        "gives up {}: {} grasps, {} in the way of the best, lies under {}",
        called(item),
        grasps_.at(item).choices.size(),
        grasps_.at(item).choices.empty() ? 0 : grasps_.at(item).choices.front().blockers.size(),
        grasps_.at(item).lies_under.size()));
  memory_.done = true;
}

// Once between two grasps: the arm may touch something, even the counter, so that no way begins
// where it is. Up, or back along the tool, as far as it can; or else to where it began.
bool CheckoutOracle::escape() {
  if (memory_.escaped) return false;
  memory_.escaped = true;
  memory_.arm.set_subtask(agent::Subtask::retreat);
  const Pose tip = memory_.arm.tip();
  const skills::Surroundings counter = skills::counter_alone(scene_->place()), nothing;
  for (const skills::Surroundings* const around : {&counter, &nothing}) {
    for (const double by : {escape_m, escape_m * 0.7, escape_m * 0.4}) {
      const Pose up{tip.position + Vec3{0, 0, by}, tip.rotation},
          back = tip * Pose{{0, 0, -by}, {}};
      if (!memory_.arm.straight(*around, up, skills::open_m(tool_), 20).ok() &&
          !memory_.arm.straight(*around, back, skills::open_m(tool_), 20).ok())
        continue;
      say("moves away to get free");
      return true;
    }
  }
  skills::ReachRequest home{home_, {0, 0, home_approach_m}, skills::open_m(tool_)};
  for (const skills::Surroundings* const around : {&counter, &nothing}) {
    if (!memory_.arm.reach(*around, home, next_seed("home")).ok()) continue;
    say("goes to where it began");
    return true;
  }
  say("cannot move away");
  return false;
}

Result<bool> CheckoutOracle::take_if(std::size_t item, Ease how) {
  if (!memory_.tried.may_take(item) || refused_.contains(item)) return false;
  MARKETGEN_TRY(const ItemGrasps* const grasps, grasps_of(item));
  if (how != Ease::any && !grasps->free()) return false;
  if (how == Ease::clear && !grasps->lies_under.empty()) return false;
  MARKETGEN_TRY(const bool begun, take(item));
  if (!begun) refused_.insert(item);
  return begun;
}

std::vector<std::size_t> CheckoutOracle::blockers_of(const std::vector<std::size_t>& due) const {
  std::vector<std::size_t> blockers;
  const auto add = [&](std::size_t item) {
    const bool stays = scene_->in_unloading(item) && scene_->is_target(item);
    if (!stays && std::ranges::find(blockers, item) == blockers.end()) blockers.push_back(item);
  };
  for (const std::size_t item : due) {
    const ItemGrasps& grasps = grasps_.at(item);
    for (const std::size_t over : grasps.lies_under)
      add(over);
    if (!grasps.choices.empty())
      for (const std::size_t beside : grasps.choices.front().blockers)
        add(beside);
  }
  return blockers;
}

// Other items in the basket.
std::vector<std::size_t> CheckoutOracle::nearest_to(const std::vector<std::size_t>& due) const {
  std::vector<std::size_t> others;
  for (std::size_t item = 0; item < scene_->items(); ++item)
    if (!scene_->is_target(item) && scene_->in_basket(item)) others.push_back(item);
  const Vec3 at = scene_->middle(due.front());
  std::ranges::stable_sort(
      others, {}, [&](std::size_t item) { return length(scene_->middle(item) - at); });
  return others;
}

// A grasp with which the item can be put down as well, or else any.
Result<bool> CheckoutOracle::take(std::size_t item) {
  note(grasps_.at(item).choices.empty() ? episodes::FailureCode::no_grasp
                                        : episodes::FailureCode::no_ik);
  for (const bool to_be_placed : {true, false}) {
    MARKETGEN_TRY(const bool begun, take(item, to_be_placed));
    if (begun) return true;
  }
  return false;
}

Result<bool> CheckoutOracle::take(std::size_t item, bool to_be_placed) {
  const ItemGrasps& grasps = grasps_.at(item);
  const skills::Surroundings around = scene_->surroundings({});
  const std::vector<skills::PlacedBody> walls = scene_->walls();
  std::size_t plans = 0, searches = 0;
  for (std::size_t i = 0; i < std::min(grasps.choices.size(), search_.max_grasps); ++i) {
    const GraspChoice& choice = grasps.choices[i];
    const std::vector<robots::ToolSolid> hand = skills::open_hand(tool_, choice.opening_m);
    for (const Pose& tip : skills::alike_ways(memory_.arm, choice.base_from_tip, tool_.kind)) {
      skills::ReachRequest request =
          skills::reach_over_rim(tip, scene_->rim_z_m(), choice.opening_m);
      request.force_n = skills::touch_n;
      if (memory_.tried.failed_before(item, inverse(world_->item_pose(item)) * tip, tool_.kind) ||
          !skills::is_reached(memory_.arm, request, hand, walls))
        continue;
      if (to_be_placed && (searches++ >= search_.max_place_searches ||
                           !has_place(*scene_, memory_.arm, item, tip, choice.opening_m)))
        continue;
      if (plans++ >= search_.max_plans || !may_rehearse(item)) return false;
      const Memory before = memory_;
      memory_.arm.set_subtask(agent::Subtask::reach);
      if (!memory_.arm.reach(around, request, next_seed("reach")).ok()) {
        note(episodes::FailureCode::no_path);
        continue;
      }
      close_on(item, tip, choice);
      MARKETGEN_TRY(const bool well, goes_well(item, before));
      if (well) return true;
      // Turned about its axis, a cup holds no better.
      if (tool_.kind == robots::ToolKind::suction) break;
    }
  }
  return false;
}

void CheckoutOracle::close_on(std::size_t item, const Pose& tip, const GraspChoice& choice) {
  skills::close_hand(memory_.arm, choice.force_n);
  memory_.item = item;
  memory_.escaped = memory_.placed = false;
  memory_.force_n = choice.force_n;
  memory_.product_from_tip = inverse(world_->item_pose(item)) * tip;
  const int tries = memory_.tried.take(item);
  say(fmt::format("takes {}, try {}, tilt {:.0f}, {:.0f} N, score {:.1f}, {} blockers",
                  called(item),
                  tries,
                  skills::tilt_deg(tip.rotation),
                  choice.force_n,
                  choice.score,
                  choice.blockers.size()));
  memory_.phase = Phase::closed;
}

// ---- Rehearsing it ----

bool CheckoutOracle::may_rehearse(std::size_t item) const {
  int all = 0;
  for (const auto& [of, count] : rehearsals_)
    all += count;
  const auto found = rehearsals_.find(item);
  return all < search_.max_rehearsals &&
         (found == rehearsals_.end() || found->second < search_.max_rehearsals_of_item);
}

// Whether what was begun may be carried out; if not, it is not begun, but kept when it did less
// harm than others.
Result<bool> CheckoutOracle::goes_well(std::size_t item, const Memory& before) {
  if (!search_.rehearses) return true;
  ++rehearsals_[item];
  MARKETGEN_TRY(const int harm, rehearse());
  if (harm == 0) return true;
  say(fmt::format("rehearsed with harm of {}", harm));
  if (!best_ || harm < best_->harm) best_ = Rehearsed{memory_, harm};
  memory_ = before;
  return false;
}

// What was begun is carried out in the twin, until something else is to be taken: physics repeats
// itself bit for bit, and so does the oracle, so that all of it will happen just so.
Result<int> CheckoutOracle::rehearse() {
  MARKETGEN_CHECK(twin_->restore(world_->save()));
  CheckoutOracle actor(*this);
  const int before = actor.harm();
  MARKETGEN_CHECK(rehearse_in(*twin_, actor));
  return actor.harm() - before + (actor.memory_.placed ? 0 : harm_of_not_placed);
}

int CheckoutOracle::harm() const {
  episodes::SideEffects effects = world_->watch().effects();
  effects.protective_stops = world_->controller().stops();
  const bool is_void = effects.basket_tilt_deg > episodes::max_tilt_deg;
  return harm_in(effects) + (is_void ? harm_of_void : 0);
}

}  // namespace marketgen::oracle
