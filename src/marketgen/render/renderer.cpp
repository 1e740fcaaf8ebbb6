// Renderer: the world, its light, and the two ways to make a picture of it.
#include <algorithm>
#include <cmath>

#include "base/interrupt.h"
#include "base/parallel.h"
#include "render/actor_stage.h"
#include "render/build_world.h"
#include "render/displaced.h"
#include "render/exhibit.h"
#include "render/filter.h"
#include "render/first_hits.h"
#include "render/path.h"
#include "render/picture_objects.h"
#include "render/render.h"
#include "render/resolve.h"
#include "render/sensor_picture.h"
#include "render/shading_math.h"
#include "render/silhouette.h"

namespace marketgen {
namespace raytrace {
namespace {

int paths_of(Quality quality) {
  switch (quality) {
    case Quality::fast:
      return 16;
    case Quality::balanced:
      return 64;
    case Quality::best:
      return 256;
  }
  return 64;
}

constexpr float shelf_search_m = 0.03F;  // above a product's foot: it stands on the board's face
constexpr float meter_share = 0.75F;
constexpr int few_paths = 128;     // below, pictures need a stronger filter
constexpr int paths_per_pass = 8;  // between looks at the clock

class EmbreeRenderer : public Renderer {
 public:
  EmbreeRenderer(std::unique_ptr<World> world, const Scene& scene)
      : scene_(scene),
        world_(std::move(world)),
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

  Result<void> move_things(std::span<const MovedProduct> products,
                           std::span<const MovedJoint> joints) override {
    MARKETGEN_CHECK(check_moves(scene_, products, joints));
    std::vector<Displaced> rows;
    for (const MovedProduct& moved : products) {
      const Placement place = placement_of(moved.world_from_product);
      rows.push_back({world_->first_product_instance + moved.product,
                      field_.shelf_at(place({0, 0, shelf_search_m})),
                      place});
    }
    add_moved_joints(*world_, scene_, joints, rows);
    return actors_.displace(std::move(rows));
  }

  SensorShot shot(const Camera& camera, const FrameBuffers& to) const {
    return {&lighting_, View(camera), to};
  }

  std::vector<Silhouette> silhouettes(const Camera& camera,
                                      const Frame& frame,
                                      std::span<const std::uint32_t> objects) const override {
    return silhouettes_of(*world_, camera, frame, objects);
  }

  Result<Frame> render(const Camera& camera,
                       const RenderOptions& options,
                       Progress& progress) override {
    MARKETGEN_CHECK(check_camera(camera, camera.name.empty() ? "camera" : camera.name));
    const View view(camera);
    if (options.mode == RenderMode::sensor) return sensor_frame(view, options, progress);
    const unsigned mask = options.hide_ceiling ? mask_solid : mask_opaque;
    Film film(camera.width, camera.height);
    Planes3 radiance(0);
    trace_paths(view, options, mask, film, progress);
    MARKETGEN_CHECK(check_interrupt());
    radiance = resolve_edges(lighting_, view, film, mask, 0);
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

  Result<Frame> sensor_frame(const View& view,
                             const RenderOptions& options,
                             Progress& progress) const {
    Frame frame;
    const auto count =
        static_cast<std::size_t>(view.width()) * static_cast<std::size_t>(view.height());
    frame.color = Image(view.width(), view.height());
    frame.depth_m.resize(count);
    frame.instance.resize(count);
    frame.normals.resize(3 * count);
    frame.matter.resize(count);
    const SensorShot taken{&lighting_,
                           view,
                           {frame.color.pixels.data(),
                            frame.depth_m.data(),
                            frame.instance.data(),
                            frame.normals.data(),
                            frame.matter.data()}};
    take_pictures(std::span(&taken, 1), sensor_effort(options), progress);
    MARKETGEN_CHECK(check_interrupt());
    return frame;
  }

  void trace_paths(const View& view,
                   const RenderOptions& options,
                   unsigned mask,
                   Film& film,
                   Progress& progress) const {
    const int wanted = options.samples > 0 ? options.samples : paths_of(options.quality);
    for_tiles(view, progress, "first hits", [&](int index) {
      const auto tile = std::make_unique<Tile>();
      find_first_hits(*world_, view, index, mask, *tile);
      store_first_hits(*world_, view, *tile, film);
    });
    std::vector<PathSums> sums(film.count());
    const double start = monotonic_seconds();
    int done = 0;
    while (done < wanted) {
      const int now = std::min(paths_per_pass, wanted - done);
      for_tiles(view, progress, "paths", [&](int index) {
        add_tile_paths(view, index, done, now, mask, sums);
      });
      done += now;
      if (options.time_s > 0 && monotonic_seconds() - start > options.time_s) break;
    }
    store_paths(sums, done, film);
    remove_sparkles(film, film.irradiance);
    remove_sparkles(film, film.gloss);
    const float tolerance = done < few_paths ? 4 : 1.5F;
    smooth(film, film.irradiance, {done < few_paths ? 4 : 3, tolerance, false});
    smooth(film, film.gloss, {2, tolerance, true});
  }

  void add_tile_paths(const View& view,
                      int index,
                      int first,
                      int count,
                      unsigned mask,
                      std::vector<PathSums>& sums) const {
    const int x0 = index % tiles_across(view) * tile_size,
              y0 = index / tiles_across(view) * tile_size;
    for (int y = y0; y < std::min(y0 + tile_size, view.height()); ++y) {
      for (int x = x0; x < std::min(x0 + tile_size, view.width()); ++x) {
        PathSums& sum = sums[static_cast<std::size_t>(y) * static_cast<std::size_t>(view.width()) +
                             static_cast<std::size_t>(x)];
        for (int s = first; s < first + count; ++s)
          add_path(lighting_, view, x, y, static_cast<std::uint32_t>(s), mask, sum);
      }
    }
  }

  // Paths bring their own albedo, emission and glass: the film's planes for those are replaced.
  static void store_paths(const std::vector<PathSums>& sums, int count, Film& film) {
    const float scale = 1 / static_cast<float>(count);
    for (std::size_t i = 0; i < film.count(); ++i) {
      const Vec3f albedo = sums[i].albedo * scale, diffuse = sums[i].diffuse * scale;
      const auto divided = [](float light, float color) {
        return color > 1e-3F ? light * pi / color : 0;
      };
      film.albedo.set(i, albedo);
      film.irradiance.set(i,
                          {divided(diffuse.x, albedo.x),
                           divided(diffuse.y, albedo.y),
                           divided(diffuse.z, albedo.z)});
      film.reflectance.set(i, {1, 1, 1});
      film.gloss.set(i, sums[i].other * scale);
      film.emission.set(i, {});
      film.transmittance.set(i, {1, 1, 1});
      film.overlay.set(i, {});
    }
  }

  Frame frame_of(Film film, const Planes3& radiance) const {
    Frame frame;
    frame.color = develop(radiance, film.width, film.height, world_->exposure);
    frame.depth_m = std::move(film.depth);
    frame.instance = std::move(film.instance);
    frame.matter = std::move(film.matter);
    frame.normals.resize(film.normal.axis[0].size() * 3);
    for (std::size_t i = 0; i < frame.depth_m.size(); ++i) {
      if (frame.depth_m[i] <= 0) continue;  // nothing was hit: no normal
      for (std::size_t a = 0; a < 3; ++a)
        frame.normals[3 * i + a] = film.normal.axis[a][i];
    }
    return frame;
  }

  const Scene& scene_;
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

Result<void> render_batch(std::span<const Shot> shots,
                          const RenderOptions& options,
                          Progress& progress) {
  std::vector<raytrace::SensorShot> taken;
  for (std::size_t i = 0; i < shots.size(); ++i) {
    const std::string where = "shot " + std::to_string(i);
    MARKETGEN_CHECK(check_camera(shots[i].camera, where));
    if (shots[i].renderer == nullptr)
      return Error{"camera.degenerate", where, "it has no renderer"};
    // There is one kind of renderer.
    const auto& renderer = static_cast<const raytrace::EmbreeRenderer&>(*shots[i].renderer);
    taken.push_back(renderer.shot(shots[i].camera, shots[i].to));
  }
  raytrace::take_pictures(taken, raytrace::sensor_effort(options), progress);
  return check_interrupt();
}

Result<std::unique_ptr<Renderer>> Renderer::create(const Scene& scene,
                                                   Progress& progress,
                                                   PrintDetail print) {
  return raytrace::create_renderer(scene, {}, progress, print);
}

}  // namespace marketgen
