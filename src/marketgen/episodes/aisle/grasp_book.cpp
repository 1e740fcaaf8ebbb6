#include "episodes/aisle/grasp_book.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/progress.h"
#include "episodes/aisle/aisle_station.h"
#include "episodes/aisle/studied_grasps.h"
#include "grasping/grasp_database.h"
#include "physics/goods/contact_shape.h"
#include "physics/world/cup_lip.h"

namespace marketgen::episodes {
namespace {

constexpr int min_held = 2;  // of three tries

bool is_holdable(const grasping::GraspRate& rate) {
  return rate.fits() && !rate.tries.empty() &&
         rate.held() >= std::min<int>(min_held, static_cast<int>(rate.tries.size()));
}

std::string why_not_held(const grasping::GraspRate& rate) {
  if (!rate.fits()) return std::string(name_of(rate.excluded));
  if (rate.tries.empty()) return "untried";
  const grasping::GraspEnd end = rate.tries.front().end;
  return end == grasping::GraspEnd::held ? "unreliable" : std::string(name_of(end));
}

// Numbers, among the first `most`, of those that keep the pack from turning between the pads while
// the arm turns it over.
std::vector<int> steady_grasps(const std::vector<motion::GraspCandidate>& grasps,
                               const robots::GraspTool& tool,
                               int most) {
  std::vector<int> steady;
  for (int i = 0; i < std::min(most, static_cast<int>(grasps.size())); ++i)
    if (grasps[static_cast<std::size_t>(i)].swing_n <= tool.force_n) steady.push_back(i);
  return steady;
}

// A pack in a store is one solid, simpler than the study's pieces: whether a cup's lip lies on it
// evenly enough there, too.
bool seals_on(const assets::ContactShape& solid,
              const robots::GraspTool& cup,
              const Pose& product_from_tool) {
  if (solid.shape != assets::CollisionShape::box) return false;
  const Quaternion solid_from_product = inverse(solid.pose.rotation);
  const Vec3 ahead = rotate(solid_from_product * product_from_tool.rotation, {0, 0, 1});
  const Vec3 at = inverse(solid.pose) * product_from_tool.position;
  struct Axis {
    double ahead, at, half;
  };
  std::array<Axis, 3> axes{Axis{std::abs(ahead.x), std::abs(at.x), solid.size.x},
                           {std::abs(ahead.y), std::abs(at.y), solid.size.y},
                           {std::abs(ahead.z), std::abs(at.z), solid.size.z}};
  std::ranges::sort(axes, {}, &Axis::ahead);
  const Axis& face = axes[2];
  const double tilt = std::hypot(axes[0].ahead, axes[1].ahead) / face.ahead;
  const auto inside = [&](const Axis& axis) { return axis.at + cup.cup_radius_m < axis.half; };
  return 2 * cup.cup_radius_m * tilt < cup.seal_depth_m &&
         std::abs(face.at - face.half) < physics::bellows_stroke_m && inside(axes[0]) &&
         inside(axes[1]);
}

}  // namespace

grasping::StudyOptions GraspBook::options() {
  grasping::StudyOptions options;
  options.settings = {grasping::GraspSetting::stocked};
  options.enough_held = min_held;
  return options;
}

GraspBook::GraspBook(robots::GraspTool tool,
                     std::vector<catalog::FrictionRow> frictions,
                     const std::vector<grasping::GraspRate>& known,
                     grasping::GraspTable shipped)
    : tool_(std::move(tool)), frictions_(std::move(frictions)), shipped_(std::move(shipped)) {
  for (const grasping::GraspRate& rate : known)
    if (rate.tool == tool_.id && rate.setting == grasping::GraspSetting::stocked)
      rates_.emplace(rate.sku, rate);
}

Result<grasping::GraspRate> GraspBook::rate(const catalog::Product& product) {
  {
    const std::scoped_lock lock(mutex_);
    if (const auto known = rates_.find(product.sku); known != rates_.end()) return known->second;
  }
  if (const auto shipped = shipped_.find(product, tool_, frictions_)) return *shipped;
  MARKETGEN_TRY(
      const std::vector<grasping::GraspRate> rates,
      grasping::study_grasps({&product}, {tool_}, frictions_, options(), silent_progress()));
  const std::scoped_lock lock(mutex_);
  rates_.emplace(product.sku, rates.front());
  new_.insert(product.sku);
  return rates.front();
}

std::vector<grasping::GraspRate> GraspBook::studied() const {
  const std::scoped_lock lock(mutex_);
  std::vector<grasping::GraspRate> rates;
  for (const std::string& sku : new_)
    rates.push_back(rates_.at(sku));
  return rates;
}

// Of a cup's: those with which it seals on the pack as a store has it.
Result<void> GraspBook::leave_sealed(const catalog::Product& product,
                                     const std::vector<motion::GraspCandidate>& candidates,
                                     std::vector<int>& numbers) const {
  if (tool_.kind != robots::ToolKind::suction) return {};
  MARKETGEN_TRY(const assets::CollisionPrimitive primitive, assets::collision_of(product));
  const assets::ContactShape solid = assets::contact_shape_of(primitive);
  std::erase_if(numbers, [&](int number) {
    const motion::GraspCandidate& candidate = candidates[static_cast<std::size_t>(number)];
    return !seals_on(solid, tool_, candidate.grasp.product_from_tool);
  });
  return {};
}

Result<StudiedProduct> GraspBook::study(const catalog::Product& product) {
  const auto candidates = studied_grasps(product, tool_, frictions_, {});
  std::vector<int> steady;
  if (candidates.ok()) {
    steady = steady_grasps(*candidates, tool_, options().tries);
    if (steady.empty()) return StudiedProduct{{}, "swings"};
    MARKETGEN_CHECK(leave_sealed(product, *candidates, steady));
    if (steady.empty()) return StudiedProduct{{}, "no_seal"};
  }
  MARKETGEN_TRY(const grasping::GraspRate rate, this->rate(product));
  if (!is_holdable(rate)) return StudiedProduct{{}, why_not_held(rate)};
  if (!candidates.ok()) return candidates.error();
  StudiedProduct studied;
  const std::vector<int> held = rate.held_tries();
  for (const int number : steady)
    if (std::ranges::count(held, number) > 0) studied.grasps.push_back(number);
  if (studied.grasps.empty()) studied.why_not = "swings";
  return studied;
}

Result<void> GraspBook::keep(const std::filesystem::path& data, const std::string& catalog_hash) {
  const std::vector<grasping::GraspRate> rates = studied();
  if (rates.empty()) return {};
  MARKETGEN_TRY(const std::string key, grasping::grasp_study_key(data, catalog_hash, options()));
  if (const auto kept = grasping::keep_grasp_rates(rates, key, options().seed); !kept.ok()) {
    log_warning(to_string(kept.error()));
    return {};
  }
  const std::scoped_lock lock(mutex_);
  for (const grasping::GraspRate& rate : rates)
    new_.erase(rate.sku);
  return {};
}

Result<std::shared_ptr<GraspBook>> open_aisle_book(const std::filesystem::path& data,
                                                   const catalog::Catalog& catalog,
                                                   const std::string& tools) {
  MARKETGEN_TRY(const AisleStation station, load_aisle_station(data, tools));
  MARKETGEN_TRY(robots::GraspTool tool, robots::load_grasp_tool(data, station.tools().picks_with));
  MARKETGEN_TRY(const std::string key,
                grasping::grasp_study_key(data, catalog.content_hash, GraspBook::options()));
  MARKETGEN_TRY(grasping::GraspTable shipped, grasping::GraspTable::read(data));
  return std::make_shared<GraspBook>(
      std::move(tool), catalog.frictions, grasping::kept_grasp_rates(key), std::move(shipped));
}

}  // namespace marketgen::episodes
