// `marketgen assets heaps`: the rows of data/heaps.json, settled anew.
#pragma once
#include <string>

#include "base/result.h"
#include "catalog/catalog.h"
#include "command.h"

namespace marketgen::app {

// Settles a heap of every shape and size of loose, round goods and writes the rows to `file`, one a
// line. Those that are finished when it is broken off are kept beside it; `resume` goes on with
// them. Errors: physics.failed, io.*; internal.interrupted, with what is kept; usage.bad_flag when
// what was kept is of another catalogue or version.
Result<void> settle_heaps(const catalog::Catalog& catalog,
                          const std::string& file,
                          bool resume,
                          const CommonFlags& flags);

}  // namespace marketgen::app
