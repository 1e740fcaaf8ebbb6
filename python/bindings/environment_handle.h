// An environment that Python holds.
#pragma once
#include <memory>

#include "binding.h"
#include "environments/environment.h"

namespace marketgen::python {

struct EnvironmentHandle {
  std::unique_ptr<environments::Environment> environment;
};

// Raises episode.bad_action when no episode has begun.
inline const episodes::TrackWorld& world_of(const EnvironmentHandle& handle) {
  if (!handle.environment->running() && !handle.environment->result())
    raise({"episode.bad_action", "environment", "no episode has begun: reset it first"});
  return handle.environment->world();
}

// What is true of an environment beyond its observations, for marketgen/environments/.
void add_environment_truth(nb::class_<EnvironmentHandle>& environment);

}  // namespace marketgen::python
