#include "oracle/oracle_places.h"

#include <algorithm>

namespace marketgen::oracle {

skills::HeldPack held_pack(const OracleScene& scene,
                           std::size_t item,
                           const Pose& tip_from_item,
                           double opening_m) {
  const episodes::EpisodeGoods& goods = scene.world().goods(item);
  return {&goods.product,
          &goods.body,
          tip_from_item,
          scene.world().item_pose(item).rotation,
          std::min(scene.tool().opening_m, opening_m)};
}

skills::PlaceQuestion place_question(const OracleScene& scene, std::size_t item, bool in_area) {
  const agent::Workplace place = scene.place();
  skills::PlaceQuestion question;
  question.area = in_area ? place.unloading : place.set_aside;
  if (!in_area) question.kept_free = skills::areas_kept_free(place);
  question.corners_first = in_area && scene.tool().kind == robots::ToolKind::suction;
  question.walls = scene.walls();
  for (std::size_t other = 0; other < scene.items(); ++other) {
    if (other == item || scene.in_basket(other)) continue;
    const skills::PlacedBody body = scene.body(other);
    question.bodies.push_back(
        {body, skills::turned_box(scene.world().goods(other).body, body.base_from_body)});
  }
  return question;
}

bool has_place(const OracleScene& scene,
               const skills::ArmExecutor& arm,
               std::size_t item,
               const Pose& station_from_tip,
               double opening_m) {
  const Pose tip_from_item = inverse(station_from_tip) * scene.world().item_pose(item);
  const skills::HeldPack held = held_pack(scene, item, tip_from_item, opening_m);
  const skills::PlaceQuestion question = place_question(scene, item, scene.is_target(item));
  return !skills::free_places(scene.tool(), arm, held, question, 1).empty();
}

}  // namespace marketgen::oracle
