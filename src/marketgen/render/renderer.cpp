// Renderer: the world, its light, and the two ways to make a picture of it.
#include <algorithm>
#include <cmath>

#include "base/interrupt.h"
#include "base/parallel.h"
#include "render/actor_stage.h"
#include "render/build_world.h"
#include "render/exhibit.h"
#include "render/filter.h"
#include "render/path_picture.h"
#include "render/picture_objects.h"
#include "render/render.h"
#include "render/resolve.h"
#include "render/shading_math.h"

namespace marketgen {
namespace raytrace {
namespace {

// What a quality buys in sensor mode: light samples a pixel, extra samples on edges, filter passes.
struct Effort {
  int light_samples, edge_samples, filter_passes;
};

Effort effort_of(Quality quality) {
  switch (quality) {
    case Quality::fast:
      return {1, 3, 4};
    case Quality::balanced:
      return {2, 4, 4};
    case Quality::best:
      return {8, 8, 3};
  }
  return {2, 4, 4};
}

constexpr float meter_share = 0.75F;

class EmbreeRenderer : public Renderer {
 public:
  EmbreeRenderer(std::unique_ptr<World> world, const Scene& scene)
      : world_(std::move(world)),
        lights_(*world_),
        field_(*world_, lights_, scene),
        panels_(*world_),
        actors_(*world_, first_actor_object(scene)),
        lighting_{*world_, lights_, field_, panels_} {
    // Exposed by the light meter, but not all the way: a dim shop should look dimmer than a bright
    // one.
    const float metered = field_.floor_mean();
    const float meant = pi / world_->exposure;  // irradiance that the look asks for
    if (metered > 0) world_->exposure *= std::pow(meant / metered, meter_share);
  }

  Result<void> set_actors(const std::vector<Actor>& actors) override { return actors_.set(actors); }

  Result<void> move_actor(std::size_t actor, std::span<const Pose> world_from_body) override {
    return actors_.move(actor, world_from_body);
  }

  Result<Frame> render(const Camera& camera,
                       const RenderOptions& options,
                       Progress& progress) override {
    MARKETGEN_CHECK(check_camera(camera, camera.name.empty() ? "camera" : camera.name));
    const View view(camera);
    if (options.mode == RenderMode::path)
      return path_picture({*world_, lights_, field_}, view, options, progress);
    const unsigned mask = options.hide_ceiling ? mask_solid : mask_opaque;
    Film film(camera.width, camera.height);
    light_sensor(view, options, mask, film, progress);
    MARKETGEN_CHECK(check_interrupt());
    const Planes3 radiance =
        resolve_edges(lighting_, view, film, mask, effort_of(options.quality).edge_samples);
    return frame_of(std::move(film), radiance);
  }

 private:
  template <class Body>
  void for_tiles(const View& view,
                 Progress& progress,
                 std::string_view stage,
                 const Body& body) const {
    const auto count =
        static_cast<std::size_t>(tiles_across(view)) * static_cast<std::size_t>(tiles_down(view));
    progress.begin(stage, count);
    parallel_for(count, [&](std::size_t i) {
      if (check_interrupt().ok()) body(static_cast<int>(i));
      progress.advance();
    });
    progress.end();
  }

  void light_sensor(const View& view,
                    const RenderOptions& options,
                    unsigned mask,
                    Film& film,
                    Progress& progress) const {
    const Effort effort = effort_of(options.quality);
    const int samples = options.samples > 0 ? options.samples : effort.light_samples;
    for_tiles(view, progress, "picture", [&](int index) {
      const auto tile = std::make_unique<Tile>();
      find_first_hits(*world_, view, index, mask, *tile);
      store_first_hits(*world_, view, *tile, film);
      light_tile(lighting_, view, *tile, samples, film);
    });
    smooth(film, film.irradiance, {effort.filter_passes, 8.0F, false});
    remove_sparkles(film, film.gloss);
    smooth(film, film.gloss, {effort.filter_passes - 1, 24.0F, true});
  }

  Frame frame_of(Film film, const Planes3& radiance) const {
    Frame frame;
    frame.color = develop(radiance, film.width, film.height, world_->exposure);
    frame.depth_m = std::move(film.depth);
    frame.instance = std::move(film.instance);
    frame.normals.resize(film.normal.axis[0].size() * 3);
    for (std::size_t i = 0; i < frame.depth_m.size(); ++i) {
      if (frame.depth_m[i] <= 0) continue;  // nothing was hit: no normal
      for (std::size_t a = 0; a < 3; ++a)
        frame.normals[3 * i + a] = film.normal.axis[a][i];
    }
    return frame;
  }

  std::unique_ptr<World> world_;
  LightGrid lights_;
  IrradianceField field_;
  PanelReflection panels_;
  ActorStage actors_;
  Lighting lighting_;
};

}  // namespace

Result<std::unique_ptr<Renderer>> create_renderer(const Scene& scene,
                                                  const std::vector<Exhibit>& exhibits,
                                                  Progress& progress,
                                                  PrintDetail print) {
  MARKETGEN_TRY(std::unique_ptr<World> world, build_world(scene, exhibits, progress, print));
  return std::unique_ptr<Renderer>(std::make_unique<EmbreeRenderer>(std::move(world), scene));
}

}  // namespace raytrace

Result<std::unique_ptr<Renderer>> Renderer::create(const Scene& scene,
                                                   Progress& progress,
                                                   PrintDetail print) {
  return raytrace::create_renderer(scene, {}, progress, print);
}

}  // namespace marketgen
