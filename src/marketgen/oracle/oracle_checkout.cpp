#include "oracle/oracle_checkout.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/progress.h"

#include "oracle/oracle_grasps.h"
#include "oracle/oracle_places.h"
#include "oracle/oracle_tries.h"
#include "skills/basket_moves.h"
#include "skills/hand_reach.h"

namespace marketgen::oracle {
namespace {

constexpr std::size_t max_grasps = 24;  // of which postures are sought
constexpr std::size_t max_plans = 6;    // of an item at a time
constexpr std::size_t max_places = 8;
constexpr std::size_t max_place_searches = 12;  // for the grasps of an item at a time
constexpr double settle_s = 0.25, open_s = 0.35;
constexpr double let_go_m = 0.014;     // wider than what was held
constexpr double lowest_rim_m = 0.03;  // over which it is lifted off the counter
constexpr double escape_m = 0.12, home_approach_m = 0.02;
constexpr double min_time_s = 8;  // no new grasp with less time left

enum class Phase { choose, closed, lifted, over_place, released };

// clear: nothing is in the way of the hand, nor lies over the item. free: of the hand only.
enum class Ease { clear, free, any };

class CheckoutOracle : public agent::Policy {
 public:
  CheckoutOracle(const episodes::CheckoutWorld& world,
                 robots::GraspTool tool,
                 skills::ArmExecutor arm,
                 Seed seed)
      : world_(world), tool_(std::move(tool)), arm_(std::move(arm)), seed_(seed) {}

  Result<void> begin(const agent::Task& task, const agent::Observation& first) override {
    task_ = task;
    scene_ = std::make_unique<OracleScene>(world_, tool_);
    arm_.start(first);
    home_ = arm_.tip();
    phase_ = Phase::choose;
    say("begins " + world_.spec().id);
    return {};
  }

  Result<agent::Action> act(const agent::Observation& now) override {
    now_ = now;
    arm_.hold(now.openings_m.front());
    if (arm_.idle()) MARKETGEN_CHECK(decide());
    agent::Action action = arm_.next(now);
    action.stop = done_;
    return action;
  }

  std::string failure() const override { return std::string(name_of(failure_)); }

 private:
  // The arm or what it holds was pressed on, and has been moved back a second of its way: what was
  // planned is given up, and goes on from here by another plan.
  Result<void> recover() {
    say("was stopped");
    note(episodes::FailureCode::collision);
    if (arm_.presses() && holds_it()) {
      phase_ = Phase::lifted;
      return scene_->in_basket(item_) ? lift() : put_down();
    }
    if (phase_ == Phase::closed) tried_.fail(item_, product_from_tip_);
    phase_ = Phase::released;
    return choose();
  }

  Result<void> decide() {
    if (arm_.take_stop()) return recover();
    switch (phase_) {
      case Phase::choose:
      case Phase::released:
        return choose();
      case Phase::closed:
        return lift();
      case Phase::lifted:
        return put_down();
      case Phase::over_place:
        return lower();
    }
    return {};
  }

  // ---- What to take next ----

  // Targets that are not there yet or fell there, and what is there and should not be.
  bool is_due(std::size_t item) const {
    const bool there = scene_->in_unloading(item);
    if (!scene_->is_target(item)) return there;
    return !there || world_.watched(item).impact_m_s > episodes::max_impact_m_s;
  }

  Result<void> choose() {
    std::vector<std::size_t> due;
    for (std::size_t item = 0; item < scene_->items(); ++item)
      if (is_due(item)) due.push_back(item);
    if (due.empty()) {
      failure_ = episodes::FailureCode::none;
      done_ = true;
      return {};
    }
    if (now_.time_s + min_time_s > task_.limit_s) {
      failure_ = episodes::FailureCode::timeout;
      done_ = true;
      return {};
    }
    grasps_.clear();
    return take_first(due);
  }

  // Of the item as everything lies now. Looked for once while the item lies still.
  Result<const ItemGrasps*> grasps_of(std::size_t item) {
    if (const auto found = grasps_.find(item); found != grasps_.end()) return &found->second;
    const Pose pose = world_.item_pose(item);
    const auto kept = lone_.find(item);
    if (kept == lone_.end() || !same_place(kept->second.pose, pose)) {
      MARKETGEN_TRY(std::vector<motion::GraspCandidate> found, lone_grasps(*scene_, item));
      lone_[item] = {pose, std::move(found)};
    }
    return &grasps_.emplace(item, item_grasps(*scene_, item, lone_[item].found)).first->second;
  }

  static bool same_place(const Pose& a, const Pose& b) {
    constexpr double same_m = 0.0005, same_turn = 0.003;
    const Quaternion turn = inverse(a.rotation) * b.rotation;
    return length(a.position - b.position) < same_m &&
           std::hypot(turn.x, turn.y, turn.z) < same_turn;
  }

  // What is due and free; then what blocks it; then whatever is free, nearest first; then what is
  // due though something lies over it or beside it.
  Result<void> take_first(std::vector<std::size_t> due) {
    for (const std::size_t item : due)
      MARKETGEN_CHECK(checked(grasps_of(item)));
    std::ranges::stable_sort(due, std::greater<>{}, [&](std::size_t item) {
      const auto& choices = grasps_.at(item).choices;
      return choices.empty() ? -1e9 : choices.front().score;
    });
    const std::vector<std::size_t> blockers = blockers_of(due), others = nearest_to(due);
    refused_.clear();
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
        if (begun) return {};
      }
    }
    if (escape()) return {};
    for (const std::size_t item : due)
      say(fmt::format(
          "gives up {}: {} grasps, {} in the way of the best, lies under {}",
          called(item),
          grasps_.at(item).choices.size(),
          grasps_.at(item).choices.empty() ? 0 : grasps_.at(item).choices.front().blockers.size(),
          grasps_.at(item).lies_under.size()));
    done_ = true;
    return {};
  }

  // Once between two grasps: the arm may touch something, even the counter, so that no way begins
  // where it is. Up, or back along the tool, as far as it can; or else to where it began.
  bool escape() {
    if (escaped_) return false;
    escaped_ = true;
    const Pose tip = arm_.tip();
    const skills::Surroundings counter = skills::counter_alone(scene_->place()), nothing;
    for (const skills::Surroundings* const around : {&counter, &nothing}) {
      for (const double by : {escape_m, escape_m * 0.7, escape_m * 0.4}) {
        const Pose up{tip.position + Vec3{0, 0, by}, tip.rotation},
            back = tip * Pose{{0, 0, -by}, {}};
        if (!arm_.straight(*around, up, tool_.opening_m, 20).ok() &&
            !arm_.straight(*around, back, tool_.opening_m, 20).ok())
          continue;
        say("moves away to get free");
        return true;
      }
    }
    skills::ReachRequest home{home_, {0, 0, home_approach_m}, tool_.opening_m};
    for (const skills::Surroundings* const around : {&counter, &nothing}) {
      if (!arm_.reach(*around, home, seed_.child("home", static_cast<std::uint64_t>(moves_++)))
               .ok())
        continue;
      say("goes to where it began");
      return true;
    }
    say("cannot move away");
    return false;
  }

  static Result<void> checked(const Result<const ItemGrasps*>& grasps) {
    return grasps.ok() ? Result<void>{} : Result<void>{grasps.error()};
  }

  Result<bool> take_if(std::size_t item, Ease how) {
    if (!tried_.may_take(item) || refused_.contains(item)) return false;
    MARKETGEN_TRY(const ItemGrasps* const grasps, grasps_of(item));
    if (how != Ease::any && !grasps->free()) return false;
    if (how == Ease::clear && !grasps->lies_under.empty()) return false;
    MARKETGEN_TRY(const bool begun, take(item));
    if (!begun) refused_.insert(item);
    return begun;
  }

  std::vector<std::size_t> blockers_of(const std::vector<std::size_t>& due) const {
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
  std::vector<std::size_t> nearest_to(const std::vector<std::size_t>& due) const {
    std::vector<std::size_t> others;
    for (std::size_t item = 0; item < scene_->items(); ++item)
      if (!scene_->is_target(item) && scene_->in_basket(item)) others.push_back(item);
    const Vec3 at = scene_->middle(due.front());
    std::ranges::stable_sort(
        others, {}, [&](std::size_t item) { return length(scene_->middle(item) - at); });
    return others;
  }

  // ---- Taking it ----

  void say(const std::string& what) const {
    log_debug(fmt::format("oracle {:.2f} s: {}", now_.time_s, what));
  }
  // Of a motion without which it goes on.
  void say_failed(std::string_view motion, const Result<void>& planned) const {
    if (!planned.ok()) say(fmt::format("cannot {}: {}", motion, to_string(planned.error())));
  }
  std::string called(std::size_t item) const {
    const episodes::EpisodeGoods& goods = world_.goods(item);
    return fmt::format("{}{} {} {} ({:.2f} kg)",
                       scene_->is_target(item) ? "target " : "other ",
                       item,
                       goods.product.archetype,
                       fmt::join(goods.product.size_mm, "x"),
                       goods.product.mass_kg);
  }

  // A grasp with which the item can be put down as well, or else any.
  Result<bool> take(std::size_t item) {
    note(grasps_.at(item).choices.empty() ? episodes::FailureCode::no_grasp
                                          : episodes::FailureCode::no_ik);
    for (const bool to_be_placed : {true, false}) {
      MARKETGEN_TRY(const bool begun, take(item, to_be_placed));
      if (begun) return true;
    }
    return false;
  }

  Result<bool> take(std::size_t item, bool to_be_placed) {
    const ItemGrasps& grasps = grasps_.at(item);
    const skills::Surroundings around = scene_->surroundings({});
    const std::vector<skills::PlacedBody> walls = scene_->walls();
    std::size_t plans = 0, searches = 0;
    for (std::size_t i = 0; i < std::min(grasps.choices.size(), max_grasps); ++i) {
      const GraspChoice& choice = grasps.choices[i];
      const std::vector<robots::ToolSolid> hand = skills::open_hand(tool_, choice.opening_m);
      for (const Pose& tip : skills::either_way_round(arm_, choice.base_from_tip)) {
        skills::ReachRequest request =
            skills::reach_over_rim(tip, scene_->rim_z_m(), choice.opening_m);
        request.force_n = skills::touch_n;
        if (tried_.failed_before(item, inverse(world_.item_pose(item)) * tip) ||
            !skills::is_reached(arm_, request, hand, walls))
          continue;
        if (to_be_placed && (searches++ >= max_place_searches ||
                             !has_place(*scene_, arm_, item, tip, choice.opening_m)))
          continue;
        if (plans++ >= max_plans) return false;
        const Seed seed = seed_.child("reach", static_cast<std::uint64_t>(moves_++));
        if (!arm_.reach(around, request, seed).ok()) {
          note(episodes::FailureCode::no_path);
          continue;
        }
        close_on(item, tip, choice);
        return true;
      }
    }
    return false;
  }

  void close_on(std::size_t item, const Pose& tip, const GraspChoice& choice) {
    skills::close_hand(arm_, choice.force_n);
    item_ = item;
    escaped_ = false;
    force_n_ = choice.force_n;
    product_from_tip_ = inverse(world_.item_pose(item)) * tip;
    const int tries = tried_.take(item);
    say(fmt::format("takes {}, try {}, tilt {:.0f}, {:.0f} N, score {:.1f}, {} blockers",
                    called(item),
                    tries,
                    skills::tilt_deg(tip.rotation),
                    choice.force_n,
                    choice.score,
                    choice.blockers.size()));
    phase_ = Phase::closed;
  }

  bool holds_it() const { return world_.watched(item_).held_by >= 0; }

  Result<void> lift() {
    if (!holds_it()) return let_go_for_good(episodes::FailureCode::missed);
    const Pose pose = world_.item_pose(item_);
    const Vec3 half = scene_->half_extents_at(item_, pose.rotation);
    const double lowest = scene_->box_middle(item_, pose).z - half.z;
    const skills::BasketSurroundings basket{
        scene_->surroundings({item_}),
        skills::counter_alone(scene_->place()),
        scene_->in_basket(item_) ? scene_->rim_z_m() : lowest_rim_m};
    const Vec3 middle = scene_->place().base_from_basket.position;
    if (!skills::lift_out(arm_, basket, lowest, middle, force_n_).ok())
      return let_go_for_good(episodes::FailureCode::no_path);
    arm_.wait(settle_s, 0, force_n_);
    phase_ = Phase::lifted;
    return {};
  }

  // And never takes it so again.
  Result<void> let_go_for_good(episodes::FailureCode why) {
    tried_.fail(item_, product_from_tip_);
    return let_go(why);
  }

  // Opens where it is, and goes back the way it came.
  Result<void> let_go(episodes::FailureCode why) {
    note(why);
    say(fmt::format("lets go of {}: {}", called(item_), name_of(why)));
    const double opening = std::min(tool_.opening_m, now_.openings_m.front() + let_go_m);
    arm_.wait(open_s, opening, force_n_);
    back_off(opening);
    phase_ = Phase::released;
    return {};
  }

  void back_off(double opening_m) {
    const skills::HandAt hand =
        scene_->in_basket(item_) ? skills::HandAt::basket : skills::HandAt::counter;
    const skills::BasketSurroundings basket{
        scene_->surroundings({}, hand), skills::counter_alone(scene_->place()), scene_->rim_z_m()};
    say_failed("raise the hand", skills::draw_back(arm_, basket, opening_m, force_n_));
  }

  // ---- Putting it down ----

  // Where it belongs, or else where it can be taken anew.
  Result<void> put_down() {
    if (!holds_it()) return let_go_for_good(episodes::FailureCode::slipped);
    const Pose tip_from_item = inverse(arm_.tip()) * world_.item_pose(item_);
    const double opening = now_.openings_m.front() + let_go_m;
    note(episodes::FailureCode::no_ik);
    places_.clear();
    in_area_ = scene_->is_target(item_);
    for (const bool in_area : {scene_->is_target(item_), false}) {
      if (!places_.empty()) break;
      const skills::HeldPack held = held_pack(*scene_, item_, tip_from_item, opening);
      places_ = skills::free_places(
          tool_, arm_, held, place_question(*scene_, item_, in_area), max_places);
      in_area_ = in_area;
    }
    next_place_ = 0;
    return go_over_place();
  }

  Result<void> go_over_place() {
    const Pose tip_from_item = inverse(arm_.tip()) * world_.item_pose(item_);
    const motion::AttachedObject held =
        skills::held_spheres(world_.robot(), world_.goods(item_).body, tip_from_item);
    const skills::Surroundings around = scene_->surroundings({item_}, skills::HandAt::counter);
    for (; next_place_ < 2 * places_.size(); ++next_place_) {
      const skills::FreePlace& place = places_[next_place_ % places_.size()];
      skills::ReachRequest request{place.base_from_tip, place.approach, 0, force_n_};
      request.stops_before = true;
      if (next_place_ < places_.size()) request.attached = {held};
      const Seed seed = seed_.child("place", static_cast<std::uint64_t>(moves_++));
      if (!arm_.reach(around, request, seed).ok()) {
        note(episodes::FailureCode::no_path);
        continue;
      }
      arm_.wait(settle_s, 0, force_n_);
      phase_ = Phase::over_place;
      return {};
    }
    return put_back();
  }

  // It may have turned in the hand on its way: the hand goes to where the item ends as planned.
  Result<void> lower() {
    if (!holds_it()) return let_go_for_good(episodes::FailureCode::slipped);
    const skills::FreePlace& place = places_[next_place_++ % places_.size()];
    const Pose item_from_tip = inverse(world_.item_pose(item_)) * arm_.tip();
    const skills::Surroundings around = scene_->surroundings({item_}, skills::HandAt::counter);
    for (const Pose& tip : {place.base_from_product * item_from_tip, place.base_from_tip}) {
      if (!arm_.straight(around, tip, 0, force_n_).ok()) continue;
      say(fmt::format(
          "puts {} down, place {}, in the area {}", called(item_), next_place_, in_area_));
      const double opening = std::min(tool_.opening_m, now_.openings_m.front() + let_go_m);
      arm_.wait(settle_s, 0, force_n_);
      arm_.wait(open_s, opening, force_n_);
      back_off(opening);
      if (in_area_ == scene_->is_target(item_)) tried_.put_down(item_);
      phase_ = Phase::released;
      return {};
    }
    return go_over_place();
  }

  // Down again to where it was, as far as that goes.
  Result<void> put_back() {
    say_failed("let it down to where it was",
               arm_.let_down(scene_->surroundings({item_}), force_n_));
    return let_go_for_good(failure_);
  }

  void note(episodes::FailureCode why) { failure_ = why; }

  const episodes::CheckoutWorld& world_;
  robots::GraspTool tool_;
  skills::ArmExecutor arm_;
  Seed seed_;
  agent::Task task_;
  std::unique_ptr<OracleScene> scene_;
  agent::Observation now_;
  Phase phase_ = Phase::choose;
  struct LoneGrasps {
    Pose pose;  // of the item, when they were looked for
    std::vector<motion::GraspCandidate> found;
  };
  std::map<std::size_t, LoneGrasps> lone_;
  std::map<std::size_t, ItemGrasps> grasps_;  // of this decision
  std::set<std::size_t> refused_;             // no way to them was found in this decision
  OracleTries tried_;
  std::size_t item_ = 0;  // that is being taken
  double force_n_ = 0;
  Pose home_;                              // of the tip, at the start
  Pose product_from_tip_;                  // as it was to be grasped
  std::vector<skills::FreePlace> places_;  // of the item in the hand
  std::size_t next_place_ = 0;             // first with what is held looked at, then again without
  bool in_area_ = false;                   // the places are where the item belongs
  int moves_ = 0;
  bool escaped_ = false;  // since the last grasp
  bool done_ = false;
  episodes::FailureCode failure_ = episodes::FailureCode::none;
};

}  // namespace

Result<std::unique_ptr<agent::Policy>> make_checkout_oracle(const episodes::CheckoutWorld& world,
                                                            const std::filesystem::path& data,
                                                            Seed seed) {
  MARKETGEN_TRY(robots::GraspTool tool, load_checkout_tool(world, data));
  MARKETGEN_TRY(skills::ArmExecutor arm, skills::ArmExecutor::make(world.robot()));
  return std::unique_ptr<agent::Policy>(
      std::make_unique<CheckoutOracle>(world, std::move(tool), std::move(arm), seed));
}

}  // namespace marketgen::oracle
