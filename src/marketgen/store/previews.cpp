#include "store/previews.h"

#include "base/interrupt.h"
#include "io/png.h"
#include "render/render.h"

namespace marketgen {

Result<void> draw_previews(const Scene& scene,
                           const std::filesystem::path& folder,
                           Progress& progress) {
  MARKETGEN_TRY(const std::unique_ptr<Renderer> renderer,
                Renderer::create(scene, progress, {.print = PrintDetail::distant}));
  for (const char* name : {"top", "entrance", "aisle", "checkout"}) {
    MARKETGEN_CHECK(check_interrupt());
    MARKETGEN_TRY(const Camera camera,
                  camera_named(scene, name, preview_width_px, preview_height_px));
    RenderOptions options;
    options.quality = Quality::fast;
    options.hide_ceiling = camera.ortho_height_m > 0;
    MARKETGEN_TRY(const Frame frame, renderer->render(camera, options, progress));
    MARKETGEN_CHECK(write_png(folder / (std::string(name) + ".png"), frame.color));
  }
  return {};
}

}  // namespace marketgen
