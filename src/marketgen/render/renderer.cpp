// Renderer: the world, its light, and the two ways to make a picture of it.
#include <algorithm>
#include <cmath>

#include "base/interrupt.h"
#include "base/parallel.h"
#include "render/catalogue_renderer.h"
#include "render/light/lit_world.h"
#include "render/path/path_picture.h"
#include "render/picture_objects.h"
#include "render/render.h"
#include "render/sensor/sensor_picture.h"
#include "render/shading_math.h"
#include "render/silhouette.h"
#include "render/stage/actor_stage.h"
#include "render/stage/build_world.h"
#include "render/stage/displaced.h"
#include "render/stage/exhibit.h"

namespace marketgen::render {
namespace raytrace {
namespace {

constexpr float shelf_search_m = 0.03F;  // above a product's foot: it stands on the board's face

class EmbreeRenderer : public Renderer {
 public:
  EmbreeRenderer(std::unique_ptr<LitWorld> lit, const scene::Scene& scene)
      : scene_(scene),
        lit_(std::move(lit)),
        world_(*lit_->world),
        panels_(world_),
        actors_(world_, first_actor_object(scene)),
        lighting_{world_, lit_->lights, lit_->field, panels_} {}

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
      rows.push_back({world_.first_product_instance + moved.product,
                      lit_->field.shelf_at(place({0, 0, shelf_search_m})),
                      place});
    }
    add_moved_joints(world_, scene_, joints, rows);
    MARKETGEN_CHECK(actors_.displace(std::move(rows)));
    moved_.assign(products.begin(), products.end());
    return {};
  }
  std::span<const MovedProduct> moved_products() const override { return moved_; }

  SensorShot shot(const Camera& camera, const FrameBuffers& to) {
    actors_.settle();
    return {&lighting_, View(camera), to};
  }

  std::vector<Silhouette> silhouettes(const Camera& camera,
                                      const Frame& frame,
                                      std::span<const std::uint32_t> objects) const override {
    return silhouettes_of(world_, camera, frame, objects);
  }

  Result<Frame> render(const Camera& camera,
                       const RenderOptions& options,
                       Progress& progress) override {
    MARKETGEN_CHECK(check_camera(camera, camera.name.empty() ? "camera" : camera.name));
    const View view(camera);
    actors_.settle();
    if (options.mode == RenderMode::sensor) return sensor_frame(view, options, progress);
    MARKETGEN_TRY(Frame frame,
                  path_picture({world_, lit_->lights, lit_->field}, view, options, progress));
    // What is to be seen where is the same in both modes.
    FrameBuffers planes = make_planes(view, frame);
    planes.rgb = nullptr;
    const SensorShot shapes{&lighting_, view, planes};
    take_pictures(std::span(&shapes, 1), sensor_effort(options), silent_progress());
    MARKETGEN_CHECK(check_interrupt());
    return frame;
  }

 private:
  // Room for a picture's planes.
  static FrameBuffers make_planes(const View& view, Frame& frame) {
    const auto count =
        static_cast<std::size_t>(view.width()) * static_cast<std::size_t>(view.height());
    if (frame.color.empty()) frame.color = Image(view.width(), view.height());
    frame.depth_m.resize(count);
    frame.instance.resize(count);
    frame.normals.resize(3 * count);
    frame.matter.resize(count);
    return {frame.color.pixels.data(),
            frame.depth_m.data(),
            frame.instance.data(),
            frame.normals.data(),
            frame.matter.data()};
  }

  Result<Frame> sensor_frame(const View& view,
                             const RenderOptions& options,
                             Progress& progress) const {
    Frame frame;
    const SensorShot taken{&lighting_, view, make_planes(view, frame)};
    take_pictures(std::span(&taken, 1), sensor_effort(options), progress);
    MARKETGEN_CHECK(check_interrupt());
    return frame;
  }

  const scene::Scene& scene_;
  std::unique_ptr<LitWorld> lit_;
  World& world_;
  PanelReflection panels_;
  ActorStage actors_;
  std::vector<MovedProduct> moved_;
  Lighting lighting_;
};

}  // namespace

Result<std::unique_ptr<Renderer>> create_renderer(const scene::Scene& scene,
                                                  const std::vector<Exhibit>& exhibits,
                                                  Progress& progress,
                                                  const RendererOptions& options) {
  MARKETGEN_TRY(
      std::unique_ptr<LitWorld> lit,
      light_world(scene, exhibits, progress, {.print = options.print}, options.keep_light));
  return std::unique_ptr<Renderer>(std::make_unique<EmbreeRenderer>(std::move(lit), scene));
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
    auto& renderer = static_cast<raytrace::EmbreeRenderer&>(*shots[i].renderer);
    taken.push_back(renderer.shot(shots[i].camera, shots[i].to));
  }
  raytrace::take_pictures(taken, raytrace::sensor_effort(options), progress);
  return check_interrupt();
}

Result<std::unique_ptr<Renderer>> Renderer::create(const scene::Scene& scene,
                                                   Progress& progress,
                                                   const RendererOptions& options) {
  return raytrace::create_renderer(scene, {}, progress, options);
}

Result<std::unique_ptr<Renderer>> create_catalogue_renderer(const scene::Scene& scene) {
  raytrace::WorldDetail detail;
  detail.as_new = true;
  MARKETGEN_TRY(std::unique_ptr<raytrace::LitWorld> lit,
                raytrace::light_world(scene, {}, silent_progress(), detail, false));
  return std::unique_ptr<Renderer>(
      std::make_unique<raytrace::EmbreeRenderer>(std::move(lit), scene));
}

}  // namespace marketgen::render
