// Environments of both tracks for marketgen/environments/: one by one, and many in one call.
#include <nanobind/ndarray.h>
#include <nanobind/stl/shared_ptr.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/tuple.h>
#include <nanobind/stl/vector.h>

#include "base/parallel.h"
#include "environment_handle.h"
#include "environments/checkout/checkout_environment.h"
#include "environments/draw_stage.h"
#include "environments/environment_batch.h"
#include "environments/told_task.h"
#include "frame_handle.h"
#include "io/json.h"
#include "store_handle.h"
#include "told_progress.h"

namespace marketgen::python {
namespace {

// A caller's memory: a row an environment, or one number.
template <class T>
using Table = nb::ndarray<T, nb::ndim<2>, nb::c_contig, nb::device::cpu>;
template <class T>
using Column = nb::ndarray<T, nb::ndim<1>, nb::c_contig, nb::device::cpu>;

using Handles = std::vector<EnvironmentHandle*>;

std::shared_ptr<environments::EpisodeGround> ground_of(StoreHandle& handle) {
  if (!handle.ground)
    handle.ground =
        value_or_raise(environments::EpisodeGround::of_store(handle.store, handle.catalog));
  return handle.ground;
}

std::shared_ptr<environments::EpisodeGround> ground_of_file(const std::string& file) {
  return value_or_raise(
      without_interpreter([&] { return environments::EpisodeGround::of_file(file); }));
}

std::shared_ptr<environments::EpisodeGround> ground_of_pool(const std::string& track) {
  const episodes::Track of = value_or_raise(episodes::track_named(track));
  return value_or_raise(
      without_interpreter([&] { return environments::EpisodeGround::of_pool(of); }));
}

EnvironmentHandle create_environment(std::shared_ptr<environments::EpisodeGround> ground,
                                     const std::string& track,
                                     const std::string& control_mode,
                                     const std::string& reward_mode,
                                     const std::string& tools,
                                     const std::string& station,
                                     bool stop,
                                     bool privileged,
                                     int item_rows,
                                     const std::string& realism,
                                     const std::string& stage) {
  const environments::EnvironmentOptions options{
      .control = named<environments::ControlMode>(control_mode, "control_mode"),
      .reward = named<environments::RewardMode>(reward_mode, "reward_mode"),
      .tools = tools,
      .station = station,
      .stage = named<episodes::Stage>(stage, "stage"),
      .stop = stop,
      .privileged = privileged,
      .item_rows = item_rows,
      .realism = value_or_raise(episodes::load_realism(ground->data(), realism))};
  const episodes::Track of = value_or_raise(episodes::track_named(track));
  return {value_or_raise(environments::Environment::create(std::move(ground), of, options))};
}

// name, low, high, unit and its dimension of each number.
using ActionRow = std::tuple<std::string, double, double, double, std::string>;
std::vector<ActionRow> action_numbers(const EnvironmentHandle& h) {
  std::vector<ActionRow> rows;
  for (const environments::ActionNumber& number : h.environment->action_numbers())
    rows.emplace_back(
        number.name, number.low, number.high, number.unit, std::string(number.dimension));
  return rows;
}

// group, name, shape, low and high of each number.
using PartRow = std::tuple<std::string,
                           std::string,
                           std::vector<int>,
                           std::vector<double>,
                           std::vector<double>,
                           std::vector<std::string>>;
std::vector<PartRow> parts(const EnvironmentHandle& h) {
  std::vector<PartRow> rows;
  for (const environments::ObservationPart& part : h.environment->observation_parts())
    rows.emplace_back(part.group, part.name, part.shape, part.low, part.high, part.names);
  return rows;
}

std::vector<environments::Environment*> inner(const Handles& handles) {
  std::vector<environments::Environment*> environments;
  for (const EnvironmentHandle* handle : handles)
    environments.push_back(handle->environment.get());
  return environments;
}

template <class Array>
void check_rows(const Array& array, std::size_t rows, const char* name) {
  if (array.shape(0) != rows)
    raise({"episode.bad_action",
           name,
           std::to_string(array.shape(0)) + " rows for " + std::to_string(rows) + " environments"});
}

template <class T>
std::span<T> span_of(const Table<T>& rows, const environments::Environment& first) {
  if (rows.shape(1) != first.observation_size())
    raise({"episode.bad_action",
           "observations",
           std::to_string(rows.shape(1)) + " numbers a row; expected " +
               std::to_string(first.observation_size())});
  return {rows.data(), rows.size()};
}

void step_environments(const Handles& handles,
                       const Table<const double>& actions,
                       const Table<float>& observations,
                       const Column<double>& rewards,
                       const Column<bool>& terminated,
                       const Column<bool>& truncated) {
  const std::vector<environments::Environment*> environments = inner(handles);
  const std::size_t count = environments.size();
  if (count == 0) return;
  check_rows(actions, count, "actions");
  check_rows(observations, count, "observations");
  check_rows(rewards, count, "rewards");
  check_rows(terminated, count, "terminated");
  check_rows(truncated, count, "truncated");
  const environments::BatchBuffers into{span_of(observations, *environments[0]),
                                        {rewards.data(), count},
                                        {terminated.data(), count},
                                        {truncated.data(), count}};
  const std::span<const double> all{actions.data(), actions.size()};
  check_or_raise(
      without_interpreter([&] { return environments::step_all(environments, all, into); }));
}

void reset_environments(const Handles& handles,
                        const std::vector<std::string>& episodes,
                        const Table<float>& observations) {
  const std::vector<environments::Environment*> environments = inner(handles);
  if (environments.empty()) return;
  check_rows(observations, environments.size(), "observations");
  if (episodes.size() != environments.size())
    raise({"episode.bad_action", "reset", "there must be one episode an environment"});
  std::vector<episodes::EpisodeSpec> specs;
  for (const std::string& episode : episodes)
    specs.push_back(value_or_raise(io::read_json<episodes::EpisodeSpec>(episode, "episode")));
  const std::span<float> into = span_of(observations, *environments[0]);
  check_or_raise(
      without_interpreter([&] { return environments::reset_all(environments, specs, into); }));
}

// The episodes of seeds as market-episode/1.
std::vector<std::string> draw(environments::EpisodeGround& ground,
                              const std::string& track,
                              const std::vector<std::uint64_t>& seeds,
                              const std::string& tools,
                              const std::string& split,
                              const Callable& progress) {
  const episodes::Track of = value_or_raise(episodes::track_named(track));
  const auto shown = named<episodes::Split>(split, "split");
  const auto specs = value_or_raise(telling(progress, [&](Progress& told) {
    return environments::draw_all(ground, of, seeds, tools, shown, told);
  }));
  std::vector<std::string> texts;
  for (const episodes::EpisodeSpec& spec : specs)
    texts.push_back(io::write_json(spec));
  return texts;
}

// market-episode/1 of a stage.
std::string draw_stage(environments::EpisodeGround& ground,
                       const std::string& stage,
                       const std::string& tools,
                       std::uint64_t seed) {
  const auto wanted = named<episodes::Stage>(stage, "stage");
  return io::write_json(value_or_raise(
      without_interpreter([&] { return environments::draw_stage(ground, wanted, tools, seed); })));
}

FrameHandle picture_of(EnvironmentHandle& handle,
                       const std::string& camera,
                       int width,
                       int height,
                       const std::string& quality) {
  world_of(handle);
  render::RenderOptions options;
  options.quality = named<render::Quality>(quality, "quality");
  return {value_or_raise(without_interpreter(
      [&] { return handle.environment->picture(camera, width, height, options); }))};
}

render::Camera camera_of_environment(EnvironmentHandle& handle,
                                     const std::string& name,
                                     int width,
                                     int height) {
  world_of(handle);
  return value_or_raise(
      without_interpreter([&] { return handle.environment->camera(name, width, height); }));
}

// Metres and radians of each tool.
std::vector<std::tuple<double, double>> tool_cuts(const EnvironmentHandle& handle) {
  std::vector<std::tuple<double, double>> rows;
  for (const environments::ToolCut& cut : handle.environment->tool_cuts())
    rows.emplace_back(cut.off_m, cut.off_rad);
  return rows;
}

std::string result_of(const EnvironmentHandle& handle) {
  const auto& ended = handle.environment->result();
  return ended ? io::write_json(*ended) : "";
}

std::string task_of(const EnvironmentHandle& handle) {
  return io::write_json(environments::told_task(world_of(handle).spec()));
}

// market-result/1 as evaluate() keeps it. `isolation`: of the policy's process. `broken`: code,
// where and message of the error that ended it, or nothing.
std::string judged(EnvironmentHandle& handle,
                   const std::string& policy,
                   const std::string& isolation,
                   const std::string& told,
                   const std::vector<std::string>& broken,
                   bool by_policy,
                   double wall_s) {
  world_of(handle);
  episodes::EpisodeEnd end{policy, told};
  end.isolation = named<episodes::PolicyIsolation>(isolation, "isolation");
  if (broken.size() == 3) {
    end.broken = Error{broken[0], broken[1], broken[2]};
    end.by_policy = by_policy;
  }
  end.wall_s = wall_s;
  return io::write_json(
      value_or_raise(without_interpreter([&]() -> Result<episodes::EpisodeResult> {
        episodes::EpisodeResult result;
        parallel_for(1, [&](std::size_t) { result = handle.environment->judged(end); });
        return result;
      })));
}

std::vector<std::string> episodes(const environments::EpisodeGround& ground) {
  std::vector<std::string> texts;
  for (const episodes::EpisodeSpec& spec : ground.episodes())
    texts.push_back(io::write_json(spec));
  return texts;
}

// The rows of the catalogue, each as JSON.
std::vector<std::string> catalogue(const environments::EpisodeGround& ground) {
  std::vector<std::string> texts;
  for (const catalog::Product& product : ground.known_products())
    texts.push_back(io::write_json(product));
  return texts;
}

}  // namespace

void add_environments(nb::module_& module) {
  nb::class_<environments::EpisodeGround>(module, "EpisodeGround")
      .def("episodes", &episodes)
      .def("catalogue", &catalogue)
      .def("draw", &draw)
      .def("draw_one_item",
           [](const environments::EpisodeGround& ground, std::uint64_t seed) {
             return io::write_json(value_or_raise(environments::draw_one_item(ground, seed)));
           })
      .def("draw_stage", &draw_stage);
  module.def("ground_of_store", &ground_of);
  module.def("ground_of_file", &ground_of_file);
  module.def("ground_of_pool", &ground_of_pool);
  nb::class_<EnvironmentHandle> environment(module, "Environment");
  environment.def("action_numbers", &action_numbers)
      .def("observation_parts", &parts)
      .def("cameras", [](const EnvironmentHandle& h) { return h.environment->cameras(); })
      .def("usual_cameras",
           [](const EnvironmentHandle& h) { return h.environment->usual_cameras(); })
      .def("running", [](const EnvironmentHandle& h) { return h.environment->running(); })
      .def("time_s", [](const EnvironmentHandle& h) { return world_of(h).time_s(); })
      .def("state_hash", [](const EnvironmentHandle& h) { return world_of(h).state_hash(); })
      .def("map",
           [](const EnvironmentHandle& h) {
             world_of(h);
             return value_or_raise(h.environment->map());
           })
      .def("task", &task_of)
      .def("tool_cuts", &tool_cuts)
      .def("robot_stopped",
           [](const EnvironmentHandle& handle) { return handle.environment->robot_stopped(); })
      .def("result", &result_of)
      .def("judged", &judged)
      .def("render", &picture_of)
      .def("camera", &camera_of_environment);
  add_environment_truth(environment);
  module.def("create_environment", &create_environment);
  module.def("reset_environments",
             &reset_environments,
             nb::arg("environments"),
             nb::arg("episodes"),
             nb::arg("observations").noconvert());
  module.def("step_environments",
             &step_environments,
             nb::arg("environments"),
             nb::arg("actions"),
             nb::arg("observations").noconvert(),
             nb::arg("rewards").noconvert(),
             nb::arg("terminated").noconvert(),
             nb::arg("truncated").noconvert());
}

}  // namespace marketgen::python
