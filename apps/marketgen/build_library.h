// `marketgen assets build`: every label sheet drawn and kept, before any store asks for it.
#pragma once
#include "base/result.h"
#include "catalog/catalog.h"
#include "command.h"

namespace marketgen::app {

// Prints counts, seconds and megabytes, as JSON when asked. Errors: assets.*; io.* after that, when
// not all could be kept.
Result<void> build_library(const catalog::Catalog& catalog, const CommonFlags& flags);

}  // namespace marketgen::app
