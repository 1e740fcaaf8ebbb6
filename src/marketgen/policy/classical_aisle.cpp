#include "policy/classical_aisle.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "base/progress.h"
#include "perception/steady_view.h"
#include "policy/aisle_sight.h"
#include "policy/aisle_tour.h"
#include "policy/aisle_trace.h"
#include "policy/shelf_finds.h"
#include "policy/shelf_goals.h"
#include "skills/plan_failure.h"

namespace marketgen::policy {
namespace {

constexpr int tries_a_find = 2;  // of what was found at one place
// Shelves so near to the category's place are looked at before a doubtful find is taken; those
// farther than the second are left out.
constexpr double near_category_m = 3.5, far_from_category_m = 7;
constexpr double sure = 0.58;  // worth of a find that is taken at once
constexpr int max_moves = 2;   // before one find
constexpr double min_item_left_s = 45;
constexpr double stop_tilts[] = {0.14, 0.75};  // of the head, down: upper and lower boards
constexpr double min_again = 0.6;  // of its score, at a second look from before the shelf
constexpr double max_tilt = 1.04, max_pan = 1.3;

constexpr double next_picture_s = 0.05, next_find_s = 0.05;

const std::string head_eye = "head_camera";

enum class AisleStep {
  choose,
  look_up,
  look_down,
  at_shelf,
  look_again,
  look_on,
  pressed,
  out,
  away,
  lowered,
  let_go,
  dropped
};

class ClassicalAisle : public agent::Policy {
 public:
  ClassicalAisle(ClassicalAisleSetup setup, Seed seed)
      : setup_(std::move(setup)),
        modules_(setup_.modules),
        robot_(*setup_.body.robot),
        map_(*setup_.body.map),
        body_(setup_.body, seed),
        sight_(robots::BasePlace{}) {
    if (!modules_.spots) modules_.spots = std::make_unique<perception::SweptSpots>();
    if (!modules_.choice) modules_.choice = std::make_unique<perception::UprightMatching>();
    if (!modules_.grasps) modules_.grasps = std::make_unique<perception::FrontGrasps>(setup_.tool);
  }

  Result<void> begin(const agent::Task& task, const agent::Observation& first) override {
    task_ = task;
    log_.begin_answer(first.time_s);
    body_.start(first);
    stops_ = view_stops(map_);
    seen_.assign(stops_.size(), false);
    MARKETGEN_TRY(
        goals_,
        learn_shelf_goals(
            task.goals, modules_.language.get(), setup_.hints, *setup_.products, *setup_.looks));
    log_readings(goals_, log_);
    return {};
  }

  Result<agent::Action> act(const agent::Observation& now) override {
    now_ = now;
    log_.begin_answer(now.time_s);
    body_.sense(now);
    // What could not be planned leads on to the next step at once.
    for (int i = 0; i < 4 && body_.idle() && !done_; ++i)
      MARKETGEN_CHECK(decide());
    agent::Action action = body_.next();
    action.stop = done_;
    return action;
  }

  agent::Subtask subtask() const override { return body_.subtask(); }
  agent::DecisionLog* decisions() override { return &log_; }
  std::string failure() const override {
    for (const ShelfGoal& goal : goals_)
      if (goal.fetched < goal.wanted) return goal.failure;
    return "None";
  }

 private:
  // The arm or what it holds was pressed on, and has been moved back a second of its way: what was
  // planned is given up, and goes on from here by another plan.
  Result<void> recover() {
    say("was stopped");
    switch (step_) {
      case AisleStep::choose:  // on its way to its stowed posture
        return go_home();
      case AisleStep::look_up:
      case AisleStep::look_down:
      case AisleStep::at_shelf:
      case AisleStep::look_again:
      case AisleStep::look_on:
        step_ = AisleStep::choose;
        return choose();
      case AisleStep::pressed:
      case AisleStep::out:
        note(goals_[finds_[find_].place.goal], "Collision");
        log_find(agent::DecisionKind::contact, "Collision");
        held_ = body_.holds_it();
        step_ = AisleStep::away;
        return body_.back_off();
      case AisleStep::away:
        return drop();
      case AisleStep::lowered:
        step_ = AisleStep::away;
        if (!body_.rise(points_).ok()) say("cannot rise out of the basket");
        return {};
      case AisleStep::let_go:
        return leave_basket();
      case AisleStep::dropped:  // on its way home
        if (!body_.go_home(points_).ok()) return leave_basket();
        return {};
    }
    return {};
  }

  Result<void> decide() {
    if (body_.take_stop()) return recover();
    if (body_.take_held_up()) return body_.make_way();
    switch (step_) {
      case AisleStep::choose:
        return choose();
      case AisleStep::look_up:
        return look_up();
      case AisleStep::look_down:
        return look_down();
      case AisleStep::at_shelf:
        return at_shelf();
      case AisleStep::look_again:
        return look_again();
      case AisleStep::look_on:
        return look_on();
      case AisleStep::pressed:
        return pull_out();
      case AisleStep::out:
        step_ = AisleStep::away;
        return body_.back_off();
      case AisleStep::away:
        return drop();
      case AisleStep::lowered:
        return let_go();
      case AisleStep::let_go:
        return leave_basket();
      case AisleStep::dropped:
        return go_on();
    }
    return {};
  }

  // ---- What to do next ----

  Result<void> choose() {
    if (now_.time_s + min_item_left_s > task_.limit_s) {
      for (ShelfGoal& goal : goals_)
        if (goal.is_due()) goal.failure = "Timeout";
      stop("Timeout");
      return {};
    }
    // Sure finds; then what may be seen nearby; then doubtful ones; then what is farther away.
    MARKETGEN_TRY(const bool takes_sure, go_to_find(sure));
    if (takes_sure) return {};
    MARKETGEN_TRY(const bool looks, go_looking(near_category_m));
    if (looks) return {};
    MARKETGEN_TRY(const bool takes_doubtful, go_to_find(0));
    if (takes_doubtful) return {};
    MARKETGEN_TRY(const bool looks_on, go_looking(far_from_category_m));
    if (!looks_on) stop(failure());
    return {};
  }

  // One find an answer: to plan a way that there is not takes seconds. False when there is none.
  Result<bool> go_to_find(double min_worth) {
    const auto find = finds_.next(goals_, now_.base, min_worth);
    if (!find) return false;
    MARKETGEN_TRY(const bool goes, approach(*find));
    if (goes) return true;
    finds_.refuse(*find);
    body_.wait(next_find_s);
    return true;
  }

  // To the next place from which a missing goal may be seen; false when there is none.
  Result<bool> go_looking(double within_m) {
    std::optional<std::size_t> best;
    double least = 0;
    for (ShelfGoal& goal : goals_) {
      if (!goal.is_due()) continue;
      const auto stop = next_stop(map_, stops_, seen_, now_.base, goal.hint, within_m);
      if (!stop) continue;
      const double way = map_.way_m(now_.base, stops_[*stop].place).value_or(1e9);
      if (best && way >= least) continue;
      best = stop;
      least = way;
    }
    if (!best) return false;
    seen_[*best] = true;
    if (!body_.drive_to(stops_[*best].place).ok()) return true;  // another one, the next time
    step_ = AisleStep::look_up;
    still_ = perception::SteadyView();
    MARKETGEN_CHECK(body_.look(0, stop_tilts[0]));
    return true;
  }

  // ---- Looking ----

  // Standing still until pictures tell no more; then true.
  Result<bool> has_looked() {
    MARKETGEN_TRY(agent::View view, setup_.eyes->look(head_eye));
    still_.add(std::move(view));
    if (still_.wants_more()) {
      body_.wait(next_picture_s);
      return false;
    }
    sight_.add(still_.take());
    return true;
  }

  Result<void> look_up() {
    if (still_.empty()) sight_ = ShelfSight(now_.base);
    MARKETGEN_TRY(const bool looked, has_looked());
    if (!looked) return {};
    step_ = AisleStep::look_down;
    return body_.look(0, stop_tilts[1]);
  }

  Result<void> look_down() {
    MARKETGEN_TRY(const bool looked, has_looked());
    if (!looked) return {};
    points_ = sight_.points(robot_, body_.state());
    find_all();
    step_ = AisleStep::choose;
    return {};
  }

  // Whatever is asked for, in what is seen.
  void find_all() {
    std::vector<ShelfFind> all;
    for (std::size_t i = 0; i < goals_.size(); ++i) {
      if (!goals_[i].is_due()) continue;
      for (const ShelfFind& find :
           sight_.find(i, goals_[i].wanted_afar(), map_, *modules_.spots, *modules_.choice)) {
        remember(find);
        all.push_back(find);
      }
    }
    log_look(sight_, all, goals_, log_);
  }

  // For more of what was just taken: there the next one may stand behind it.
  Result<void> look_on() {
    if (still_.empty()) sight_ = ShelfSight(now_.base);
    MARKETGEN_TRY(const bool looked, has_looked());
    if (!looked) return {};
    points_ = sight_.points_beside(points_, robot_, body_.state());
    find_all();
    step_ = AisleStep::choose;
    return {};
  }

  void remember(const ShelfFind& find) {
    const ShelfGoal& goal = goals_[find.goal];
    const auto worth = finds_.remember(find, goal.hint);
    if (!worth) return;
    const Vec3 at = find.store_from_product.position;
    say(fmt::format(
        "finds {} at {:.2f} {:.2f} {:.2f}, turned {:.1f} deg, score {:.2f}, worth {:.2f}",
        goal.sku,
        at.x,
        at.y,
        at.z,
        yaw_of(find.store_from_product.rotation) * 180 / std::numbers::pi,
        find.score,
        *worth));
  }

  // ---- Taking it ----

  Result<PickTarget> item_at(const ShelfFind& find) {
    const ShelfGoal& goal = goals_[find.goal];
    MARKETGEN_TRY(const agent::KnownProduct* known, setup_.products->product(goal.sku));
    return pick_target(*known,
                       *goal.look,
                       find.store_from_product,
                       setup_.tool,
                       *modules_.grasps,
                       {points_, sight_.seen_in(), body_.walls_about(find.store_from_product)});
  }

  Result<bool> approach(std::size_t number) {
    KnownFind& find = finds_[number];
    ShelfGoal& goal = goals_[find.place.goal];
    const auto item = item_at(find.place);
    find_ = number;
    if (!item.ok()) return given_up(goal, item.error());
    if (item->grasps.empty()) return refused(goal, "NoGrasp");
    const auto pick = body_.plan_pick(*item, points_, {});
    if (!pick.ok()) return given_up(goal, pick.error());
    if (!body_.drive_to(agent::base_place(pick->world_from_base)).ok())
      return refused(goal, "NoPath");
    log_find(agent::DecisionKind::reach, "None");
    step_ = AisleStep::at_shelf;
    return true;
  }

  void say(std::string_view what) const {
    log_debug(fmt::format("classical {:.2f} s: {}", now_.time_s, what));
  }
  bool note(ShelfGoal& goal, std::string_view why) const {
    say(fmt::format("{}: {}", goal.sku, why));
    goal.failure = why;
    return false;
  }
  // Of the find that it was to reach.
  bool refused(ShelfGoal& goal, std::string_view why) {
    log_find(agent::DecisionKind::reach, why);
    return note(goal, why);
  }
  Result<bool> given_up(ShelfGoal& goal, const Error& error) {
    if (!skills::is_of_planning(error)) return error;
    say(to_string(error));
    return refused(goal, skills::failure_of_plan(error));
  }
  void stop(std::string_view why) {
    log_.add({.kind = agent::DecisionKind::stop, .outcome = std::string(why)});
    done_ = true;
  }

  // Towards a place in the store, as far as the head turns.
  Result<void> turn_head(Vec3 place) {
    const Pose head = robots::frame_pose(robot_, body_.state(), robot_.find_frame(head_eye));
    const Vec3 at = inverse(agent::store_from_base(now_.base)) * place - head.position;
    still_ = perception::SteadyView();
    return body_.look(std::clamp(std::atan2(at.y, at.x), -max_pan, max_pan),
                      std::clamp(std::atan2(-at.z, std::hypot(at.x, at.y)), 0.0, max_tilt));
  }

  Result<void> at_shelf() {
    KnownFind& find = finds_[find_];
    if (find.is_found_again) return take(find, goals_[find.place.goal], now_.base);
    step_ = AisleStep::look_again;
    return turn_head(find.place.store_from_product.position);
  }

  // Farther off, where nothing hides it; false where there is no way to such a place.
  bool goes_to_see(KnownFind& find) {
    if (std::exchange(find.is_hidden_there, true)) return false;
    const auto place = view_place(map_, find.place.store_from_product);
    if (!place || !body_.drive_to(*place).ok()) return false;
    say("it is hidden: looks from farther off");
    step_ = AisleStep::at_shelf;
    return true;
  }

  // From where it came to stand, by what is seen from there.
  Result<void> look_again() {
    KnownFind& find = finds_[find_];
    ShelfGoal& goal = goals_[find.place.goal];
    if (still_.empty()) sight_ = ShelfSight(now_.base);
    MARKETGEN_TRY(const bool looked, has_looked());
    if (!looked) return {};
    points_ = sight_.points_beside(points_, robot_, body_.state());
    if (!sight_.shows(find.place, *goal.look) && goes_to_see(find)) return {};
    MARKETGEN_TRY(const perception::WantedProduct wanted,
                  goal.wanted_close(*setup_.products, *setup_.looks));
    const ShelfFind again = sight_.again(find.place, wanted, *modules_.choice);
    const Pose moved = inverse(find.place.store_from_product) * again.store_from_product;
    say(fmt::format("sees it again with score {:.2f} of {:.2f}, by {:.3f} {:.3f} m, {:.1f} deg",
                    again.score,
                    find.place.score,
                    moved.position.x,
                    moved.position.y,
                    yaw_of(moved.rotation) * 180 / std::numbers::pi));
    const bool is_there = again.score >= min_again * find.place.score;
    log_look(sight_, is_there ? std::vector{again} : std::vector<ShelfFind>{}, goals_, log_);
    if (is_there) {
      find.place = again;
      if (find.is_hidden_there) return come_back(find);
      return take(find, goal, sight_.place());
    }
    refused(goal, "NotFound");
    finds_.refuse(find_);
    step_ = AisleStep::choose;
    return {};
  }

  // To where it is taken from, after it was looked at from farther off.
  Result<void> come_back(KnownFind& find) {
    find.is_found_again = true;
    step_ = AisleStep::choose;
    MARKETGEN_TRY(const bool goes, approach(find_));
    if (!goes) finds_.refuse(find_);
    return {};
  }

  Result<void> take(KnownFind& find, ShelfGoal& goal, const robots::BasePlace& from) {
    ++goal.tries;
    ++find.tries;
    step_ = AisleStep::choose;
    const auto item = item_at(find.place);
    auto pick =
        item.ok() ? body_.plan_pick(*item, points_, from) : Result<skills::ShelfPick>(item.error());
    if (!pick.ok()) {
      MARKETGEN_CHECK(given_up(goal, pick.error()));
      return move_before(find, goal);
    }
    say(fmt::format("takes {} with {}, score {:.2f}, worth {:.2f}, at {:.2f} {:.2f} {:.2f}",
                    goal.sku,
                    pick->group,
                    find.place.score,
                    find.worth,
                    find.place.store_from_product.position.x,
                    find.place.store_from_product.position.y,
                    find.place.store_from_product.position.z));
    MARKETGEN_CHECK(body_.take(*item, std::move(*pick)));
    log_find(agent::DecisionKind::reach, "None");
    step_ = AisleStep::pressed;
    return {};
  }

  // It did not come to stand where it was to, or the product stands elsewhere than it was seen from
  // afar: another place, by what is known now.
  Result<void> move_before(KnownFind& find, ShelfGoal& goal) {
    if (++find.moves <= max_moves) {
      --goal.tries, --find.tries;
      MARKETGEN_TRY(const bool goes, approach(find_));
      if (goes) return {};
    }
    finds_.refuse(find_);
    return {};
  }

  Result<void> pull_out() {
    held_ = body_.holds_it();
    log_find(agent::DecisionKind::hold, held_ ? "None" : "Missed");
    if (!held_) note(goals_[finds_[find_].place.goal], "Missed");
    step_ = AisleStep::out;
    return body_.pull_out();
  }

  Result<void> drop() {
    ShelfGoal& goal = goals_[finds_[find_].place.goal];
    if (!body_.holds_it()) {
      if (held_) log_find(agent::DecisionKind::place, "Slipped");
      if (held_) note(goal, "Slipped");
      return leave_empty();
    }
    const auto dropped = body_.drop(points_);
    if (dropped.ok()) {
      if (*dropped) step_ = AisleStep::lowered;
      return {};
    }
    log_find(agent::DecisionKind::place, "NoPath");
    note(goal, "NoPath");
    say("no way into the basket: " + to_string(dropped.error()));
    done_ = points_.empty();  // with the item in its hand: it cannot go on
    points_.clear();          // once more, past what the map knows alone
    return {};
  }

  Result<void> let_go() {
    MARKETGEN_TRY(const bool lets_go, body_.lowered());
    if (!lets_go) say("came upon something: another place in the basket");
    if (lets_go) count();
    step_ = lets_go ? AisleStep::let_go : AisleStep::away;
    return {};
  }

  Result<void> leave_basket() {
    step_ = AisleStep::dropped;
    auto leaves = body_.leave_basket(points_);
    if (!leaves.ok()) leaves = body_.leave_basket({});
    if (leaves.ok()) return {};
    say("no way out of the basket: " + to_string(leaves.error()));
    for (ShelfGoal& goal : goals_)
      if (goal.is_due()) goal.failure = "NoPath";
    stop("NoPath");
    return {};
  }

  Result<void> leave_empty() {
    step_ = AisleStep::choose;
    if (finds_[find_].tries >= tries_a_find) finds_.refuse(find_);
    return go_home();
  }

  Result<void> go_home() {
    if (!body_.go_home(points_).ok() && !body_.go_home({}).ok()) done_ = true;
    return {};
  }

  void count() {
    ShelfGoal& goal = goals_[finds_[find_].place.goal];
    log_find(agent::DecisionKind::place, "None");
    ++goal.fetched;
    say(fmt::format("{}: let go in the basket", goal.sku));
    goal.tries = 0;
    taken_ = finds_[find_].place;
    finds_.refuse(find_);
  }

  // From over the basket, with both arms home.
  Result<void> go_on() {
    const bool more = goals_[taken_.goal].is_due();
    step_ = more ? AisleStep::look_on : AisleStep::choose;
    if (more) return turn_head(taken_.store_from_product.position);
    return {};
  }

  // Of the find that is being taken.
  void log_find(agent::DecisionKind kind, std::string_view outcome) {
    const ShelfFind& find = finds_[find_].place;
    log_.add(find_decision(kind, goals_[find.goal], find, outcome));
  }

  ClassicalAisleSetup setup_;
  ClassicalAisleModules& modules_;
  const robots::Robot& robot_;
  const agent::AisleMap& map_;
  AisleBody body_;
  agent::Task task_;
  agent::Observation now_;
  std::vector<ShelfGoal> goals_;
  std::vector<ViewStop> stops_;
  std::vector<bool> seen_;  // of the stops
  ShelfFinds finds_;
  std::size_t find_ = 0;  // that is being taken
  ShelfFind taken_;       // the last one that was
  bool held_ = false;     // it was in the hand when that closed
  AisleStep step_ = AisleStep::choose;
  ShelfSight sight_;
  perception::SteadyView still_;  // of the look that is being taken
  std::vector<Vec3f> points_;     // measured from the last stop and before the shelf
  bool done_ = false;
  agent::DecisionLog log_;
};

}  // namespace

std::unique_ptr<agent::Policy> make_classical_aisle(ClassicalAisleSetup setup, Seed seed) {
  return std::make_unique<ClassicalAisle>(std::move(setup), seed);
}

}  // namespace marketgen::policy
