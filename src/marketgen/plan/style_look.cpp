#include "plan/style_look.h"

#include "base/text.h"

namespace marketgen::plan {

Look look_of(const catalog::StyleRow& style) {
  return {style.floor,
          style.wall,
          style.ceiling,
          style.fixture,
          style.accent,
          style.light_kelvin,
          style.light_lux,
          style.lamps,
          style.daylight,
          style.neon};
}

Result<const catalog::StyleRow*> style_called(const catalog::Catalog& catalog,
                                              std::string_view name,
                                              std::string where) {
  if (const catalog::StyleRow* style = catalog.style(name)) return style;
  std::vector<std::string_view> known;
  for (const catalog::StyleRow& row : catalog.styles)
    known.push_back(row.id);
  return catalog::unknown_name("catalog.unknown_kind", std::move(where), "style", name, known);
}

}  // namespace marketgen::plan
