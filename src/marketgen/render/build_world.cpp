#include "render/build_world.h"

#include "render/build_fixtures.h"
#include "render/build_light.h"
#include "render/build_products.h"
#include "render/build_shell.h"
#include "render/build_signage.h"
#include "render/lamp.h"

namespace marketgen::raytrace {

Result<std::unique_ptr<World>> build_world(const Scene& scene, Progress& progress) {
  auto world = std::make_unique<World>();
  world->device.reset(rtcNewDevice(nullptr));
  if (!world->device)
    return Error{"io.out_of_memory", "renderer", "Embree could not be started on this machine"};

  Draft draft(scene, *world);
  const Room room = room_of(scene.layout.shell);
  MARKETGEN_TRY(const ProductBuilder products, ProductBuilder::begin(draft));
  const FixtureBuilder fixtures(draft);
  const ShellBuilder shell(draft, room);
  const LightBuilder light(draft);
  const PriceLabelBuilder price_labels(draft);
  const SignBuilder signs(draft, room);
  MARKETGEN_CHECK(draft.draw_textures(progress));

  progress.begin("geometry", 3);
  shell.build(draft);
  light.build(draft, room);
  price_labels.build(draft);
  signs.build(draft);
  fixtures.build(draft);
  products.build(draft);
  progress.advance();
  commit(*world);
  progress.advance();
  switch_on_lamps(*world);
  progress.end();
  if (rtcGetDeviceError(world->device.get()) != RTC_ERROR_NONE) {
    return Error{"io.out_of_memory",
                 "renderer",
                 "Embree could not build its search trees; is there enough memory?"};
  }
  return world;
}

}  // namespace marketgen::raytrace
