#include "store/previews.h"

#include "base/interrupt.h"
#include "io/png.h"
#include "render/render.h"

namespace marketgen::store {

Result<void> draw_previews(const scene::Scene& scene,
                           const std::filesystem::path& folder,
                           Progress& progress) {
  MARKETGEN_TRY(const std::unique_ptr<render::Renderer> renderer,
                render::Renderer::create(scene, progress, {.print = render::PrintDetail::distant}));
  for (const char* name : {"top", "entrance", "aisle", "checkout"}) {
    MARKETGEN_CHECK(check_interrupt());
    MARKETGEN_TRY(const render::Camera camera,
                  render::camera_named(scene, name, preview_width_px, preview_height_px));
    render::RenderOptions options;
    options.quality = render::Quality::fast;
    options.hide_ceiling = camera.ortho_height_m > 0;
    MARKETGEN_TRY(const render::Frame frame, renderer->render(camera, options, progress));
    MARKETGEN_CHECK(io::write_png(folder / (std::string(name) + ".png"), frame.color));
  }
  return {};
}

}  // namespace marketgen::store
