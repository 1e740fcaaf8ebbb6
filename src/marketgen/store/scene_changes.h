// What differs between a scene and the scene after an edit, thing by thing.
#pragma once
#include <cstdint>
#include <set>
#include <string>

#include "base/fields.h"
#include "scene/scene.h"

namespace marketgen::store {

// By id. Kept: the same to the last bit, in its place. Moved: it has another pose, or another size.
struct ChangeCount {
  std::uint64_t kept = 0, moved = 0, added = 0, gone = 0;
  friend bool operator==(const ChangeCount&, const ChangeCount&) = default;
  static constexpr auto fields =
      field_list(field("kept", &ChangeCount::kept, "the same to the last bit"),
                 field("moved", &ChangeCount::moved, "elsewhere, or of another size"),
                 field("added", &ChangeCount::added, "new, or another product in its place"),
                 field("gone", &ChangeCount::gone, "no longer there"));
};

// A zone counts as moved when its floor changed. Materials and colours of fixtures do not count:
// they go with the look.
struct SceneChanges {
  ChangeCount zones, fixtures, products;
  std::set<std::string> zones_touched;  // with a fixture or product that is not kept
  static constexpr auto fields =
      field_list(field("zones", &SceneChanges::zones, "zones, by their floor"),
                 field("fixtures", &SceneChanges::fixtures, "fixture modules"),
                 field("products", &SceneChanges::products, "single items"));
};

SceneChanges changes_between(const scene::Scene& before, const scene::Scene& after);

}  // namespace marketgen::store
