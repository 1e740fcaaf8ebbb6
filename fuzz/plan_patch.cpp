// Patches from anywhere, on a plan that is valid: the outcome is valid and can be written and read,
// or there is an error that names the patches.
#include <cstdint>
#include <cstdlib>
#include <string>

#include "io/file.h"
#include "io/json.h"
#include "plan/bsp.h"
#include "plan/patch.h"

namespace {

constexpr const char* corner = R"({
  "shell": {"width_mm": 20000, "depth_mm": 15000,
    "openings": [{"id": "in", "kind": "entrance", "wall": "south", "center": 0.25, "width_mm": 2000}]},
  "schema": "market-plan/1",
  "nodes": [{"id": "root", "split": "y", "ratio": 0.4, "gap_mm": 2000, "children": ["front", "back"]},
            {"id": "front", "zone": "tills"},
            {"id": "back", "split": "x", "ratio": 0.5, "gap_mm": 1800, "children": ["west", "east"]},
            {"id": "west", "zone": "snacks"}, {"id": "east", "zone": "dairy"}],
  "zones": [{"id": "tills", "type": "checkout", "fixture": {"kind": "checkout_lane"}},
            {"id": "snacks", "type": "snacks"}, {"id": "dairy", "type": "dairy",
             "fixture": {"kind": "multideck"}}]})";

struct Ground {
  marketgen::catalog::Catalog rows;
  marketgen::plan::Plan plan;
};

const Ground& ground() {
  static const Ground made = [] {
    const auto folder = marketgen::io::data_folder();
    if (!folder.ok()) marketgen::fatal(to_string(folder.error()).c_str());
    auto rows = marketgen::catalog::load_catalog(*folder);
    if (!rows.ok()) marketgen::fatal(to_string(rows.error()).c_str());
    auto plan = marketgen::plan::read_plan(corner, "corner", *rows);
    if (!plan.ok()) marketgen::fatal(to_string(plan.error()).c_str());
    return Ground{std::move(rows).value(), std::move(plan).value()};
  }();
  return made;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace marketgen;
  const auto set = plan::read_patches({reinterpret_cast<const char*>(data), size}, "fuzz");
  if (!set.ok()) return 0;
  const auto plan =
      plan::apply_patches(ground().plan, *set, "fuzz", plan::Source::flag, ground().rows);
  if (!plan.ok()) {
    if (!plan.error().where.starts_with("fuzz:")) std::abort();
    return 0;
  }
  const std::string text = io::write_json(*plan);
  const auto again = plan::read_plan(text, "fuzz", ground().rows);
  if (!again.ok() || io::write_json(*again) != text) std::abort();
  for (const RectMm& rect : plan::zone_rectangles(*plan)) {
    if (rect.width() < plan::min_node_side_mm || rect.depth() < plan::min_node_side_mm)
      std::abort();
  }
  return 0;
}
