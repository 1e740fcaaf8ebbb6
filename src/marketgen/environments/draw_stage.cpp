#include "environments/draw_stage.h"

#include <fmt/format.h>

#include "environments/aisle/shared_aisle.h"
#include "environments/checkout/checkout_environment.h"
#include "episodes/aisle/aisle_stage.h"
#include "episodes/aisle/door_stage.h"
#include "episodes/checkout/checkout_station.h"
#include "episodes/checkout/sample_one_item.h"
#include "robots/grasp_tool.h"

namespace marketgen::environments {
namespace {

constexpr int max_stage_draws = 20;

// The same counter with the basket within reach.
constexpr char basket_station[] = "one-item-basket";

Result<episodes::EpisodeSpec> draw_place(EpisodeGround& ground, std::uint64_t seed) {
  MARKETGEN_TRY(episodes::EpisodeSpec spec, draw_one_item(ground, seed));
  MARKETGEN_TRY(const auto drawn_at,
                episodes::load_checkout_station(ground.data(), episodes::one_item_station));
  MARKETGEN_TRY(const auto station, episodes::load_checkout_station(ground.data(), basket_station));
  const Pose moved = inverse(station.basket_pose()) * drawn_at.basket_pose();
  for (episodes::EpisodeItem& item : spec.items)
    item = episodes::EpisodeItem::at(item.sku, moved * item.pose());
  const std::string name = spec.goals.front().text.value_or(spec.goals.front().sku);
  spec.station = basket_station;
  spec.instruction = fmt::format("Put {} into the basket.", name);
  spec.limit_s = episodes::stage_limit_s;
  spec.id = fmt::format("{}/{}", spec.id, name_of(episodes::Stage::place));
  return spec;
}

Result<std::shared_ptr<episodes::DoorStages>> door_stages(EpisodeGround& ground,
                                                          const std::string& scene_hash,
                                                          const std::string& tools) {
  return ground.arena().shared().get<episodes::DoorStages>(
      scene_hash + " " + tools, [&]() -> Result<std::shared_ptr<episodes::DoorStages>> {
        MARKETGEN_TRY(
            auto store,
            shared_aisle_store(ground.arena(), scene_hash, tools, episodes::Doors::hinged));
        return std::make_shared<episodes::DoorStages>(std::move(store));
      });
}

// A store without a door that opens is passed over by the next draw.
Result<episodes::EpisodeSpec> draw_door(EpisodeGround& ground,
                                        const std::string& tools,
                                        Seed seed) {
  const std::vector<episodes::EpisodeStore>& stores = ground.stores();
  const auto last = static_cast<int>(stores.size()) - 1;
  const episodes::EpisodeStore& store =
      stores[static_cast<std::size_t>(seed.child("store").stream().integer(0, last))];
  MARKETGEN_TRY(const auto doors, door_stages(ground, store.scene_hash, tools));
  return doors->draw({store.name, store.scene_hash, store.plan_hash}, seed);
}

Result<episodes::EpisodeSpec> draw_in_aisle(EpisodeGround& ground,
                                            episodes::Stage stage,
                                            const std::string& tools,
                                            Seed seed) {
  if (stage == episodes::Stage::open) return draw_door(ground, tools, seed);
  const std::uint64_t number = seed.child("episode").value();
  MARKETGEN_TRY(const episodes::EpisodeSpec whole,
                ground.draw(episodes::Track::aisle, number, tools));
  MARKETGEN_TRY(const auto store,
                shared_aisle_store(ground.arena(), whole.scene_hash, tools, doors_of(whole)));
  MARKETGEN_TRY(episodes::EpisodeSpec spec, episodes::aisle_stage(*store, whole, stage, seed));
  if (stage == episodes::Stage::pick) MARKETGEN_CHECK(start_of_pick(ground, spec));
  return spec;
}

// Another episode may do.
bool is_about_the_episode(const Error& error) {
  return error.code.starts_with("motion.") || error.code.starts_with("collect.") ||
         error.code == "robot.unreachable" || error.code == "episode.impossible";
}

}  // namespace

Result<episodes::EpisodeSpec> draw_stage(EpisodeGround& ground,
                                         episodes::Stage stage,
                                         const std::string& tools,
                                         std::uint64_t seed) {
  if (stage == episodes::Stage::whole)
    return Error{"usage.bad_flag", "stage", "whole tasks are drawn by their tracks"};
  if (stage == episodes::Stage::place) return draw_place(ground, seed);
  const Seed own = Seed(seed).child("stage", name_of(stage));
  Result<episodes::EpisodeSpec> drawn = draw_in_aisle(ground, stage, tools, own);
  for (std::uint64_t i = 1; i < max_stage_draws && !drawn.ok(); ++i) {
    if (!is_about_the_episode(drawn.error())) break;
    drawn = draw_in_aisle(ground, stage, tools, own.child("again", i));
  }
  return drawn;
}

Result<std::vector<double>> start_of_pick(EpisodeGround& ground,
                                          const episodes::EpisodeSpec& spec) {
  MARKETGEN_TRY(const episodes::WitnessPick pick, episodes::witness_of(spec));
  const std::string key = fmt::format("{} {} {} {} {}",
                                      spec.scene_hash,
                                      pick.product,
                                      pick.base.x_m,
                                      pick.base.y_m,
                                      pick.base.heading_deg);
  using Posture = const std::vector<double>;
  MARKETGEN_TRY(
      const auto posture,
      ground.arena().shared().get<Posture>(key, [&]() -> Result<std::shared_ptr<Posture>> {
        MARKETGEN_TRY(
            const auto store,
            shared_aisle_store(ground.arena(), spec.scene_hash, spec.tools, doors_of(spec)));
        MARKETGEN_TRY(const robots::GraspTool tool,
                      robots::load_grasp_tool(ground.data(), store->station.tools().picks_with));
        MARKETGEN_TRY(
            std::vector<double> state,
            episodes::hand_before_product(*store, spec, tool, ground.catalog().frictions));
        return std::make_shared<Posture>(std::move(state));
      }));
  return *posture;
}

Result<std::vector<double>> start_of_open(EpisodeGround& ground,
                                          const episodes::EpisodeSpec& spec) {
  MARKETGEN_TRY(const auto doors, door_stages(ground, spec.scene_hash, spec.tools));
  return doors->hand_before_bar(spec);
}

}  // namespace marketgen::environments
