#include <nanobind/ndarray.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>
#include <optional>

#include "binding.h"
#include "collect/standing_robot.h"
#include "collect/store_people.h"
#include "frame_handle.h"
#include "io/json.h"
#include "render/annotations.h"
#include "render/sensor/color_noise.h"
#include "render/sensor/depth_noise.h"
#include "render/stage/person_actor.h"
#include "render/stage/robot_actor.h"
#include "store_handle.h"
#include "told_progress.h"

namespace marketgen::python {
namespace {

template <class T>
using Rows = nb::ndarray<const T, nb::ndim<1>, nb::c_contig, nb::device::cpu>;
using Poses = nb::ndarray<const double, nb::shape<-1, 7>, nb::c_contig, nb::device::cpu>;
template <class T>
using Plane = nb::ndarray<T, nb::c_contig, nb::device::cpu>;  // a caller's memory

struct RendererHandle {
  std::shared_ptr<const store::Store> store;  // before the renderer, which reads its scene
  std::unique_ptr<render::Renderer> renderer;
  std::vector<render::Actor> robots, people;  // in this order in the renderer
  std::optional<collect::StorePeople> company = {};
};

std::vector<render::Actor> joined(std::vector<render::Actor> robots,
                                  const std::vector<render::Actor>& people) {
  robots.insert(robots.end(), people.begin(), people.end());
  return robots;
}

RendererHandle create(const StoreHandle& handle,
                      bool fine_print,
                      bool keep_light,
                      const Callable& progress) {
  const render::RendererOptions options{
      fine_print ? render::PrintDetail::near : render::PrintDetail::distant, keep_light};
  RendererHandle made{handle.store, nullptr, {}, {}};
  made.renderer = value_or_raise(telling(progress, [&](Progress& told) {
    return render::Renderer::create(made.store->scene, told, options);
  }));
  return made;
}

FrameHandle render(RendererHandle& handle,
                   const render::Camera& camera,
                   const std::string& mode,
                   const std::string& quality,
                   int samples,
                   double time_s,
                   const std::string& denoise,
                   double exposure_stops,
                   const Callable& progress) {
  render::RenderOptions options;
  options.mode = named<render::RenderMode>(mode, "mode");
  options.quality = named<render::Quality>(quality, "quality");
  options.samples = samples;
  options.time_s = time_s;
  options.denoiser = named<render::Denoiser>(denoise, "denoise");
  options.exposure_stops = exposure_stops;
  options.hide_ceiling = camera.ortho_height_m > 0;
  return {value_or_raise(telling(
      progress, [&](Progress& told) { return handle.renderer->render(camera, options, told); }))};
}

// The same picture as this sensor records it.
FrameHandle noisy(const FrameHandle& seen,
                  const render::Camera& camera,
                  std::uint64_t seed,
                  std::uint64_t number) {
  const render::NoiseSource source{seed, number};
  FrameHandle recorded = seen;
  recorded.frame.depth_m =
      value_or_raise(render::noisy_depth(seen.frame, camera, render::StereoCamera{}, source));
  recorded.frame.color =
      render::noisy_color(seen.frame.color, camera, render::ColorSensor{}, source);
  return recorded;
}

std::string annotations(const RendererHandle& handle,
                        const FrameHandle& seen,
                        const render::Camera& camera) {
  return io::write_json(
      render::annotate(seen.frame,
                       camera,
                       handle.store->scene,
                       *handle.renderer,
                       render::picture_actors(joined(handle.robots, handle.people))));
}

void set_robots(RendererHandle& handle, const std::vector<std::string>& texts) {
  const std::vector<robots::PlacedRobot> robots =
      value_or_raise(collect::standing_robots(handle.store->scene, texts, "robot "));
  std::vector<render::Actor> actors = value_or_raise(render::robot_actors(robots));
  check_or_raise(handle.renderer->set_actors(joined(actors, handle.people)));
  handle.robots = std::move(actors);
}

void set_people(RendererHandle& handle, int count, double time_s) {
  const scene::Scene& scene = handle.store->scene;
  if (!handle.company || handle.company->count() != static_cast<std::size_t>(count))
    handle.company = value_or_raise(without_interpreter(
        [&] { return collect::StorePeople::make(scene, count, collect::people_seed(scene)); }));
  std::vector<render::Actor> actors =
      value_or_raise(without_interpreter([&]() -> Result<std::vector<render::Actor>> {
        return render::person_actors(handle.company->at(time_s),
                                     render::detail_of_company(handle.company->count()));
      }));
  check_or_raise(handle.renderer->set_actors(joined(handle.robots, actors)));
  handle.people = std::move(actors);
}

void move(RendererHandle& handle,
          const Rows<std::uint32_t>& products,
          const Poses& poses,
          const Rows<std::uint32_t>& joints,
          const Rows<double>& positions) {
  if (products.shape(0) != poses.shape(0) || joints.shape(0) != positions.shape(0))
    raise({"render.bad_move", "move", "there must be one pose a product and one position a joint"});
  std::vector<render::MovedProduct> moved(products.shape(0));
  for (std::size_t i = 0; i < moved.size(); ++i) {
    const double* p = poses.data() + 7 * i;
    moved[i] = {products.data()[i], {{p[0], p[1], p[2]}, {p[3], p[4], p[5], p[6]}}};
  }
  std::vector<render::MovedJoint> turned(joints.shape(0));
  for (std::size_t i = 0; i < turned.size(); ++i)
    turned[i] = {joints.data()[i], positions.data()[i]};
  check_or_raise(handle.renderer->move_things(moved, turned));
}

// Memory for `count` pictures of one size, one after another, or none.
template <class T>
T* memory_for(const std::optional<Plane<T>>& plane, std::size_t numbers, const char* name) {
  if (!plane) return nullptr;
  if (plane->size() != numbers) {
    raise({"camera.bad_size",
           name,
           "it has room for " + std::to_string(plane->size()) + " numbers, the pictures have " +
               std::to_string(numbers)});
  }
  return plane->data();
}

void render_batch(const std::vector<RendererHandle*>& renderers,
                  const std::vector<render::Camera>& cameras,
                  const std::string& quality,
                  const std::optional<Plane<std::uint8_t>>& rgb,
                  const std::optional<Plane<float>>& depth,
                  const std::optional<Plane<std::uint32_t>>& instance) {
  if (renderers.size() != cameras.size() || cameras.empty())
    raise({"camera.degenerate", "render_batch", "give one renderer for each camera"});
  const auto pixels =
      static_cast<std::size_t>(cameras[0].width) * static_cast<std::size_t>(cameras[0].height);
  for (const render::Camera& camera : cameras) {
    if (camera.width != cameras[0].width || camera.height != cameras[0].height)
      raise({"camera.bad_size", camera.name, "all pictures of a batch have one size"});
  }
  const render::FrameBuffers all{
      .rgb = memory_for(rgb, 3 * pixels * cameras.size(), "rgb"),
      .depth_m = memory_for(depth, pixels * cameras.size(), "depth"),
      .instance = memory_for(instance, pixels * cameras.size(), "instance")};
  std::vector<render::Shot> shots;
  for (std::size_t i = 0; i < cameras.size(); ++i) {
    render::FrameBuffers to;
    if (all.rgb != nullptr) to.rgb = all.rgb + 3 * pixels * i;
    if (all.depth_m != nullptr) to.depth_m = all.depth_m + pixels * i;
    if (all.instance != nullptr) to.instance = all.instance + pixels * i;
    shots.push_back({renderers[i]->renderer.get(), cameras[i], to});
  }
  render::RenderOptions options;
  options.quality = named<render::Quality>(quality, "quality");
  check_or_raise(
      without_interpreter([&] { return marketgen::render::render_batch(shots, options); }));
}

}  // namespace

void add_renderers(nb::module_& module) {
  add_frames(module);
  nb::class_<RendererHandle>(module, "Renderer")
      .def("_render", &render)
      .def("_noisy",
           [](const RendererHandle&,
              const FrameHandle& seen,
              const render::Camera& camera,
              std::uint64_t seed,
              std::uint64_t number) { return noisy(seen, camera, seed, number); })
      .def("_annotations", &annotations)
      .def("_set_robots", &set_robots)
      .def("_set_people", &set_people)
      .def("_move", &move);
  module.def("create_renderer", &create);
  module.def("render_batch",
             &render_batch,
             nb::arg("renderers"),
             nb::arg("cameras"),
             nb::arg("quality"),
             nb::arg("rgb").noconvert().none(),
             nb::arg("depth").noconvert().none(),
             nb::arg("instance").noconvert().none());
}

}  // namespace marketgen::python
