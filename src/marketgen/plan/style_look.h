// The look that a row of the catalogue's styles describes.
#pragma once
#include <string>
#include <string_view>

#include "catalog/catalog.h"
#include "plan/plan.h"

namespace marketgen::plan {

Look look_of(const catalog::StyleRow& style);

// The style called `name`. Error: catalog.unknown_kind at `where`, with the nearest name.
Result<const catalog::StyleRow*> style_called(const catalog::Catalog& catalog,
                                              std::string_view name,
                                              std::string where);

}  // namespace marketgen::plan
