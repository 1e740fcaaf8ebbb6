// `marketgen assets show` of a fixture kind: its row, its joints, and a picture of it with its
// joints where they were asked to be.
#pragma once
#include <string>
#include <vector>

#include "base/result.h"
#include "catalog/catalog.h"
#include "io/output.h"

namespace marketgen::app {

struct FixtureView {
  std::vector<std::string> joints;  // "door-1=open", "till=0.2", "all=open"
  std::string picture;              // PNG or JPEG; empty: none
  int size_px = 400;
};

// Prints JSON; the picture becomes one of `outputs`. "all=STATE" puts every joint there that has
// such a state. Errors: usage.bad_flag, catalog.*, assets.*, io.*.
Result<void> show_fixture(const catalog::FixtureKind& kind,
                          const catalog::Catalog& catalog,
                          const FixtureView& view,
                          io::Outputs& outputs);

}  // namespace marketgen::app
