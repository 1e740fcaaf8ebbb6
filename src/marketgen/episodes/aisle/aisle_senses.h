// What a policy may sense and know in In-Aisle Item Collection, made from a running episode:
// pictures of the head camera, the map, the robot as it drives. Nothing else of the world passes
// through here.
#pragma once
#include <memory>
#include <vector>

#include "agent/aisle_map.h"
#include "agent/eyes.h"
#include "episodes/aisle/aisle_view.h"

namespace marketgen::episodes {

// The head camera, as the world's realism has it; base frame: that of the robot's base. `world`
// must outlive it.
class AisleEyes : public agent::Eyes {
 public:
  explicit AisleEyes(const AisleWorld& world) : world_(world) {}
  Result<agent::View> look(std::string_view camera) override;

 private:
  const AisleWorld& world_;
  std::unique_ptr<AisleView> view_;  // of the episode that runs, once it was looked at
};

// Of AisleWorld::mapped(), which must outlive it.
class StoreMap : public agent::AisleMap {
 public:
  explicit StoreMap(const AisleStore& store);
  const std::vector<agent::ShelfBoard>& boards() const override { return boards_; }
  bool has_room(const robots::BasePlace& place) const override;
  Result<motion::BaseFollower> way(const robots::BasePlace& from,
                                   const robots::BasePlace& to) const override;
  Result<motion::WayRound> way_round(const robots::BasePlace& from,
                                     const robots::BasePlace& to,
                                     std::span<const motion::MovingDisc> people,
                                     bool waited) const override;
  std::optional<double> way_m(const robots::BasePlace& from,
                              const robots::BasePlace& to) const override;
  motion::Obstacles fixtures(Vec3 middle, double within_m) const override;

 private:
  PointMm axle_mm(const robots::BasePlace& place) const;
  motion::FloorPlace floor_place(const robots::BasePlace& place) const;

  const AisleStore& store_;
  std::vector<agent::ShelfBoard> boards_;
};

std::vector<agent::CategoryHint> category_hints(const EpisodeSpec& spec);

}  // namespace marketgen::episodes
