// What a look at the counter tells: where the products that are looked for lie, and what else
// stands about.
#pragma once
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "agent/eyes.h"
#include "agent/workplace.h"
#include "perception/grasp_source.h"
#include "perception/target_choice.h"
#include "skills/counter_obstacles.h"

namespace marketgen::policy {

struct Sight {
  std::vector<perception::ViewCloud> views;
  std::vector<perception::MaskedView> masked;   // goods in the basket and on the counter
  std::vector<perception::FoundProduct> found;  // `look`: number of the SKU that was asked for
  std::vector<Vec3f> points;                    // measured, thinned
};

// Masks, and where `wanted` lie, in pictures of all cameras.
Sight sight_of(std::vector<perception::ViewCloud> views,
               const agent::Workplace& place,
               const perception::MaskSource& masks,
               const perception::TargetChoice& targets,
               const std::vector<perception::WantedProduct>& wanted);

// Without those that show the robot's own body as it stands: it knows where it is.
std::vector<Vec3f> without_robot(const std::vector<Vec3f>& points,
                                 const robots::Robot& robot,
                                 const agent::Observation& now);

// The place, and measured points for ways to keep off.
skills::Surroundings seen_surroundings(const agent::Workplace& place,
                                       const std::vector<Vec3f>& points,
                                       skills::HandAt hand);

}  // namespace marketgen::policy
