// The truth about a running environment: where things are, its state as bytes, MuJoCo's model.
#include <mujoco/mujoco.h>
#include <nanobind/ndarray.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include "base/parallel.h"
#include "environment_handle.h"
#include "physics/mujoco_guard.h"

namespace marketgen::python {
namespace {

nb::bytes python_bytes(const std::string& bytes) {
  return nb::bytes(bytes.data(), bytes.size());
}

std::vector<double> pose_numbers(const Pose& p) {
  return {p.position.x,
          p.position.y,
          p.position.z,
          p.rotation.w,
          p.rotation.x,
          p.rotation.y,
          p.rotation.z};
}

nb::list item_rows(const EnvironmentHandle& handle) {
  world_of(handle);
  nb::list rows;
  for (const environments::EnvironmentItem& item : value_or_raise(handle.environment->items())) {
    nb::dict row;
    row["sku"] = item.sku;
    row["pose"] = pose_numbers(item.pose);
    row["size"] = std::vector<double>{item.size_m.x, item.size_m.y, item.size_m.z};
    row["goal"] = item.wanted;
    row["held"] = item.held;
    row["in_place"] = item.in_place;
    row["segmentation_id"] = item.object;
    rows.append(row);
  }
  return rows;
}

nb::dict way_to_stand(const EnvironmentHandle& handle) {
  world_of(handle);
  const episodes::WayToStand way = value_or_raise(handle.environment->way_to_stand());
  nb::dict row;
  row["corner"] = std::vector<double>{way.corner.x, way.corner.y};
  row["way_m"] = way.way_m;
  row["stand"] = std::vector<double>{way.stand.x_m, way.stand.y_m, way.stand.heading};
  row["speed_m_s"] = way.speed_m_s;
  row["turn_rad_s"] = way.turn_rad_s;
  return row;
}

nb::dict door_row(const EnvironmentHandle& handle) {
  world_of(handle);
  const episodes::DoorSeen seen = value_or_raise(handle.environment->door());
  nb::dict row;
  row["arm"] = seen.arm;
  row["side"] = seen.side;
  row["tool"] = std::vector<double>{seen.tool.x, seen.tool.y, seen.tool.z};
  row["to_bar"] = std::vector<double>{seen.to_bar.x, seen.to_bar.y, seen.to_bar.z};
  row["behind_rad"] = seen.behind_rad;
  row["into_rad"] = seen.into_rad;
  row["position_rad"] = seen.position_rad;
  row["speed_rad_s"] = seen.speed_rad_s;
  row["asked_rad"] = seen.asked_rad;
  row["held"] = seen.held;
  row["clean"] = seen.clean;
  return row;
}

nb::dict product_rows(const EnvironmentHandle& handle) {
  world_of(handle);
  nb::dict rows;
  for (const auto& [object, sku] : value_or_raise(handle.environment->products()))
    rows[nb::int_(object)] = nb::str(sku.c_str(), sku.size());
  return rows;
}

nb::bytes saved_state(const EnvironmentHandle& handle) {
  world_of(handle);
  return python_bytes(handle.environment->save());
}

using Row = nb::ndarray<float, nb::ndim<2>, nb::c_contig, nb::device::cpu>;

// `observation`: one row, gets what is seen then. On the threads that step: numbers are rounded
// alike there.
void restore_state(EnvironmentHandle& handle, const nb::bytes& state, const Row& observation) {
  world_of(handle);
  environments::Environment& environment = *handle.environment;
  if (observation.size() != environment.observation_size())
    raise({"episode.bad_action", "observation", "a row of another length"});
  const std::string_view bytes(state.c_str(), state.size());
  check_or_raise(without_interpreter([&] {
    Result<void> done;
    parallel_for(1, [&](std::size_t) {
      done = environment.restore(bytes);
      if (done.ok()) environment.observe({observation.data(), observation.size()});
    });
    return done;
  }));
}

// As mj_saveModel writes it: an MJB file's bytes.
nb::bytes mujoco_model(const EnvironmentHandle& handle) {
  world_of(handle);
  const mjModel& model = handle.environment->model();
  std::string bytes(static_cast<std::size_t>(mj_sizeModel(&model)), '\0');
  check_or_raise(physics::guarded("mujoco_model", [&] {
    mj_saveModel(&model, nullptr, bytes.data(), static_cast<int>(bytes.size()));
  }));
  return python_bytes(bytes);
}

std::vector<double> mujoco_state(const EnvironmentHandle& handle) {
  world_of(handle);
  const mjModel& model = handle.environment->model();
  std::vector<double> numbers(static_cast<std::size_t>(mj_stateSize(&model, mjSTATE_INTEGRATION)));
  mj_getState(&model, &handle.environment->data(), numbers.data(), mjSTATE_INTEGRATION);
  return numbers;
}

}  // namespace

void add_environment_truth(nb::class_<EnvironmentHandle>& environment) {
  environment.def("items", &item_rows)
      .def("way_to_stand", &way_to_stand)
      .def("door", &door_row)
      .def("progress",
           [](const EnvironmentHandle& h) {
             world_of(h);
             return h.environment->progress();
           })
      .def("products", &product_rows)
      .def("save", &saved_state)
      .def("restore", &restore_state, nb::arg("state"), nb::arg("observation").noconvert())
      .def("mujoco_model", &mujoco_model)
      .def("mujoco_state", &mujoco_state);
}

}  // namespace marketgen::python
