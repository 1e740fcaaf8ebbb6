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
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "geometry/image.h"
#include "geometry/pose.h"
#include "geometry/vector.h"
#include "render/cameras/camera.h"
#include "render/matter.h"
#include "render/stage/actor.h"
#include "scene/scene.h"

namespace marketgen::render {

// sensor: stored light, no chance and so no noise, a tenth of a second; path: light transport in
// full, `samples` a pixel.
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

struct RendererOptions {
  PrintDetail print = PrintDetail::near;
  // Whether baked light is kept on disk between runs (light_cache.h): another renderer of the same
  // store and look need not bake it again.
  bool keep_light = false;
};

struct RenderOptions {
  RenderMode mode = RenderMode::sensor;
  Quality quality = Quality::balanced;
  int samples = 0;    // per pixel; 0 = what the quality says
  double time_s = 0;  // path mode: stop adding samples after this long; 0 = no limit (then not
                      // reproducible if set)
  bool hide_ceiling = false;                // for views from above
  Denoiser denoiser = Denoiser::automatic;  // path mode
  double exposure_stops = 0;                // path mode: brighter (+) or darker than the store asks
  // By how much each channel's light (linear, Rec. 709) is more than what the camera is set to: see
  // sensor/lamp_light.h. Everything that shines is taken for the lamps', daylight too.
  Vec3f light{1, 1, 1};
};

// Planes are row-major from the top left, one entry a pixel.
struct Frame {
  Image color;                          // sRGB, tone mapped
  std::vector<float> depth_m;           // along the optical axis; 0 = nothing hit
  std::vector<std::uint32_t> instance;  // what is seen, by number: see picture_objects.h
  std::vector<float> normals;           // world frame, 3 a pixel
  std::vector<std::uint8_t> matter;     // Matter of what is met first
  std::vector<float> radiance;          // path mode: linear RGB (Rec. 709) in cd/m2, 3 a pixel
};

// A caller's memory for one picture, row-major from the top left; null: not wanted. As the planes
// of Frame.
struct FrameBuffers {
  std::uint8_t* rgb = nullptr;        // 3 a pixel
  float* depth_m = nullptr;           // 1
  std::uint32_t* instance = nullptr;  // 1
  float* normals = nullptr;           // 3
  std::uint8_t* matter = nullptr;     // 1, a Matter
};

// What one object would cover of a picture with nothing before it.
struct Silhouette {
  std::uint32_t object = 0;  // number in Frame::instance
  // Of the picture; those that show the object are among them. Nothing for fixtures, whose price
  // labels are part of the room's mesh.
  std::optional<int> pixels;
  // x0, y0, x1, y1 in pixels from the picture's top left corner, around the whole object even where
  // it leaves the picture; nothing when a part of it lies behind the camera.
  std::optional<std::array<double, 4>> box_px;
};

// A product that does not stand where the scene has it, and a joint of a fixture (a door, a drawer)
// that is not at rest: radians or metres, see scene/articulation.h.
struct MovedProduct {
  std::uint32_t product = 0;  // row in Scene::products
  Pose world_from_product;
};
struct MovedJoint {
  std::uint32_t joint = 0;  // row in Scene::joints
  double position = 0;
};

class Renderer {
 public:
  static Result<std::unique_ptr<Renderer>> create(const scene::Scene& scene,
                                                  Progress& progress = silent_progress(),
                                                  const RendererOptions& options = {});
  virtual ~Renderer() = default;
  // What stands in the pictures from now on, instead of the actors before; none at first. Costs
  // milliseconds a robot. Errors: render.bad_actor, and nothing has changed; io.out_of_memory.
  virtual Result<void> set_actors(const std::vector<Actor>& actors) = 0;
  // Moves all bodies of actors[actor]: one pose each, in their order, store frame. Microseconds.
  // Error: render.bad_actor, and nothing has moved.
  virtual Result<void> move_actor(std::size_t actor, std::span<const Pose> world_from_body) = 0;
  // Where products and joints stand from now on; all that are not named stand as the scene has
  // them. The same ones as before cost microseconds, others a fraction of a millisecond (some in a
  // small store, whose search tree is built anew). The stored light stays what it was. Errors:
  // render.bad_move (no such row, one named twice, a pose or position that is not finite), and
  // nothing has moved.
  virtual Result<void> move_things(std::span<const MovedProduct> products,
                                   std::span<const MovedJoint> joints) = 0;
  // The products that move_things() named last.
  virtual std::span<const MovedProduct> moved_products() const = 0;
  // Errors: camera.* of check_camera(). An eye inside a thing sees it from within, and one outside
  // the store sees what there is to see from there: check_viewpoint() says so beforehand. The scene
  // must outlive the renderer.
  virtual Result<Frame> render(const Camera& camera,
                               const RenderOptions& options,
                               Progress& progress = silent_progress()) = 0;
  // Of objects but the room in the picture `frame` that `camera` took of the actors as they stand
  // now, in the order of `objects`.
  virtual std::vector<Silhouette> silhouettes(const Camera& camera,
                                              const Frame& frame,
                                              std::span<const std::uint32_t> objects) const = 0;
};

// One camera of one world in a batch. The renderers may be the same or not.
struct Shot {
  Renderer* renderer = nullptr;
  Camera camera;
  FrameBuffers to;  // each that is there holds the whole picture
};
// Sensor mode: all of them side by side on all threads, into their callers' memory. Pixels are
// those of Renderer::render(). Errors: camera.* with the shot's number, before anything is written;
// internal.interrupted, and buffers are incomplete.
Result<void> render_batch(std::span<const Shot> shots,
                          const RenderOptions& options,
                          Progress& progress = silent_progress());

// A colour per object number for looking at segmentation; numbers may share one.
std::array<std::uint8_t, 3> object_color(std::uint32_t object);
Image draw_instances(const Frame& frame, int width, int height);
Image draw_normals(const Frame& frame, int width, int height);

// The Embree version in use, "3.13.5".
std::string renderer_version();

}  // namespace marketgen::render
