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

namespace marketgen {

struct Sight {
  std::vector<ViewCloud> views;
  std::vector<MaskedView> masked;   // goods in the basket and on the counter
  std::vector<FoundProduct> found;  // `look`: number of the SKU that was asked for
  std::vector<Vec3f> points;        // measured, thinned
};

// Pictures of all `cameras`, masks, and where `wanted` lie. Errors: of the eyes.
Result<Sight> take_sight(Eyes& eyes,
                         const std::vector<std::string>& cameras,
                         const Workplace& place,
                         const MaskSource& masks,
                         const TargetChoice& targets,
                         const std::vector<WantedProduct>& wanted);

// Without those that show the robot's own body as it stands: it knows where it is.
std::vector<Vec3f> without_robot(const std::vector<Vec3f>& points,
                                 const Robot& robot,
                                 const Observation& now);

// The place, and measured points for ways to keep off.
Surroundings seen_surroundings(const Workplace& place,
                               const std::vector<Vec3f>& points,
                               HandAt hand);

}  // namespace marketgen
