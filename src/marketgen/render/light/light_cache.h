// Baked light kept on disk between runs, so that the next renderer of the same store need not bake
// it again (a second for a shop of 27,000 goods).
//
// Entries (io/cache_entry.h) lie under $MARKETGEN_CACHE/light by content; the newest 256 stay (a
// gigabyte of shops of that size).
#pragma once
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "render/light/irradiance.h"

namespace marketgen::render::raytrace {

// Over everything that decides the baked light: the world's shapes, materials, textures and lamps,
// where the probes are, and the sources that bake.
std::string light_key(const World& world, std::span<const Vec3f> probe_positions);

// Light of that many probes; nothing when there is none under this key, or the key is empty.
std::optional<BakedLight> kept_light(const std::string& key, std::size_t probes);
void keep_light(const std::string& key, const BakedLight& light);

}  // namespace marketgen::render::raytrace
