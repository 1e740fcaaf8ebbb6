#include "intake/plan_look.h"

#include <cmath>

#include "intake/materials.h"
#include "plan/style_look.h"

namespace marketgen::intake {
namespace {

// The look that goes with a kind of shop, when nobody names one.
struct UsualStyle {
  std::string_view profile, style;
};
constexpr UsualStyle usual_styles[] = {{"discounter", "discount"},
                                       {"organic-eu", "organic"},
                                       {"supermarket-us", "classic"},
                                       {"convenience-cn", "modern"}};

const catalog::StyleRow& style_of(const PlanSources& sources) {
  const catalog::Catalog& catalog = sources.catalog;
  const plan::Requirement* wish = sources.understanding.find(plan::RequirementKind::style);
  std::string name = "modern";
  for (const UsualStyle& usual : usual_styles) {
    if (usual.profile == sources.program.profile->id) name = usual.style;
  }
  if (wish != nullptr) name = wish->object;
  if (sources.brief.style) name = *sources.brief.style;
  const catalog::StyleRow* row = catalog.style(name);
  return row != nullptr ? *row : catalog.styles.front();
}

void apply_material(plan::Look& look, const plan::Requirement& wish) {
  if (wish.subject == "floor") look.floor = wish.object;
  if (wish.subject == "wall") look.wall = wish.object;
  if (wish.subject == "ceiling") look.ceiling = wish.object;
  if (wish.subject == "fixture") look.fixture = wish.object;
}

void apply_color(plan::Look& look, const plan::Requirement& wish, const catalog::Catalog& catalog) {
  if (wish.subject == "accent") look.accent = wish.object;
  if (wish.subject != "fixture") return;
  const catalog::MaterialRow* nearest = nullptr;
  for (const catalog::MaterialRow& row : catalog.materials) {
    const bool painted = row.id.starts_with("metal-");
    if (!painted) continue;
    const double apart = color_distance(row.color, wish.object);
    if (nearest == nullptr || apart < color_distance(nearest->color, wish.object)) nearest = &row;
  }
  if (nearest != nullptr) look.fixture = nearest->id;
}

void apply_photographed(plan::Look& look, const PhotoWishes& shown) {
  if (shown.floor) look.floor = shown.floor->value;
  if (shown.wall) look.wall = shown.wall->value;
  if (shown.ceiling) look.ceiling = shown.ceiling->value;
  if (shown.fixture) look.fixture = shown.fixture->value;
  if (shown.lamps) look.lamps = shown.lamps->value;
  if (shown.light_kelvin) look.light_kelvin = shown.light_kelvin->value;
}

}  // namespace

plan::Look look_of(const PlanSources& sources) {
  plan::Look look = plan::look_of(style_of(sources));
  apply_photographed(look, sources.understanding.photographed);
  for (const plan::Requirement& wish : sources.understanding.requirements) {
    if (wish.kind == plan::RequirementKind::material) apply_material(look, wish);
    if (wish.kind == plan::RequirementKind::color) apply_color(look, wish, sources.catalog);
    if (wish.kind != plan::RequirementKind::light) continue;
    (wish.subject == "light_lux" ? look.light_lux : look.light_kelvin) =
        static_cast<int>(std::lround(wish.value));
  }
  return look;
}

std::optional<std::string> shelf_color(const Understanding& understanding) {
  const plan::Requirement* wish = understanding.find(plan::RequirementKind::color, "fixture");
  return wish != nullptr ? std::optional(wish->object) : std::nullopt;
}

}  // namespace marketgen::intake
