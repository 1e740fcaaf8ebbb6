// Pictures of the cameras at a counter, as one look takes them: several of each while the arm
// stands still, cameras corrected, and the basket found where it stands.
#pragma once
#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "agent/eyes.h"
#include "agent/workplace.h"
#include "perception/steady_view.h"
#include "perception/view_cloud.h"

namespace marketgen::policy {

class CheckoutPictures {
 public:
  // One more picture of each camera. Nothing while there are too few: the caller lets time pass.
  // With the last, `place` has the basket where it is seen to stand; it is said to stand near
  // there. Errors: of the eyes.
  Result<std::optional<std::vector<perception::ViewCloud>>> take(agent::Eyes& eyes,
                                                                 agent::Workplace& place);

 private:
  static constexpr std::array<std::string_view, 2> cameras{"scene_camera", "wrist_camera"};
  // Basket and goods are fitted to a millimetre.
  static constexpr double wanted_noise_m = 0.0011;
  std::array<perception::SteadyView, cameras.size()> taken_{perception::SteadyView(wanted_noise_m),
                                                            perception::SteadyView(wanted_noise_m)};
  bool found_basket_ = false;  // it moves little from then on
};

}  // namespace marketgen::policy
