// `marketgen assets heaps`: the rows of data/heaps.json, settled anew.
#pragma once
#include <string>

#include "base/result.h"
#include "catalog/catalog.h"
#include "command.h"

namespace marketgen::app {

// Settles a heap of every shape and size of loose, round goods and writes the rows to `file`, one a
// line. Errors: physics.failed, io.*.
Result<void> settle_heaps(const Catalog& catalog,
                          const std::string& file,
                          const CommonFlags& flags);

}  // namespace marketgen::app
