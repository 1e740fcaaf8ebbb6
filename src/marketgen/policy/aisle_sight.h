// What looks at shelves tell: where the products that are looked for stand, and what else was
// measured. Store frame, metres.
#pragma once
#include <vector>

#include "agent/aisle_map.h"
#include "agent/decision.h"
#include "agent/eyes.h"
#include "perception/grasp_source.h"
#include "perception/shelf_choice.h"
#include "policy/looked_at.h"
#include "robots/robot.h"

namespace marketgen::policy {

// Of one product, as it was found from some place.
struct ShelfFind {
  std::size_t goal = 0;
  Pose store_from_product;
  double score = 0;
};

// Looks from one place, in the frame of the robot's base there.
class ShelfSight {
 public:
  explicit ShelfSight(const robots::BasePlace& place) : place_(place) {}
  const robots::BasePlace& place() const { return place_; }
  void add(agent::View view) { views_.emplace_back(std::move(view)); }

  // In the store's frame.
  perception::SeenIn seen_in() const { return {&views_, agent::store_from_base(place_)}; }

  // Where a product stands on the boards nearby; best first.
  std::vector<ShelfFind> find(std::size_t goal,
                              const perception::WantedProduct& wanted,
                              const agent::AisleMap& map,
                              const perception::SpotSource& spots,
                              const perception::ShelfChoice& choice) const;
  // The same product as it is seen from here; score 0 when it is not, or a rival is.
  ShelfFind again(const ShelfFind& known,
                  const perception::WantedProduct& wanted,
                  const perception::ShelfChoice& choice) const;
  // Whether enough of it would be seen, were it there: neither the robot's own arms nor anything
  // else before it hides it, and it is in a picture.
  bool shows(const ShelfFind& known, const perception::ProductLook& look) const;
  // Of a decision's trace; `found` as in the store's frame.
  std::vector<agent::LookedAt> looked_at(std::vector<FoundShape> found) const;
  // Measured points without the robot itself, which stands as `state` says (base on the origin).
  std::vector<Vec3f> points(const robots::Robot& robot, const std::vector<double>& state) const;
  // The same, with those of `before` that are not seen anew from here: what is measured again is
  // better known, against where the base believes it is now.
  std::vector<Vec3f> points_beside(const std::vector<Vec3f>& before,
                                   const robots::Robot& robot,
                                   const std::vector<double>& state) const;

 private:
  std::vector<perception::BoardAhead> boards_ahead(const agent::AisleMap& map) const;

  robots::BasePlace place_;
  std::vector<perception::ViewCloud> views_;
};

}  // namespace marketgen::policy
