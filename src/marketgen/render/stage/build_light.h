// The room's own light: lamps in rows over the aisles, fitted as the look says, and daylight
// through its openings.
#pragma once
#include <cstdint>
#include <vector>

#include "render/stage/draft.h"
#include "render/stage/room.h"

namespace marketgen::render::raytrace {

class LightBuilder {
 public:
  explicit LightBuilder(Draft& draft);
  // Hangs the lamps and sets radiance and exposure from the look's lux and colour temperature.
  void build(Draft& draft, const Room& room) const;

 private:
  void add_lamps(World& world, const layout::Layout& layout, const Room& room) const;

  catalog::LampFitting fitting_ = catalog::LampFitting::panel;
  std::uint16_t panel_ = 0, body_ = 0, inside_ = 0;
};

}  // namespace marketgen::render::raytrace
