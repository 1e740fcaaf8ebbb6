#include "render/render.h"
#include "bench/bench.h"
#include "bench/sample_store.h"
#include "scene/scene_file.h"

namespace marketgen::bench {

Figures run_render(const Catalog& catalog) {
  const ScratchFolder scratch;
  MARKETGEN_TRY(const Created created,
                create_store(neighbourhood_store(scratch / "store", false), catalog));
  MARKETGEN_TRY(const Scene scene, open_scene(scratch / "store" / "scene.bin"));
  const double create_s = median_seconds(3, [&] { (void)Renderer::create(scene).ok(); });
  MARKETGEN_TRY(const std::unique_ptr<Renderer> renderer, Renderer::create(scene));

  std::vector<Figure> figures{
      {"renderer_create_s", create_s, "s", 3, std::nullopt, std::nullopt, machine_name()}};
  for (const Quality quality : {Quality::fast, Quality::balanced, Quality::best}) {
    MARKETGEN_TRY(const Camera camera, camera_named(scene, "aisle", 640, 480));
    RenderOptions options;
    options.quality = quality;
    constexpr int runs = 5;
    const double seconds =
        median_seconds(runs, [&] { (void)renderer->render(camera, options).ok(); });
    figures.push_back({"render_640x480_" + std::string(name_of(quality)) + "_s",
                       seconds,
                       "s",
                       runs,
                       std::nullopt,
                       std::nullopt,
                       machine_name()});
  }
  return figures;
}

}  // namespace marketgen::bench
