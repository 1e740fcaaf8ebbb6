#include "intake/interpret.h"
#include "intake/materials.h"

namespace marketgen::intake {
namespace {

using language::Meaning;

// Colours and materials, and the colour's hex value (kept in the row's zone column).
struct Surface {
  SurfaceWords words;
  std::string hex;
  std::string own_part;  // "terrazzo", "parquet" and the like name their part themselves
};

Surface surface_of(const Meaning& said) {
  Surface surface;
  for (const language::MeaningPtr& word : said.parts("words")) {
    if (word->text("zone").starts_with('#')) {
      surface.words.colors.push_back(word->text("value"));
      surface.hex = word->text("zone");
    } else {
      surface.words.materials.push_back(word->text("value"));
      if (word->has("zone")) surface.own_part = word->text("zone");
    }
  }
  return surface;
}

// Says what the part is to be; false when the catalogue has nothing like it.
bool add_surface(Reading& reading, const std::string& part, const Surface& surface, IntRange span) {
  if (part == "accent" || (part == "fixture" && surface.words.materials.empty())) {
    if (surface.hex.empty()) return false;
    plan::Requirement& color = reading.add(plan::RequirementKind::color, span);
    color.subject = part;
    color.object = surface.hex;
    return true;
  }
  const catalog::MaterialRow* row = material_for(reading.catalog, part, surface.words, surface.hex);
  if (row == nullptr && part == "fixture" && !surface.hex.empty())  // "shelves painted blue"
    return add_surface(reading, part, {{{}, surface.words.colors}, surface.hex, ""}, span);
  if (row == nullptr) return false;
  plan::Requirement& material = reading.add(plan::RequirementKind::material, span);
  material.subject = part;
  material.object = row->id;
  return true;
}

bool is_part(const std::string& name) {
  return name == "floor" || name == "wall" || name == "ceiling" || name == "accent" ||
         name == "fixture";
}

}  // namespace

// "white walls and ceiling": the words hold for both.
bool interpret_surface(Reading& reading, const Meaning& statement) {
  const Meaning& said = *statement.parts("surface").front();
  const Surface surface = surface_of(said);
  const language::Parts& parts = statement.parts("parts");
  if (parts.empty())
    return !surface.own_part.empty() &&
           add_surface(reading, surface.own_part, surface, statement.span);
  bool any = false;
  for (const language::MeaningPtr& part : parts) {
    const std::string name = is_part(part->text("value")) ? part->text("value") : "fixture";
    any = add_surface(reading, name, surface, joined(said.span, part->span)) || any;
  }
  return any;
}

}  // namespace marketgen::intake
