#include "intake/plan_look.h"

#include <cmath>

#include "intake/materials.h"
#include "plan/style_look.h"

namespace marketgen {
namespace {

// The look that goes with a kind of shop, when nobody names one.
struct UsualStyle {
  std::string_view profile, style;
};
constexpr UsualStyle usual_styles[] = {{"discounter-eu", "discount"},
                                       {"organic-eu", "organic"},
                                       {"supermarket-us", "classic"},
                                       {"convenience-cn", "modern"}};

const StyleRow& style_of(const PlanSources& sources) {
  const Catalog& catalog = sources.catalog;
  const Requirement* wish = sources.understanding.find(RequirementKind::style);
  std::string name = "modern";
  for (const UsualStyle& usual : usual_styles) {
    if (usual.profile == sources.program.profile->id) name = usual.style;
  }
  if (wish != nullptr) name = wish->object;
  if (sources.brief.style) name = *sources.brief.style;
  const StyleRow* row = catalog.style(name);
  return row != nullptr ? *row : catalog.styles.front();
}

void apply_material(Look& look, const Requirement& wish) {
  if (wish.subject == "floor") look.floor = wish.object;
  if (wish.subject == "wall") look.wall = wish.object;
  if (wish.subject == "ceiling") look.ceiling = wish.object;
  if (wish.subject == "fixture") look.fixture = wish.object;
}

void apply_color(Look& look, const Requirement& wish, const Catalog& catalog) {
  if (wish.subject == "accent") look.accent = wish.object;
  if (wish.subject != "fixture") return;
  const MaterialRow* nearest = nullptr;
  for (const MaterialRow& row : catalog.materials) {
    const bool painted = row.id.starts_with("metal-");
    if (!painted) continue;
    const double apart = color_distance(row.color, wish.object);
    if (nearest == nullptr || apart < color_distance(nearest->color, wish.object)) nearest = &row;
  }
  if (nearest != nullptr) look.fixture = nearest->id;
}

}  // namespace

Look look_of(const PlanSources& sources) {
  Look look = look_of(style_of(sources));
  for (const Requirement& wish : sources.understanding.requirements) {
    if (wish.kind == RequirementKind::material) apply_material(look, wish);
    if (wish.kind == RequirementKind::color) apply_color(look, wish, sources.catalog);
    if (wish.kind != RequirementKind::light) continue;
    (wish.subject == "light_lux" ? look.light_lux : look.light_kelvin) =
        static_cast<int>(std::lround(wish.value));
  }
  return look;
}

std::optional<std::string> shelf_color(const Understanding& understanding) {
  const Requirement* wish = understanding.find(RequirementKind::color, "fixture");
  return wish != nullptr ? std::optional(wish->object) : std::nullopt;
}

}  // namespace marketgen
