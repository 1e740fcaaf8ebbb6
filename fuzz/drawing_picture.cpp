// A picture from anywhere as a floor plan: the first two bytes are its size, the rest its pixels.
#include <algorithm>
#include <cstdint>
#include <cstdlib>

#include "drawing/floor_plan.h"
#include "geometry/image.h"
#include "io/png.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace marketgen;
  if (size < 3) return 0;
  constexpr int least = 60, more = 64;
  Image image(least + data[0] % more, least + data[1] % more);
  for (std::size_t i = 0; i < image.pixels.size(); ++i)
    image.pixels[i] = data[2 + i / 9 % (size - 2)];
  drawing::ReadOptions options;
  options.scale = drawing::Scale{200, 0};
  const auto png = io::encode_png(image);
  const auto plan = drawing::read_floor_plan_bytes(png.value(), "fuzz", options);
  if (plan.ok() && plan->shell.width_mm > 200000) std::abort();
  return 0;
}
