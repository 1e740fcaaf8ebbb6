#include "oracle/oracle_witness.h"

#include <algorithm>
#include <set>

#include "oracle/oracle_grasps.h"
#include "oracle/oracle_places.h"
#include "skills/hand_reach.h"

namespace marketgen::oracle {
namespace {

constexpr std::size_t max_choices = 24;    // of which postures are sought
constexpr std::size_t max_ways_tried = 4;  // of an item

class CheckoutWitness {
 public:
  CheckoutWitness(const episodes::CheckoutWorld& world,
                  const robots::GraspTool& tool,
                  skills::ArmExecutor arm,
                  Seed seed)
      : world_(world), scene_(world, tool), arm_(std::move(arm)), seed_(seed) {}

  Result<std::optional<std::vector<episodes::WitnessPick>>> find() {
    arm_.start(world_.observe());
    std::vector<std::size_t> targets, others;
    for (std::size_t item = 0; item < scene_.items(); ++item) {
      MARKETGEN_TRY(const std::vector<motion::GraspCandidate> lone, lone_grasps(scene_, item));
      const bool wanted = scene_.is_target(item);
      if (wanted && lone.empty()) return std::optional<std::vector<episodes::WitnessPick>>{};
      grasps_.push_back(item_grasps(scene_, item, lone));
      (wanted ? targets : others).push_back(item);
    }
    if (!can_be_cleared(targets)) return std::optional<std::vector<episodes::WitnessPick>>{};
    while (!std::ranges::all_of(targets, [&](std::size_t item) { return out_.contains(item); }))
      if (!take_one_of(targets) && !take_one_of(others))
        return std::optional<std::vector<episodes::WitnessPick>>{};
    return std::optional(std::move(picks_));
  }

 private:
  bool take_one_of(const std::vector<std::size_t>& items) {
    return std::ranges::any_of(
        items, [&](std::size_t item) { return !out_.contains(item) && take(item); });
  }

  bool is_out(const std::vector<std::size_t>& items) const { return are_in(items, out_); }

  static bool are_in(const std::vector<std::size_t>& items, const std::set<std::size_t>& set) {
    return std::ranges::all_of(items, [&](std::size_t item) { return set.contains(item); });
  }

  // Whether the hand, if it came wherever it wanted, could take what is in the way of these, and
  // what is in the way of that. Quicker to see than that no way of the arm is found.
  bool can_be_cleared(const std::vector<std::size_t>& items) const {
    std::set<std::size_t> out;
    for (std::size_t before = out.size() + 1; before != out.size();) {
      before = out.size();
      for (std::size_t item = 0; item < grasps_.size(); ++item) {
        const ItemGrasps& grasps = grasps_[item];
        const bool is_free = are_in(grasps.lies_under, out) &&
                             std::ranges::any_of(grasps.choices, [&](const GraspChoice& choice) {
                               return are_in(choice.blockers, out);
                             });
        if (is_free) out.insert(item);
      }
    }
    return are_in(items, out);
  }

  bool take(std::size_t item) {
    const ItemGrasps& grasps = grasps_[item];
    if (!is_out(grasps.lies_under)) return false;
    const skills::Surroundings around = scene_.surroundings({out_.begin(), out_.end()});
    const std::vector<skills::PlacedBody> walls = scene_.walls();
    std::size_t plans = 0;
    for (std::size_t i = 0; i < std::min(grasps.choices.size(), max_choices); ++i) {
      const GraspChoice& choice = grasps.choices[i];
      if (!is_out(choice.blockers)) continue;
      const std::vector<robots::ToolSolid> hand =
          skills::open_hand(scene_.tool(), choice.opening_m);
      for (const Pose& tip : skills::alike_ways(arm_, choice.base_from_tip, scene_.tool().kind)) {
        const skills::ReachRequest request =
            skills::reach_over_rim(tip, scene_.rim_z_m(), choice.opening_m);
        if (!skills::is_reached(arm_, request, hand, walls) ||
            !has_place(scene_, arm_, item, tip, choice.opening_m))
          continue;
        if (plans++ == max_ways_tried) return false;
        const bool reached = arm_.reach(around, request, seed_.child("reach", moves_++)).ok();
        arm_.start(world_.observe());  // and forgets it
        if (!reached) continue;
        out_.insert(item);
        note(item, choice);
        return true;
      }
    }
    return false;
  }

  void note(std::size_t item, const GraspChoice& choice) {
    episodes::WitnessPick pick;
    pick.sku = world_.spec().items[item].sku;
    pick.product = episodes::witness_item(item);
    pick.arm = "arm";
    pick.strategy = std::string(name_of(choice.strategy));
    picks_.push_back(std::move(pick));
  }

  const episodes::CheckoutWorld& world_;
  OracleScene scene_;
  skills::ArmExecutor arm_;
  Seed seed_;
  std::vector<ItemGrasps> grasps_;
  std::set<std::size_t> out_;  // items that were taken
  std::vector<episodes::WitnessPick> picks_;
  std::uint64_t moves_ = 0;
};

}  // namespace

episodes::CheckoutCertifier checkout_certifier(const std::filesystem::path& data) {
  return [data](const episodes::CheckoutWorld& world,
                Seed seed) -> Result<std::optional<std::vector<episodes::WitnessPick>>> {
    MARKETGEN_TRY(const robots::GraspTool tool, load_checkout_tool(world, data));
    MARKETGEN_TRY(skills::ArmExecutor arm, make_checkout_arm(world, tool));
    return CheckoutWitness(world, tool, std::move(arm), seed).find();
  };
}

}  // namespace marketgen::oracle
