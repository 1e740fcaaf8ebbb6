#include "render/stage/build_world.h"

#include "render/light/lamp.h"
#include "render/picture_objects.h"
#include "render/stage/build_ceiling.h"
#include "render/stage/build_decor.h"
#include "render/stage/build_fixtures.h"
#include "render/stage/build_light.h"
#include "render/stage/build_products.h"
#include "render/stage/build_shell.h"
#include "render/stage/build_signage.h"

namespace marketgen::render::raytrace {

namespace {

void add_exhibits(World& world,
                  const std::vector<Exhibit>& exhibits,
                  const std::vector<std::uint16_t>& materials) {
  for (std::size_t i = 0; i < exhibits.size(); ++i) {
    TracedMesh mesh;
    append(mesh.solid, mesh.glass, exhibits[i].mesh, {materials[i]}, world, {});
    Instance instance;
    instance.mesh = static_cast<std::uint32_t>(world.meshes.size());
    instance.id = first_fixture_object;  // as the first thing in the room
    world.meshes.push_back(std::move(mesh));
    world.instances.push_back(instance);
  }
}

// All but the search trees. What has built it is gone with it, before these are made.
Result<void> furnish(World& world,
                     const scene::Scene& scene,
                     const std::vector<Exhibit>& exhibits,
                     Progress& progress,
                     const WorldDetail& detail) {
  Draft draft(scene, world, detail);
  const Room room = room_of(scene.layout.shell);
  MARKETGEN_TRY(const ProductBuilder products, ProductBuilder::begin(draft, detail.goods));
  FixtureBuilder fixtures(draft);
  const ShellBuilder shell(draft, room);
  const LightBuilder light(draft);
  const PriceLabelBuilder price_labels(draft);
  const SignBuilder signs(draft, room);
  const BoardLetters letters(draft);
  const CeilingBuilder services(draft, room);
  const DecorBuilder decor(draft, room);
  std::vector<std::uint16_t> exhibited;
  for (const Exhibit& exhibit : exhibits)
    exhibited.push_back(draft.tiled_material(exhibit.material));
  MARKETGEN_CHECK(draft.draw_textures(progress));

  progress.begin("geometry", 3);
  shell.build(draft);
  light.build(draft, room);
  price_labels.build(draft);
  signs.build(draft);
  services.build(draft);
  decor.build(draft);
  fixtures.build(draft);
  letters.build(draft);
  products.build(draft);
  add_exhibits(world, exhibits, exhibited);
  return {};
}

}  // namespace

Result<std::unique_ptr<World>> build_world(const scene::Scene& scene,
                                           const std::vector<Exhibit>& exhibits,
                                           Progress& progress,
                                           const WorldDetail& detail) {
  auto world = std::make_unique<World>();
  world->device.reset(rtcNewDevice(nullptr));
  if (!world->device)
    return Error{"io.out_of_memory", "renderer", "Embree could not be started on this machine"};

  MARKETGEN_CHECK(furnish(*world, scene, exhibits, progress, detail));
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

}  // namespace marketgen::render::raytrace
