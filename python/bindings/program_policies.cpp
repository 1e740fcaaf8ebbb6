// Policies of the program for marketgen/policies.py: they act in Python's environments.
#include <nanobind/ndarray.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/string_view.h>
#include <nanobind/stl/unique_ptr.h>
#include <nanobind/stl/vector.h>

#include <algorithm>

#include "base/parallel.h"
#include "binding.h"
#include "environment_handle.h"
#include "environments/program_policy.h"

namespace marketgen::python {
namespace {

using Actions = nb::ndarray<double, nb::ndim<2>, nb::c_contig, nb::device::cpu>;

// A row of `into` each, side by side; where no episode runs the row stays as it is.
Result<void> act_all(const std::vector<environments::ProgramPolicy*>& policies,
                     const std::vector<EnvironmentHandle*>& environments,
                     Actions into) {
  const std::size_t numbers = into.shape(1);
  const auto done = parallel_map(policies.size(), [&](std::size_t i) {
    const auto act = [&]() -> Result<void> {
      if (!environments[i]->environment->running()) return {};
      MARKETGEN_TRY(const std::vector<double> action, policies[i]->act());
      std::ranges::copy(action, into.data() + i * numbers);
      return {};
    };
    return std::make_shared<Result<void>>(act());
  });
  for (const auto& result : done)
    MARKETGEN_CHECK(*result);
  return {};
}

void act(const std::vector<environments::ProgramPolicy*>& policies,
         const std::vector<EnvironmentHandle*>& environments,
         const Actions& into) {
  const bool fits = policies.size() == environments.size() && into.shape(0) == policies.size() &&
                    std::ranges::all_of(environments, [&](const EnvironmentHandle* handle) {
                      return handle->environment->action_numbers().size() == into.shape(1);
                    });
  if (!fits) raise({"episode.bad_action", "actions", "a row of numbers an environment is needed"});
  check_or_raise(without_interpreter([&] { return act_all(policies, environments, into); }));
}

}  // namespace

void add_program_policies(nb::module_& module) {
  nb::class_<environments::ProgramPolicy>(module, "ProgramPolicy")
      .def("failure", &environments::ProgramPolicy::failure)
      .def("subtask",
           [](const environments::ProgramPolicy& policy) { return name_of(policy.subtask()); });
  module.def("subtasks", [] {
    const auto names = names_of(agent::Subtask{});
    return std::vector<std::string>(names.begin(), names.end());
  });
  module.def(
      "program_policy",
      [](EnvironmentHandle& handle, const std::string& name) {
        return std::make_unique<environments::ProgramPolicy>(*handle.environment, name);
      },
      nb::keep_alive<0, 1>());
  module.def(
      "act", &act, nb::arg("policies"), nb::arg("environments"), nb::arg("actions").noconvert());
}

}  // namespace marketgen::python
