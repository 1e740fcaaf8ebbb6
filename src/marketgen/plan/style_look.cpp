#include "plan/style_look.h"

#include "base/text.h"

namespace marketgen {

Look look_of(const StyleRow& style) {
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

Result<const StyleRow*> style_called(const Catalog& catalog,
                                     std::string_view name,
                                     std::string where) {
  if (const StyleRow* style = catalog.style(name)) return style;
  std::vector<std::string_view> known;
  for (const StyleRow& row : catalog.styles)
    known.push_back(row.id);
  return unknown_name("catalog.unknown_kind", std::move(where), "style", name, known);
}

}  // namespace marketgen
