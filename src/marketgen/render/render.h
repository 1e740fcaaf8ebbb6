// Pictures of a scene by ray tracing (Embree): colour, depth, segmentation, normals.
//
// A Renderer holds what is built once per scene (geometry, BVHs, textures, lights). Robots and
// other actors are put into it and moved between pictures without building any of that anew. Its
// functions may be called many times, from one thread at a time. Pixels are identical for any
// thread count.
#pragma once
#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "geometry/image.h"
#include "geometry/pose.h"
#include "render/actor.h"
#include "render/camera.h"
#include "scene/scene.h"

namespace marketgen {

// sensor: one bounce, noise-filtered, seconds; path: full path tracing, `samples` a pixel.
enum class RenderMode { sensor, path };
constexpr std::array<std::string_view, 2> names_of(RenderMode) {
  return {"sensor", "path"};
}
enum class Quality { fast, balanced, best };
constexpr std::array<std::string_view, 3> names_of(Quality) {
  return {"fast", "balanced", "best"};
}

// What takes the noise out of path-traced pictures. automatic: neural where Open Image Denoise is
// installed (see neural_denoise.h), else own.
enum class Denoiser { automatic, own, neural, none };
constexpr std::array<std::string_view, 4> names_of(Denoiser) {
  return {"auto", "own", "neural", "none"};
}

// How finely the print on packs is drawn. near: for cameras that come as close as a hand does;
// distant: a quarter as fine (price labels a third), for pictures whose pixels cover 2 mm of a pack
// or more, as previews.
enum class PrintDetail { near, distant };

struct RenderOptions {
  RenderMode mode = RenderMode::sensor;
  Quality quality = Quality::balanced;
  int samples = 0;    // per pixel; 0 = what the quality says
  double time_s = 0;  // path mode: stop adding samples after this long; 0 = no limit (then not
                      // reproducible if set)
  bool hide_ceiling = false;                // for views from above
  Denoiser denoiser = Denoiser::automatic;  // path mode
  double exposure_stops = 0;                // path mode: brighter (+) or darker than the store asks
};

// Planes are row-major from the top left, one entry a pixel.
struct Frame {
  Image color;                          // sRGB, tone mapped
  std::vector<float> depth_m;           // along the optical axis; 0 = nothing hit
  std::vector<std::uint32_t> instance;  // what is seen, by number: see picture_objects.h
  std::vector<float> normals;           // world frame, 3 a pixel
  std::vector<float> radiance;          // path mode: linear RGB (Rec. 709) in cd/m2, 3 a pixel
};

class Renderer {
 public:
  static Result<std::unique_ptr<Renderer>> create(const Scene& scene,
                                                  Progress& progress = silent_progress(),
                                                  PrintDetail print = PrintDetail::near);
  virtual ~Renderer() = default;
  // What stands in the pictures from now on, instead of the actors before; none at first. Costs
  // milliseconds a robot. Errors: render.bad_actor, and nothing has changed; io.out_of_memory.
  virtual Result<void> set_actors(const std::vector<Actor>& actors) = 0;
  // Moves all bodies of actors[actor]: one pose each, in their order, store frame. Microseconds.
  // Error: render.bad_actor, and nothing has moved.
  virtual Result<void> move_actor(std::size_t actor, std::span<const Pose> world_from_body) = 0;
  // Errors: camera.*. The scene must outlive the renderer.
  virtual Result<Frame> render(const Camera& camera,
                               const RenderOptions& options,
                               Progress& progress = silent_progress()) = 0;
};

// A colour per object number for looking at segmentation; numbers may share one.
std::array<std::uint8_t, 3> object_color(std::uint32_t object);
Image draw_instances(const Frame& frame, int width, int height);
Image draw_normals(const Frame& frame, int width, int height);

// The Embree version in use, "3.13.5".
std::string renderer_version();

}  // namespace marketgen
