#include "policy/oracle_checkout.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/progress.h"

#include "policy/oracle_grasps.h"
#include "policy/oracle_places.h"

namespace marketgen {
namespace {

constexpr int most_tries = 3;            // of an item where it lies
constexpr int most_takes = 6;            // of an item in all
constexpr std::size_t most_grasps = 24;  // of which postures are sought
constexpr std::size_t most_plans = 6;    // of an item at a time
constexpr std::size_t most_places = 8;
constexpr std::size_t most_place_searches = 12;  // for the grasps of an item at a time
constexpr double close_s = 0.6, firm_s = 0.2, settle_s = 0.25, open_s = 0.35;
// Of the pads until both of them touch: one alone pushes the item against what lies beside it.
constexpr double touch_n = 12;
// What failed once is not tried again so near by.
constexpr double same_grasp_m = 0.012, same_grasp_cosine = 0.96;
constexpr double let_go_m = 0.014;   // wider than what was held
constexpr double over_rim_m = 0.05;  // of what is lifted out
constexpr double retreat_m = 0.12;
constexpr double least_time_s = 8;  // no new grasp with less time left
constexpr double keep_off_basket_m = 0.03, keep_off_area_m = 0.02;

enum class Phase { choose, closed, lifted, over_place, released };

// clear: nothing is in the way of the hand, nor lies over the item. free: of the hand only.
enum class Ease { clear, free, any };

class CheckoutOracle : public Policy {
 public:
  CheckoutOracle(const CheckoutWorld& world, GraspTool tool, ArmExecutor arm, Seed seed)
      : world_(world), tool_(std::move(tool)), arm_(std::move(arm)), seed_(seed) {}

  Result<void> begin(const Task& task, const Observation& first) override {
    task_ = task;
    scene_ = std::make_unique<OracleScene>(world_, tool_);
    arm_.start(first);
    phase_ = Phase::choose;
    say("begins " + world_.spec().id);
    return {};
  }

  Result<Action> act(const Observation& now) override {
    now_ = now;
    if (arm_.idle()) MARKETGEN_CHECK(decide());
    Action action = arm_.next();
    action.stop = done_;
    return action;
  }

  std::string failure() const override { return std::string(name_of(failure_)); }

 private:
  Result<void> decide() {
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

  bool is_target(std::size_t item) const {
    const std::string& sku = world_.spec().items[item].sku;
    return std::ranges::count(world_.spec().goals, sku, &EpisodeGoal::sku) > 0;
  }

  // Targets that are not there yet or fell there, and what is there and should not be.
  bool is_due(std::size_t item) const {
    const bool there = scene_->in_unloading(item);
    if (!is_target(item)) return there;
    return !there || world_.watch().items()[item].impact_m_s > most_impact_m_s;
  }

  Result<void> choose() {
    std::vector<std::size_t> due;
    for (std::size_t item = 0; item < scene_->items(); ++item)
      if (is_due(item)) due.push_back(item);
    if (due.empty()) {
      failure_ = FailureCode::none;
      done_ = true;
      return {};
    }
    if (now_.time_s + least_time_s > task_.limit_s) {
      failure_ = FailureCode::timeout;
      done_ = true;
      return {};
    }
    grasps_.clear();
    return take_first(due);
  }

  bool may_try(std::size_t item) const {
    const auto tried = tries_.find(item), taken = takes_.find(item);
    return (tried == tries_.end() || tried->second < most_tries) &&
           (taken == takes_.end() || taken->second < most_takes);
  }

  bool failed_before(std::size_t item, const Pose& tip) const {
    const Pose now = inverse(world_.item_pose(item)) * tip;
    return std::ranges::any_of(failed_, [&](const auto& failed) {
      const Pose& then = failed.second;
      const auto along = [&](Vec3 axis) {
        return dot(rotate(now.rotation, axis), rotate(then.rotation, axis));
      };
      return failed.first == item && length(now.position - then.position) < same_grasp_m &&
             along({0, 0, 1}) > same_grasp_cosine && std::abs(along({0, 1, 0})) > same_grasp_cosine;
    });
  }

  // Of the item as everything lies now. Looked for once while the item lies still.
  Result<const ItemGrasps*> grasps_of(std::size_t item) {
    if (const auto found = grasps_.find(item); found != grasps_.end()) return &found->second;
    const Pose pose = world_.item_pose(item);
    const auto kept = lone_.find(item);
    if (kept == lone_.end() || !same_place(kept->second.pose, pose)) {
      MARKETGEN_TRY(std::vector<GraspCandidate> found, lone_grasps(*scene_, item));
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
    say("gives up");
    for (const std::size_t item : due) {
      const ItemGrasps& g = grasps_.at(item);
      say(fmt::format(
          "  {}: {} grasps, best has {} blockers, lies under {}, tries {}, refused {}, basket {}",
          called(item),
          g.choices.size(),
          g.choices.empty() ? 0 : g.choices.front().blockers.size(),
          g.lies_under.size(),
          tries_[item],
          refused_.contains(item),
          scene_->in_basket(item)));
    }
    done_ = true;
    return {};
  }

  static Result<void> checked(const Result<const ItemGrasps*>& grasps) {
    return grasps.ok() ? Result<void>{} : Result<void>{grasps.error()};
  }

  Result<bool> take_if(std::size_t item, Ease how) {
    if (!may_try(item) || refused_.contains(item)) return false;
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
      const bool stays = scene_->in_unloading(item) && is_target(item);
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
      if (!is_target(item) && scene_->in_basket(item)) others.push_back(item);
    const Vec3 at = scene_->middle(due.front());
    std::ranges::stable_sort(
        others, {}, [&](std::size_t item) { return length(scene_->middle(item) - at); });
    return others;
  }

  // ---- Taking it ----

  void say(const std::string& what) const {
    log_debug(fmt::format("oracle {:.2f} s: {}", now_.time_s, what));
  }
  std::string called(std::size_t item) const {
    const CheckoutGoods& goods = world_.goods(item);
    return fmt::format("{}{} {} {} ({:.2f} kg)",
                       is_target(item) ? "target " : "other ",
                       item,
                       goods.product.archetype,
                       fmt::join(goods.product.size_mm, "x"),
                       goods.product.mass_kg);
  }

  static Pose flipped(Pose tip) {
    tip.rotation = tip.rotation * rotation_about({0, 0, 1}, std::numbers::pi);
    return tip;
  }

  // Long enough that the fingers come from over the rim.
  Vec3 approach_to(const Pose& tip) const {
    const double rim = world_.station().basket.height_m + 0.04;
    const double steep = std::max(0.4, -rotate(tip.rotation, {0, 0, 1}).z);
    return {0, 0, std::max(0.08, (rim - tip.position.z) / steep)};
  }

  // A grasp with which the item can be put down as well, or else any.
  Result<bool> take(std::size_t item) {
    note(grasps_.at(item).choices.empty() ? FailureCode::no_grasp : FailureCode::no_ik);
    for (const bool to_be_placed : {true, false}) {
      MARKETGEN_TRY(const bool begun, take(item, to_be_placed));
      if (begun) return true;
    }
    return false;
  }

  Result<bool> take(std::size_t item, bool to_be_placed) {
    const ItemGrasps& grasps = grasps_.at(item);
    const Surroundings around = scene_->surroundings({});
    std::size_t plans = 0, searches = 0;
    for (std::size_t i = 0; i < std::min(grasps.choices.size(), most_grasps); ++i) {
      const GraspChoice& choice = grasps.choices[i];
      for (const Pose& tip : nearest_flip_first(choice.station_from_tip)) {
        const ReachRequest request{tip, approach_to(tip), choice.opening_m, touch_n};
        const Pose begin = tip * Pose{-request.approach, {}};
        if (failed_before(item, tip) || !arm_.effort_to(tip) || !arm_.effort_to(begin)) continue;
        if (to_be_placed && (searches++ >= most_place_searches || !has_place(item, tip, choice)))
          continue;
        if (plans++ >= most_plans) return false;
        const Seed seed = seed_.child("reach", static_cast<std::uint64_t>(moves_++));
        if (!arm_.reach(around, request, seed).ok()) {
          note(FailureCode::no_path);
          continue;
        }
        close_on(item, tip, choice);
        return true;
      }
    }
    return false;
  }

  void close_on(std::size_t item, const Pose& tip, const GraspChoice& choice) {
    arm_.wait(close_s, 0, touch_n);
    arm_.wait(firm_s, 0, choice.force_n);
    item_ = item;
    force_n_ = choice.force_n;
    product_from_tip_ = inverse(world_.item_pose(item)) * tip;
    ++tries_[item];
    ++takes_[item];
    say(fmt::format("takes {}, try {}, tilt {:.0f}, {:.0f} N, score {:.1f}, {} blockers",
                    called(item),
                    tries_[item],
                    tilt_deg(tip.rotation),
                    choice.force_n,
                    choice.score,
                    choice.blockers.size()));
    phase_ = Phase::closed;
  }

  PlaceQuestion place_question(std::size_t item,
                               const Pose& tip_from_item,
                               double opening_m,
                               bool in_area) const {
    PlaceQuestion question;
    question.item = item;
    question.tip_from_item = tip_from_item;
    question.opening_m = std::min(tool_.opening_m, opening_m);
    question.area = in_area ? world_.station().unloading.area() : world_.station().set_aside;
    if (!in_area) question.kept_free = kept_free();
    return question;
  }

  bool has_place(std::size_t item, const Pose& tip, const GraspChoice& choice) const {
    const PlaceQuestion question = place_question(
        item, inverse(tip) * world_.item_pose(item), choice.opening_m, is_target(item));
    return !item_places(*scene_, arm_, question, 1).empty();
  }

  std::vector<Pose> nearest_flip_first(const Pose& tip) const {
    const Pose other = flipped(tip);
    const double a = arm_.effort_to(tip).value_or(1e9), b = arm_.effort_to(other).value_or(1e9);
    if (b < a) return {other, tip};
    return {tip, other};
  }

  bool holds_it() const { return world_.watch().items()[item_].held; }

  Result<void> lift() {
    if (!holds_it()) return let_go_for_good(FailureCode::missed);
    const Surroundings around = scene_->surroundings({item_});
    const double rim = scene_->in_basket(item_) ? world_.station().basket.height_m : 0.03;
    const Pose pose = world_.item_pose(item_);
    const Vec3 half = scene_->half_extents_at(item_, pose.rotation);
    const double lowest = scene_->box_middle(item_, pose).z - half.z;
    const double up = std::max(0.05, rim + over_rim_m - lowest);
    for (const double share : {1.0, 0.85, 0.7}) {
      Pose tip = arm_.tip();
      tip.position.z += up * share;
      if (!arm_.straight(around, tip, 0, force_n_).ok()) continue;
      arm_.wait(settle_s, 0, force_n_);
      phase_ = Phase::lifted;
      return {};
    }
    return let_go(FailureCode::no_path);
  }

  Result<void> let_go_for_good(FailureCode why) {
    failed_.emplace_back(item_, product_from_tip_);
    return let_go(why);
  }

  // Opens where it is, and goes back the way it came.
  Result<void> let_go(FailureCode why) {
    note(why);
    say(fmt::format("lets go of {}: {}", called(item_), name_of(why)));
    const double opening = std::min(tool_.opening_m, now_.openings_m.front() + let_go_m);
    arm_.wait(open_s, opening, force_n_);
    back_off(opening);
    phase_ = Phase::released;
    return {};
  }

  void back_off(double opening_m) {
    const Surroundings around = scene_->surroundings({});
    for (const double by : {retreat_m, retreat_m / 2}) {
      if (arm_.straight(around, arm_.tip() * Pose{{0, 0, -by}, {}}, opening_m, force_n_).ok())
        break;
    }
    Pose up = arm_.tip();
    const double rim = world_.station().basket.height_m + 0.05;
    if (up.position.z >= rim) return;
    up.position.z = rim;
    [[maybe_unused]] const auto higher = arm_.straight(around, up, opening_m, force_n_);
  }

  // ---- Putting it down ----

  std::vector<AreaRow> kept_free() const {
    const BasketRow& b = world_.station().basket;
    const Vec3 at = world_.basket_pose().position;
    const double x = b.top_m[0] / 2 + b.wall_m + keep_off_basket_m,
                 y = b.top_m[1] / 2 + b.wall_m + keep_off_basket_m;
    AreaRow area = world_.station().unloading.area();
    for (std::size_t axis = 0; axis < 2; ++axis) {
      area.low_m[axis] -= keep_off_area_m;
      area.high_m[axis] += keep_off_area_m;
    }
    return {{{at.x - x, at.y - y}, {at.x + x, at.y + y}, {}}, area};
  }

  // Where it belongs, or else where it can be taken anew.
  Result<void> put_down() {
    if (!holds_it()) return let_go_for_good(FailureCode::slipped);
    const Pose tip_from_item = inverse(arm_.tip()) * world_.item_pose(item_);
    const double opening = now_.openings_m.front() + let_go_m;
    note(FailureCode::no_ik);
    places_.clear();
    in_area_ = is_target(item_);
    for (const bool in_area : {is_target(item_), false}) {
      if (!places_.empty()) break;
      const PlaceQuestion question = place_question(item_, tip_from_item, opening, in_area);
      places_ = item_places(*scene_, arm_, question, most_places);
      in_area_ = in_area;
    }
    next_place_ = 0;
    return go_over_place();
  }

  Result<void> go_over_place() {
    const Pose tip_from_item = inverse(arm_.tip()) * world_.item_pose(item_);
    const AttachedObject held = held_object(*scene_, item_, tip_from_item);
    const Surroundings around = scene_->surroundings({item_});
    for (; next_place_ < 2 * places_.size(); ++next_place_) {
      const PlaceChoice& place = places_[next_place_ % places_.size()];
      ReachRequest request{place.station_from_tip, place.approach, 0, force_n_};
      request.stops_before = true;
      if (next_place_ < places_.size()) request.attached = {held};
      const Seed seed = seed_.child("place", static_cast<std::uint64_t>(moves_++));
      if (!arm_.reach(around, request, seed).ok()) {
        note(FailureCode::no_path);
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
    if (!holds_it()) return let_go_for_good(FailureCode::slipped);
    const PlaceChoice& place = places_[next_place_++ % places_.size()];
    const Pose item_from_tip = inverse(world_.item_pose(item_)) * arm_.tip();
    const Surroundings around = scene_->surroundings({item_});
    for (const Pose& tip : {place.station_from_item * item_from_tip, place.station_from_tip}) {
      if (!arm_.straight(around, tip, 0, force_n_).ok()) continue;
      say(fmt::format(
          "puts {} down, place {}, in the area {}", called(item_), next_place_, in_area_));
      const double opening = std::min(tool_.opening_m, now_.openings_m.front() + let_go_m);
      arm_.wait(settle_s, 0, force_n_);
      arm_.wait(open_s, opening, force_n_);
      back_off(opening);
      if (in_area_ == is_target(item_)) tries_.erase(item_);
      phase_ = Phase::released;
      return {};
    }
    return go_over_place();
  }

  // Down again to where it was, as far as that goes.
  Result<void> put_back() {
    Pose tip = arm_.tip();
    tip.position.z -= 0.1;
    [[maybe_unused]] const auto down =
        arm_.straight(scene_->surroundings({item_}), tip, 0, force_n_);
    return let_go(failure_);
  }

  void note(FailureCode why) { failure_ = why; }

  const CheckoutWorld& world_;
  GraspTool tool_;
  ArmExecutor arm_;
  Seed seed_;
  Task task_;
  std::unique_ptr<OracleScene> scene_;
  Observation now_;
  Phase phase_ = Phase::choose;
  struct LoneGrasps {
    Pose pose;  // of the item, when they were looked for
    std::vector<GraspCandidate> found;
  };
  std::map<std::size_t, LoneGrasps> lone_;
  std::map<std::size_t, ItemGrasps> grasps_;  // of this decision
  std::set<std::size_t> refused_;             // no way to them was found in this decision
  std::map<std::size_t, int> tries_, takes_;
  std::vector<std::pair<std::size_t, Pose>> failed_;  // of which item; product_from_tip
  std::size_t item_ = 0;                              // that is being taken
  double force_n_ = 0;
  Pose product_from_tip_;            // as it was to be grasped
  std::vector<PlaceChoice> places_;  // of the item in the hand
  std::size_t next_place_ = 0;       // first with what is held looked at, then again without
  bool in_area_ = false;             // the places are where the item belongs
  int moves_ = 0;
  bool done_ = false;
  FailureCode failure_ = FailureCode::none;
};

}  // namespace

Result<std::unique_ptr<Policy>> make_checkout_oracle(const CheckoutWorld& world,
                                                     const std::filesystem::path& data,
                                                     Seed seed) {
  const std::vector<ToolChoiceRow>& tools = world.station().tools;
  const std::string row = tools.empty() ? world.robot().tools.front().row : tools.front().row;
  MARKETGEN_TRY(GraspTool tool, load_grasp_tool(data, row));
  MARKETGEN_TRY(ArmExecutor arm, ArmExecutor::make(world.robot()));
  return std::unique_ptr<Policy>(
      std::make_unique<CheckoutOracle>(world, std::move(tool), std::move(arm), seed));
}

}  // namespace marketgen
