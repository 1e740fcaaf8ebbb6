// Plans from anywhere: a valid plan is written and read back unchanged and has ground for every
// zone, or there is an error.
#include <cstdint>
#include <cstdlib>
#include <string>

#include "io/file.h"
#include "io/json.h"
#include "plan/bsp.h"
#include "plan/plan.h"

namespace {

const marketgen::catalog::Catalog& rows() {
  static const marketgen::catalog::Catalog catalog = [] {
    const auto folder = marketgen::io::data_folder();
    if (!folder.ok()) marketgen::fatal(to_string(folder.error()).c_str());
    auto loaded = marketgen::catalog::load_catalog(*folder);
    if (!loaded.ok()) marketgen::fatal(to_string(loaded.error()).c_str());
    return std::move(loaded).value();
  }();
  return catalog;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace marketgen;
  const auto plan = plan::read_plan({reinterpret_cast<const char*>(data), size}, "fuzz", rows());
  if (!plan.ok()) return 0;
  const std::string text = io::write_json(*plan);
  const auto again = plan::read_plan(text, "fuzz", rows());
  if (!again.ok() || io::write_json(*again) != text) std::abort();
  for (const RectMm& ground : plan::zone_rectangles(*plan)) {
    if (ground.width() < plan::min_node_side_mm || ground.depth() < plan::min_node_side_mm)
      std::abort();
  }
  return 0;
}
