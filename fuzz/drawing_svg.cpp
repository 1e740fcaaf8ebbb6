// A SVG from anywhere: either a shell that a plan may have or an error.
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "drawing/floor_plan.h"
#include "drawing/sketch.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace marketgen;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  if (!drawing::read_svg(text, "fuzz").ok()) return 0;
  drawing::ReadOptions options;
  options.width_mm = 24000;
  const auto plan = drawing::read_floor_plan_bytes(text, "fuzz", options);
  if (!plan.ok()) return 0;
  const plan::Shell& shell = plan->shell;
  if (shell.width_mm < 4000 || shell.width_mm > 200000 || shell.openings.size() > 40) std::abort();
  if (shell.outline_mm && shell.outline_mm->size() > 200) std::abort();
  return 0;
}
