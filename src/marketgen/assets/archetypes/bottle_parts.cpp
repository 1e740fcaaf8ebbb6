#include "assets/archetypes/bottle_parts.h"

namespace marketgen {

void add_screw_cap(
    Profile& profile, float low, float top, float radius_m, std::uint16_t neck, std::uint16_t cap) {
  const float span = top - low;
  const float cap_low = low + 0.35F * span;
  profile.use(neck).neck(low, 0.86F * radius_m).neck(low + 0.10F * span, 0.86F * radius_m);
  profile.neck(low + 0.14F * span, 1.12F * radius_m).neck(low + 0.18F * span, 1.12F * radius_m);
  profile.neck(low + 0.22F * span, 0.90F * radius_m);
  profile.use(cap).neck(cap_low, radius_m).neck(top - 0.08F * span, 0.98F * radius_m);
  profile.neck(top, 0.88F * radius_m).pole(top);
}

}  // namespace marketgen
