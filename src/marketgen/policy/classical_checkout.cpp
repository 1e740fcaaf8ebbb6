#include "policy/classical_checkout.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "base/gravity.h"
#include "base/progress.h"
#include "geometry/rotation_axes.h"
#include "policy/checkout_pictures.h"
#include "policy/checkout_sight.h"
#include "policy/checkout_trace.h"
#include "policy/felt_contacts.h"
#include "policy/pick_choice.h"
#include "skills/basket_moves.h"
#include "skills/hand_reach.h"
#include "skills/place_search.h"
#include "skills/plan_failure.h"

namespace marketgen::policy {
namespace {

constexpr int tries_an_item = 3;
constexpr std::size_t grasps_tried = 16, plans_tried = 5, places_tried = 8;
constexpr double calming_s = 0.25, opening_s = 0.35;
constexpr double wider_m = 0.014;  // than what was held, when it is let go
constexpr double min_left_s = 8;   // no new grasp with less time left
constexpr int max_cleared = 8;
constexpr double measured_within_m = 0.004;  // of a point of the cameras: noise and their grid
// An open hand may push so hard past what lies about a grasp, and what is held, beside its weight,
// where it is put down. So near to either it is where it was to go.
constexpr double push_n = 35, near_grasp_m = 0.015, near_place_m = 0.02;
constexpr double raised_m = 0.08;  // off what it met there
// How hard it tries: intrusion of an open hand that is borne, contacts at grasps of a product since
// anything was taken out, and how many things that are in the way it looks at.
struct Effort {
  double borne_m;
  int max_contacts;
  std::size_t max_others;
};
constexpr std::array<Effort, 3> efforts{{{0.006, 2, 4}, {0.012, 5, 4}, {0.02, 5, 12}}};
constexpr int max_tried_again = 2;
// From where the wrist camera looks into the basket: tip over its middle, fingers down.
constexpr double look_back_m = 0.06, look_height_m = 0.40;

constexpr double between_pictures_s = 0.05, look_n = 20;

enum class Step { go_to_look, look, closed, lifted, lowered, put_back };

class ClassicalCheckout : public agent::Policy {
 public:
  ClassicalCheckout(ClassicalSetup setup, skills::ArmExecutor arm, Seed seed)
      : setup_(std::move(setup)),
        modules_(setup_.modules),
        arm_(std::move(arm)),
        seed_(seed),
        walls_(setup_.place) {
    if (!modules_.masks) modules_.masks = std::make_unique<perception::GeometricMasks>();
    if (!modules_.poses) modules_.poses = std::make_unique<perception::SweptPoses>();
    if (!modules_.targets)
      modules_.targets = std::make_unique<perception::CatalogueMatching>(*modules_.poses);
    if (!modules_.grasps)
      modules_.grasps = std::make_unique<perception::FittedGrasps>(setup_.tool, setup_.place);
  }

  Result<void> begin(const agent::Task& task, const agent::Observation& first) override {
    task_ = task;
    arm_.start(first);
    log_.begin_answer(first.time_s);
    MARKETGEN_CHECK(learn_catalogue());
    MARKETGEN_CHECK(goals_.learn(task.goals, modules_.language.get(), catalogue_));
    log_readings(goals_, log_);
    return {};
  }

  Result<agent::Action> act(const agent::Observation& now) override {
    now_ = now;
    log_.begin_answer(now.time_s);
    // A motion that could not be planned leads on to the next step at once.
    for (int i = 0; i < 3 && arm_.idle() && !done_; ++i)
      MARKETGEN_CHECK(decide());
    agent::Action action = arm_.next(now);
    action.stop = done_;
    return action;
  }

  std::string failure() const override { return failure_; }
  agent::Subtask subtask() const override { return arm_.subtask(); }
  agent::DecisionLog* decisions() override { return &log_; }

 private:
  // The arm or what it holds was pressed on, and has been moved back a second of its way: it looks
  // anew, or goes on with what it holds by another plan.
  Result<void> recover() {
    note("Collision");
    log_held(agent::DecisionKind::contact, failure_);
    const bool holds = arm_.presses() && holds_it();
    if (step_ == Step::closed && !holds) felt_.note_grasp(grasp_tip_, *held_look_);
    if (step_ == Step::lowered) felt_.note_place(place_tip_.position);
    const Step was = std::exchange(step_, Step::go_to_look);
    if (was == Step::put_back)
      let_go("Collision");
    else if (!holds)
      go_to_look();
    else if (hand_now() == skills::HandAt::basket)
      lift();
    else
      put_down();
    return {};
  }

  // The hand met something where it was to come upon nothing.
  void feel_contact() {
    if (step_ == Step::closed) return feel_at_grasp();
    if (step_ == Step::lowered) return feel_at_place();
    let_go(failure_);
  }

  // Near the grasp the open hand shuts where it is; else there is no room, whatever pictures
  // showed.
  void feel_at_grasp() {
    if (length(arm_.tip().position - grasp_tip_.position) < near_grasp_m) {
      tip_from_product_ = inverse(arm_.tip()) * (grasp_tip_ * tip_from_product_);
      return skills::close_hand(arm_, force_n_);
    }
    note("Collision");
    log_held(agent::DecisionKind::contact, failure_);
    felt_.note_grasp(grasp_tip_, *held_look_);
    step_back(setup_.tool.opening_m);
    step_ = Step::go_to_look;
  }

  // What is held stands on something: here, if it is nearly where it was to go.
  void feel_at_place() {
    if (length(arm_.tip().position - place_tip_.position) < near_place_m) return release();
    note("Collision");
    log_held(agent::DecisionKind::contact, failure_);
    felt_.note_place(place_tip_.position);
    Pose up = arm_.tip();
    up.position.z += raised_m;
    say_failed("raise what it holds",
               arm_.straight(around(others_, skills::HandAt::counter), up, 0, force_n_));
    step_ = Step::lifted;
  }

  Result<void> decide() {
    if (arm_.take_stop()) return recover();
    if (arm_.take_touch()) {
      feel_contact();
      return {};
    }
    switch (step_) {
      case Step::go_to_look:
        go_to_look();
        return {};
      case Step::look:
        return look();
      case Step::closed:
        count_try();
        lift();
        return {};
      case Step::lifted:
        put_down();
        return {};
      case Step::lowered:
        release();
        return {};
      case Step::put_back:
        let_go(failure_);
        return {};
    }
    return {};
  }

  // ---- Looking ----

  // Where no way leads there it looks from where it is: one camera stands still and sees most.
  void go_to_look() {
    step_ = Step::look;
    arm_.set_subtask(agent::Subtask::look);
    const Vec3 at = setup_.place.base_from_basket.position;
    const Pose tip{{at.x - look_back_m, at.y, look_height_m},
                   rotation_with_axes({0, -1, 0}, {0, 0, -1})};
    const skills::ReachRequest request{tip, {0, 0, 0.02}, setup_.tool.opening_m, look_n};
    if (arm_.reach(around(others_, skills::HandAt::counter), request, next_seed()).ok()) return;
    // Something stands against the hand: up first, then past what is known of the place alone.
    const skills::Surroundings bare = around({}, skills::HandAt::basket);
    Pose up = arm_.tip();
    up.position.z = std::max(up.position.z, look_height_m);
    say_failed("raise the hand", arm_.straight(bare, up, setup_.tool.opening_m, look_n));
    if (const auto there = arm_.reach(bare, request, next_seed()); !there.ok()) {
      say_failed("go to where it looks from", there);
      note(skills::failure_of_plan(there.error()));
    }
  }

  Result<void> look() {
    MARKETGEN_TRY(std::optional<std::vector<perception::ViewCloud>> views,
                  pictures_.take(*setup_.eyes, setup_.place));
    if (!views) {
      arm_.wait(between_pictures_s, setup_.tool.opening_m, look_n);
      return {};
    }
    sight_ = sight_of(
        std::move(*views), setup_.place, *modules_.masks, *modules_.targets, goals_.wanted());
    if (goals_.wanted().empty()) {
      goals_.narrow(sight_, catalogue_);
      log_readings(goals_, log_);
      sight_.found = modules_.targets->find(goals_.wanted(), sight_.views, sight_.masked);
    }
    log_look(sight_, goals_, log_);
    sight_.points = without_robot(sight_.points, *setup_.robot, now_);
    if (now_.time_s + min_left_s > task_.limit_s) {
      stop("Timeout");
      return {};
    }
    return choose();
  }

  // ---- What to take next ----

  // What is asked for, where the hand has room; then what is in the way; then what is asked for
  // though the hand has to press something aside.
  Result<void> choose() {
    auto [all_there, targets] = due_targets(goals_, sight_, setup_.place.unloading, tries_an_item);
    if (all_there) {
      stop("None");
      return {};
    }
    if (targets.empty() && failure_ == "None") note("NotFound");
    if (!goals_.may_find_more(sight_, setup_.place.unloading)) {
      stop("NotFound");
      return {};
    }
    MARKETGEN_TRY(const bool begun, take_something(targets));
    if (begun) return {};
    // Goods have been moved since by what came upon them: once more where it was felt, too.
    if (tried_again_++ < max_tried_again && felt_.any()) {
      felt_.forget();
      MARKETGEN_TRY(const bool again, take_something(targets));
      if (again) return {};
    }
    stop(failure_);
    return {};
  }

  Result<bool> take_something(std::vector<PickChoice>& targets) {
    std::vector<PickChoice> others;
    std::size_t looked_at = 0;
    for (const auto& [borne, contacts, max_others] : efforts) {
      MARKETGEN_TRY(const bool begun, take_one_of(targets, borne, contacts));
      if (begun) return true;
      if (cleared_ >= max_cleared) continue;
      if (std::exchange(looked_at, max_others) != max_others)
        others = others_near(
            targets, goals_, sight_, setup_.place, {catalogue_, *modules_.poses}, max_others);
      MARKETGEN_TRY(const bool clears, take_one_of(others, borne, contacts));
      if (clears) return true;
    }
    return false;
  }

  // Those that the hand came upon something at as often are passed over.
  Result<bool> take_one_of(std::vector<PickChoice>& choices, double borne_m, int contacts) {
    for (PickChoice& choice : choices) {
      if (felt_.count(*choice.look) >= contacts) continue;
      if (choice.known == nullptr)
        MARKETGEN_CHECK(
            find_grasps(choice, *setup_.products, *modules_.grasps, sight_, setup_.place));
      if (take(choice, borne_m)) return true;
    }
    return false;
  }

  Result<void> learn_catalogue() {
    std::vector<const catalog::Product*> rows;
    for (const catalog::Product& row : setup_.products->rows())
      rows.push_back(&row);
    MARKETGEN_TRY(catalogue_, setup_.looks->of(rows, *setup_.products));
    return {};
  }

  // ---- Where things are ----

  skills::Surroundings around(const std::vector<Vec3f>& points, skills::HandAt hand) const {
    return seen_surroundings(setup_.place, points, hand);
  }
  double rim_z_m() const { return setup_.place.base_from_basket.position.z + setup_.place.rim_m; }
  skills::HandAt hand_now() const {
    return skills::is_over_basket(setup_.place, arm_.tip().position) ? skills::HandAt::basket
                                                                     : skills::HandAt::counter;
  }

  // ---- Taking it ----

  bool take(const PickChoice& choice, double borne_m) {
    arm_.set_subtask(agent::Subtask::reach);
    if (choice.grasps.empty()) note("NoGrasp");
    agent::Decision decision = reach_decision(choice);
    const perception::SeenGrasp* taken = plan_reach(choice, borne_m, decision.tried);
    if (taken != nullptr) begin_grasp(choice, *taken);
    if (taken == nullptr) decision.outcome = decision.tried.empty() ? "NoGrasp" : failure_;
    log_.add(std::move(decision));
    return taken != nullptr;
  }

  // The first grasp to which the arm is now on its way; null when there is none.
  const perception::SeenGrasp* plan_reach(const PickChoice& choice,
                                          double borne_m,
                                          std::vector<agent::TriedGrasp>& tries) {
    const skills::Surroundings seen = around(sight_.points, skills::HandAt::basket);
    const std::vector<skills::PlacedBody> walls = walls_.at(setup_.place.base_from_basket);
    struct {
      std::size_t tried = 0, plans = 0;
    } spent[2];  // on its own, and on a server's proposals, which take nothing from these
    for (const perception::SeenGrasp& grasp : choice.grasps) {
      auto& [tried, plans] = spent[grasp.proposed ? 1 : 0];
      if (grasp.intrusion_m > borne_m || plans > plans_tried) continue;
      if (tried++ >= grasps_tried) continue;
      const std::vector<robots::ToolSolid> hand = skills::open_hand(setup_.tool, grasp.opening_m);
      for (const Pose& tip : skills::either_way_round(arm_, grasp.base_from_tip)) {
        skills::ReachRequest request = skills::reach_over_rim(tip, rim_z_m(), grasp.opening_m);
        request.force_n = skills::touch_n;
        request.max_force_n = push_n;
        if (felt_.has_grasp(tip)) continue;
        agent::TriedGrasp& trial = tries.emplace_back();
        trial = {
            {tip.position.x, tip.position.y, tip.position.z}, grasp.opening_m, grasp.intrusion_m};
        if (!skills::is_reached(arm_, request, hand, walls)) {
          trial.outcome = "NoIK";
          note("NoIK");
          continue;
        }
        if (plans++ >= plans_tried) {
          tries.pop_back();
          break;
        }
        const auto way = arm_.reach(seen, request, next_seed());
        if (way.ok()) return &grasp;
        note(skills::failure_of_plan(way.error()));
        trial.outcome = failure_;
        felt_.note_no_way(tip);
      }
    }
    return nullptr;
  }

  void begin_grasp(const PickChoice& choice, const perception::SeenGrasp& grasp) {
    skills::close_hand(arm_, grasp.force_n);
    goal_ = choice.goal;
    held_look_ = choice.look;
    likeness_ = choice.likeness;
    known_ = choice.known;
    tip_from_product_ = inverse(arm_.tip()) * choice.base_from_product;
    width_m_ = grasp.width_m;
    force_n_ = grasp.force_n;
    others_ = choice.others;
    grasp_tip_ = arm_.tip();
    step_ = Step::closed;
  }

  // By the fingers alone: shut on nothing they come together.
  bool holds_it() const { return now_.openings_m.front() > std::max(0.004, 0.4 * width_m_); }

  void count_try() {
    if (goal_)
      goals_.note_taken(*goal_, *held_look_, likeness_);
    else
      ++cleared_;
  }

  void lift() {
    log_held(agent::DecisionKind::hold, holds_it() ? "None" : "Missed");
    if (!holds_it()) return let_go("Missed");
    const Vec3 middle = setup_.place.base_from_basket.position;
    const double lowest_m = perception::lowest_z_m(*held_look_, arm_.tip() * tip_from_product_);
    if (!skills::lift_out(arm_, basket_around(), lowest_m, middle, force_n_).ok())
      return let_go("NoPath");
    arm_.wait(calming_s, 0, force_n_);
    step_ = Step::lifted;
  }

  // Opens where it is, and goes back the way it came.
  void let_go(const std::string& why) {
    note(why);
    const double opening = opening_to_let_go();
    arm_.set_subtask(agent::Subtask::retreat);
    arm_.wait(opening_s, opening, force_n_);
    step_back(opening);
    step_ = Step::go_to_look;
  }

  skills::BasketSurroundings basket_around() const {
    return {around(others_, hand_now()), skills::counter_alone(setup_.place), rim_z_m()};
  }

  void step_back(double opening_m) {
    say_failed("raise the hand", skills::draw_back(arm_, basket_around(), opening_m, force_n_));
  }

  // ---- Putting it down ----

  void put_down() {
    if (!holds_it()) {
      log_held(agent::DecisionKind::place, "Slipped");
      return let_go("Slipped");
    }
    arm_.set_subtask(agent::Subtask::place);
    const double opening = opening_to_let_go();
    const agent::Workplace& at = setup_.place;
    skills::PlaceQuestion question;
    question.area = at.unloading;
    question.points = &others_;
    question.walls = walls_.at(at.base_from_basket);
    question.unsure_m = measured_within_m;
    if (!goal_) {
      question.area = at.set_aside;
      question.kept_free = skills::areas_kept_free(at);
    }
    const skills::Surroundings seen = around(others_, skills::HandAt::counter);
    const skills::HeldPack held{&known_->product,
                                &known_->body,
                                tip_from_product_,
                                arm_.tip().rotation * tip_from_product_.rotation,
                                opening};
    const auto places = skills::free_places(setup_.tool, arm_, held, question, places_tried);
    if (places.empty()) note("NoIK");
    for (const bool attached : {true, false}) {
      for (const skills::FreePlace& place : places) {
        if (felt_.has_place(place.base_from_tip.position)) continue;
        skills::ReachRequest request{place.base_from_tip, place.approach, 0, force_n_};
        request.max_force_n = put_force_n();
        if (attached)
          request.attached = {skills::held_spheres(*setup_.robot, known_->body, tip_from_product_)};
        if (!arm_.reach(seen, request, next_seed()).ok()) {
          note("NoPath");
          continue;
        }
        arm_.wait(calming_s, 0, force_n_);
        place_tip_ = place.base_from_tip;
        step_ = Step::lowered;
        return;
      }
    }
    log_held(agent::DecisionKind::place, failure_);
    felt_.note_grasp(grasp_tip_, *held_look_);  // held otherwise there may be a place for it
    put_back();
  }

  double opening_to_let_go() const {
    return std::min(setup_.tool.opening_m, now_.openings_m.front() + wider_m);
  }

  void release() {
    const double opening = opening_to_let_go();
    arm_.wait(opening_s, opening, force_n_);
    step_back(opening);
    log_held(agent::DecisionKind::place, "None");
    if (goal_) goals_.note_put_down(*goal_);
    felt_.forget();
    step_ = Step::go_to_look;
  }

  // Down again to where it was, as far as that goes.
  void put_back() {
    const auto down = arm_.let_down(around(others_, skills::HandAt::basket), force_n_);
    say_failed("let it down to where it was", down);
    if (down.ok()) arm_.guard(put_force_n());
    step_ = Step::put_back;
  }

  double put_force_n() const { return skills::putting_force_n(known_->product); }

  void note(std::string_view why) { failure_ = why; }
  // Of a motion without which it goes on.
  void say_failed(std::string_view motion, const Result<void>& planned) const {
    if (planned.ok()) return;
    log_debug(fmt::format(
        "classical {:.2f} s: cannot {}: {}", now_.time_s, motion, to_string(planned.error())));
  }
  void stop(std::string_view why) {
    note(why);
    done_ = true;
    log_.add({.kind = agent::DecisionKind::stop, .outcome = failure_});
  }

  // ---- What it tells of its decisions ----

  // Of what the hand was last sent to.
  void log_held(agent::DecisionKind kind, std::string_view outcome) {
    log_.add({.kind = kind,
              .goal = goal_ ? static_cast<int>(*goal_) : -1,
              .sku = held_look_ != nullptr ? held_look_->sku() : "",
              .outcome = std::string(outcome)});
  }

  Seed next_seed() { return seed_.child("reach", static_cast<std::uint64_t>(moves_++)); }

  ClassicalSetup setup_;
  ClassicalModules& modules_;
  skills::ArmExecutor arm_;
  Seed seed_;
  skills::BasketWalls walls_;
  agent::Task task_;
  agent::Observation now_;
  SoughtGoals goals_;
  Step step_ = Step::go_to_look;
  CheckoutPictures pictures_;
  Sight sight_;
  std::optional<std::size_t> goal_;  // that is being taken; none: something in the way
  const perception::ProductLook* held_look_ = nullptr;
  std::vector<const perception::ProductLook*> catalogue_;  // the whole of it
  double likeness_ = 0;                                    // of that find
  int cleared_ = 0, tried_again_ = 0;
  const agent::KnownProduct* known_ = nullptr;  // that is held, and how
  Pose tip_from_product_;
  Pose grasp_tip_;  // base_from_tip that it is taken by
  FeltContacts felt_;
  Pose place_tip_;                    // base_from_tip where it is put down
  double width_m_ = 0, force_n_ = 0;  // of the grasp
  std::vector<Vec3f> others_;         // what stood about when it was taken
  int moves_ = 0;
  bool done_ = false;
  std::string failure_ = "None";
  agent::DecisionLog log_;
};

}  // namespace

Result<std::unique_ptr<agent::Policy>> make_classical_checkout(ClassicalSetup setup, Seed seed) {
  MARKETGEN_TRY(skills::ArmExecutor arm, skills::ArmExecutor::make(*setup.robot));
  return std::unique_ptr<agent::Policy>(
      std::make_unique<ClassicalCheckout>(std::move(setup), std::move(arm), seed));
}

}  // namespace marketgen::policy
