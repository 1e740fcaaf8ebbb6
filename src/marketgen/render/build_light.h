// The room's own light: LED panels in rows over the aisles, and daylight through its openings.
#pragma once
#include <cstdint>
#include <vector>

#include "render/draft.h"
#include "render/room.h"

namespace marketgen::raytrace {

class LightBuilder {
 public:
  explicit LightBuilder(Draft& draft);
  // Hangs the panels and sets radiance and exposure from the look's lux and colour temperature.
  void build(Draft& draft, const Room& room) const;

 private:
  std::uint16_t panel_ = 0, frame_ = 0;
};

}  // namespace marketgen::raytrace
