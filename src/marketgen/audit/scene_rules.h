// Rules about a finished scene: one row each in scene_rules.inc.
#pragma once
#include <string_view>
#include <vector>

#include "audit/audit.h"
#include "audit/collisions.h"
#include "audit/egress.h"
#include "audit/traffic.h"
#include "geometry/mesh.h"
#include "layout/layout.h"
#include "scene/scene.h"

namespace marketgen::audit {

// What the rules look at; measured once.
struct SceneFacts {
  const scene::Scene& scene;
  const Metrics& metrics;
  const CollisionCount& collisions;
  const Traffic& traffic;
  const std::vector<std::uint32_t>& out_of_place;  // rows of scene.products
  const Egress& egress;
  const catalog::Catalog& catalog;
};

struct SceneRule {
  std::string_view code;
  layout::Severity severity;
  double limit;
  std::string_view source;
  std::string_view remedy;  // "set_look: a light_lux of 300 and more"
  std::vector<layout::Violation> (*check)(const SceneFacts& facts, const SceneRule& rule);
};
const std::vector<SceneRule>& scene_rules();

// A broken rule of a scene.
layout::Violation violation_of(const SceneRule& rule,
                               std::string where,
                               double value,
                               std::string message);

// The check of each rule: of goods in scene_rules.cpp, of the room in room_rules.cpp.
#define SCENE_RULE(code, severity, limit, source, remedy) \
  std::vector<layout::Violation> check_##code(const SceneFacts& facts, const SceneRule& rule);
#include "audit/scene_rules.inc"
#undef SCENE_RULE

std::vector<layout::Violation> check_scene(const SceneFacts& facts);

}  // namespace marketgen::audit
