// Checkout Unloading as an entry of episodes/tracks.inc.
#include <algorithm>
#include <map>
#include <memory>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "episodes/checkout/checkout_scene.h"
#include "episodes/checkout/checkout_view.h"
#include "episodes/checkout/sample_checkout.h"
#include "episodes/proved_names.h"
#include "episodes/track_entry.h"

namespace marketgen::episodes {
namespace {

class RecordedCheckout : public RecordedView {
 public:
  RecordedCheckout(const Motion& motion,
                   const RecordedPlace& place,
                   std::unique_ptr<CheckoutView> view)
      : motion_(motion), place_(place), view_(std::move(view)) {}
  Result<Image> picture(std::string_view name, std::size_t step, int width, int height) override {
    const auto first_item = static_cast<std::uint32_t>(place_.scene->products.size());
    MARKETGEN_CHECK(view_->follow(
        place_.robot, scenery_at(motion_, step, first_item), joints_at(motion_, step)));
    MARKETGEN_TRY(const render::Camera camera, view_->camera(name, width, height));
    MARKETGEN_TRY(render::Frame frame, view_->renderer().render(camera, {}));
    return std::move(frame.color);
  }

 private:
  const Motion& motion_;
  const RecordedPlace& place_;
  std::unique_ptr<CheckoutView> view_;
};

// The items of a motion, by number. Error: there is no row of one.
Result<void> add_items(scene::Scene& scene,
                       const Motion& motion,
                       const std::vector<catalog::Product>& products) {
  std::map<std::uint32_t, const ThingMotion*> items;
  for (const ThingMotion& thing : motion.things)
    if (thing.kind == ThingKind::item) items[thing.number] = &thing;
  std::uint32_t next = 0;
  for (const auto& [number, thing] : items) {
    const auto row = std::ranges::find(products, thing->sku, &catalog::Product::sku);
    if (row == products.end() || number != next++ || thing->poses.empty())
      return Error{"catalog.unknown_sku",
                   thing->sku,
                   fmt::format("item {} of {} cannot be drawn", number, motion.episode)};
    add_item(scene, *row, {{thing->poses[0], thing->poses[1], thing->poses[2]}, {}});
  }
  return {};
}

// The number of what a witness calls "item-3"; none where the basket has no such item.
std::optional<std::size_t> item_number(const EpisodeSpec& spec, const std::string& product) {
  for (std::size_t item = 0; item < spec.items.size(); ++item)
    if (product == witness_item(item)) return item;
  return std::nullopt;
}

class CheckoutEntry : public TrackEntry {
 public:
  std::vector<std::string_view> cameras() const override { return {"scene", "wrist"}; }
  std::vector<std::string_view> own_fields() const override { return {"items", "station", "lane"}; }

  Result<void> check_goals(const EpisodeSpec& spec, const std::string& where) const override {
    for (const EpisodeGoal& goal : spec.goals) {
      const auto lying = std::ranges::count(spec.items, goal.sku, &EpisodeItem::sku);
      if (lying < goal.count)
        return Error{
            "episode.impossible",
            where + "/goals",
            fmt::format(
                "asks for {} of \"{}\"; {} lie in the basket", goal.count, goal.sku, lying)};
    }
    return {};
  }

  std::vector<std::string_view> proofs() const override {
    std::vector<std::string_view> shown(shown_by_unloading.begin(), shown_by_unloading.end());
    shown.push_back(shown_settled);
    return shown;
  }

  Result<void> check_picks(const EpisodeSpec& spec) const override {
    const std::vector<WitnessPick>& witness = spec.certificate.witness;
    for (std::size_t i = 0; i < witness.size(); ++i) {
      const auto item = item_number(spec, witness[i].product);
      if (!item)
        return Error{"episode.bad_value",
                     fmt::format("witness/{}/product", i),
                     fmt::format("\"{}\" is none of item-0 to item-{}",
                                 witness[i].product,
                                 std::ssize(spec.items) - 1)};
      if (spec.items[*item].sku != witness[i].sku)
        return Error{"episode.bad_value",
                     fmt::format("witness/{}/sku", i),
                     fmt::format("\"{}\" is a \"{}\", not a \"{}\"",
                                 witness[i].product,
                                 spec.items[*item].sku,
                                 witness[i].sku)};
    }
    return {};
  }

  Result<TrackRobot> robot(const std::filesystem::path& data) const override {
    MARKETGEN_TRY(const CheckoutStation station, load_checkout_station(data));
    return TrackRobot{station.robot, ids_of(station.tool_sets)};
  }

  // All that lies there.
  int items_of(const EpisodeSpec& spec) const override {
    return static_cast<int>(spec.items.size());
  }
  int max_items() const override { return max_goal_kinds + max_other_goods; }

  Result<RecordedPlace> place_of(const std::filesystem::path& data,
                                 const Motion& motion,
                                 std::shared_ptr<const scene::Scene> store,
                                 const catalog::Catalog& catalog) const override {
    const std::string named = station_or_own(motion.station);
    MARKETGEN_TRY(const CheckoutStation station, load_checkout_station(data, named, motion.tools));
    MARKETGEN_TRY(robots::Robot robot, load_station_robot(data, station));
    CheckoutPlace place = checkout_room(station);
    if (!motion.lane.empty()) {
      MARKETGEN_TRY(
          place, checkout_at_lane(station, *store, catalog, motion.lane, motion.episode + "/lane"));
    }
    return RecordedPlace{std::make_shared<scene::Scene>(std::move(place.surroundings)),
                         named + "/" + motion.lane,
                         std::move(robot),
                         basket_actor(station)};
  }

  std::vector<std::string> recorded_cameras() const override {
    return {std::string(name_of(StationCamera::scene)), std::string(name_of(StationCamera::wrist))};
  }

  Result<std::unique_ptr<RecordedView>> open_recorded(
      const std::filesystem::path& data,
      const Motion& motion,
      const RecordedPlace& place,
      const std::vector<catalog::Product>& products) const override {
    MARKETGEN_TRY(const CheckoutStation station,
                  load_checkout_station(data, station_or_own(motion.station), motion.tools));
    auto scene = std::make_unique<scene::Scene>(*place.scene);
    MARKETGEN_CHECK(add_items(*scene, motion, products));
    const std::vector<double>& at = motion.store_from_robot;
    MARKETGEN_TRY(auto view,
                  CheckoutView::create(station,
                                       place.robot,
                                       std::move(scene),
                                       {{at[0], at[1], at[2]}, {at[3], at[4], at[5], at[6]}},
                                       {.keep_light = true}));
    return std::unique_ptr<RecordedView>(
        std::make_unique<RecordedCheckout>(motion, place, std::move(view)));
  }
};

}  // namespace

const TrackEntry& checkout_entry() {
  static const CheckoutEntry entry;
  return entry;
}

}  // namespace marketgen::episodes
