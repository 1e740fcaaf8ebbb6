// What a policy may sense and know in In-Aisle Item Collection, made from a running episode:
// pictures of the head camera, the map, the robot as it drives. Nothing else of the world passes
// through here.
#pragma once
#include <memory>
#include <vector>

#include "agent/aisle_map.h"
#include "agent/eyes.h"
#include "episodes/aisle/aisle_view.h"

namespace marketgen {

// The head camera, without noise; base frame: that of the robot's base. `world` must outlive it.
class AisleEyes : public Eyes {
 public:
  explicit AisleEyes(const AisleWorld& world) : world_(world) {}
  Result<View> look(std::string_view camera) override;

 private:
  const AisleWorld& world_;
  std::unique_ptr<AisleView> view_;  // of the episode that runs, once it was looked at
};

// The store must outlive it.
class StoreMap : public AisleMap {
 public:
  explicit StoreMap(const AisleStore& store);
  const std::vector<ShelfBoard>& boards() const override { return boards_; }
  bool has_room(const BasePlace& place) const override;
  Result<BaseFollower> way(const BasePlace& from, const BasePlace& to) const override;
  std::optional<double> way_m(const BasePlace& from, const BasePlace& to) const override;
  Obstacles fixtures(Vec3 middle, double within_m) const override;

 private:
  PointMm axle_mm(const BasePlace& place) const;

  const AisleStore& store_;
  std::vector<ShelfBoard> boards_;
};

std::vector<CategoryHint> category_hints(const EpisodeSpec& spec);

}  // namespace marketgen
