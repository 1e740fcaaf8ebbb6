// Evaluations for marketgen/evaluation.py: with the policies of the program, and with Python's.
#include <nanobind/stl/array.h>
#include <nanobind/stl/map.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <array>
#include <map>

#include "assets/usable_catalog.h"
#include "base/parallel.h"
#include "binding.h"
#include "environments/policy_name.h"
#include "episodes/episode_sets.h"
#include "episodes/episode_spec.h"
#include "evaluation/episode_worker.h"
#include "evaluation/evaluate.h"
#include "io/file.h"
#include "io/json.h"
#include "io/process_group.h"
#include "told_progress.h"

namespace marketgen::python {
namespace {

evaluation::EvaluationOptions options_of(const std::string& policy,
                                         const std::string& realism,
                                         const std::string& folder,
                                         bool resume,
                                         int jobs,
                                         const std::string& shard,
                                         int repetition) {
  evaluation::EvaluationOptions options{policy, folder, resume};
  options.realism =
      value_or_raise(episodes::load_realism(value_or_raise(io::data_folder()), realism));
  if (!shard.empty()) options.shard = value_or_raise(evaluation::read_shard(shard));
  options.jobs = jobs > 0 ? jobs : thread_count();
  options.repetition = repetition;
  return options;
}

// `worker`: a command that calls serve_episodes(), or nothing. `limits_s`: for an answer of the
// policy of processor time and, against hangs, of wall time; until a worker is ready of processor
// time.
void evaluate(const std::string& episodes,
              const std::string& policy,
              const std::string& realism,
              const std::string& folder,
              bool resume,
              int jobs,
              const std::string& shard,
              int repetition,
              bool record_motion,
              bool record_decisions,
              const std::vector<std::string>& worker,
              const std::array<double, 3>& limits_s,
              const Callable& progress) {
  evaluation::EvaluationOptions options =
      options_of(policy, realism, folder, resume, jobs, shard, repetition);
  options.answer = {limits_s[0], limits_s[1]};
  options.start_limit_s = limits_s[2];
  options.worker = worker;
  options.record_motion = record_motion;
  options.record_decisions = record_decisions;
  value_or_raise(environments::read_policy_name(policy));
  value_or_raise(
      telling(progress, [&](Progress& told) -> Result<std::vector<episodes::EpisodeResult>> {
        MARKETGEN_TRY(const episodes::EpisodeFile file, episodes::read_episode_file(episodes));
        MARKETGEN_TRY(const std::filesystem::path data, io::data_folder());
        MARKETGEN_TRY(const catalog::Catalog catalog, assets::usable_catalog());
        return marketgen::evaluation::evaluate(data, file, catalog, options, told);
      }));
}

void serve(const std::string& policy, int threads) {
  check_or_raise(without_interpreter([&]() -> Result<void> {
    const ThreadLimit limit(threads);
    MARKETGEN_TRY(const std::filesystem::path data, io::data_folder());
    MARKETGEN_TRY(const catalog::Catalog catalog, assets::usable_catalog());
    return evaluation::serve_episodes(data, catalog, policy);
  }));
}

std::string text_of(const nb::handle& object, const char* attribute) {
  return nb::cast<std::string>(nb::str(object.attr(attribute)));
}

// What a call into Python raised, as our error.
Error error_of(nb::python_error& raised) {
  if (raised.matches(PyExc_KeyboardInterrupt))
    return {"internal.interrupted", "", "interrupted; nothing was left behind"};
  const nb::handle value = raised.value();
  if (nb::hasattr(value, "code") && nb::hasattr(value, "where") && nb::hasattr(value, "message"))
    return {text_of(value, "code"), text_of(value, "where"), text_of(value, "message")};
  return {"internal.bug", "evaluate", raised.what()};
}

// A Python object that C++ threads own: it is let go with the interpreter held.
std::shared_ptr<nb::object> shared(nb::object object) {
  return {new nb::object(std::move(object)), [](nb::object* kept) {
            const nb::gil_scoped_acquire held;
            delete kept;
          }};
}

// `make_runner` is called once in each thread; what it returns takes an episode's text and returns
// its result's.
void evaluate_with(const std::string& episodes,
                   const std::string& policy,
                   const std::string& realism,
                   const std::string& folder,
                   bool resume,
                   int jobs,
                   const std::string& shard,
                   int repetition,
                   nb::object make_runner,
                   const Callable& progress) {
  const evaluation::EvaluationOptions options =
      options_of(policy, realism, folder, resume, jobs, shard, repetition);
  const auto make = [&]() -> evaluation::EpisodeRunner {
    const nb::gil_scoped_acquire held;
    std::shared_ptr<nb::object> runner;
    Error fault;
    try {
      runner = shared(make_runner());
    } catch (nb::python_error& raised) {
      fault = error_of(raised);
    }
    return [runner, fault](const episodes::EpisodeSpec& spec) -> Result<episodes::EpisodeResult> {
      if (!runner) return fault;
      const nb::gil_scoped_acquire taken;
      try {
        const std::string result = nb::cast<std::string>((*runner)(io::write_json(spec)));
        return io::read_json<episodes::EpisodeResult>(result, "policy");
      } catch (nb::python_error& raised) {
        return error_of(raised);
      }
    };
  };
  value_or_raise(
      telling(progress, [&](Progress& told) -> Result<std::vector<episodes::EpisodeResult>> {
        MARKETGEN_TRY(const episodes::EpisodeFile file, episodes::read_episode_file(episodes));
        return marketgen::evaluation::evaluate_with(file, options, make, told);
      }));
}

io::ProcessGroup started(const std::vector<std::string>& command, const std::array<int, 3>& ends) {
  return value_or_raise(io::ProcessGroup::start(command, ends));
}

std::string find_episode_file(const std::string& named) {
  return value_or_raise(episodes::find_episode_file(named, value_or_raise(io::data_folder())))
      .string();
}

// Of a file that is one of the program's sets, its name, once all that it consists of is found
// unchanged; "" for other files, which are not read.
std::string set_of_episodes(const std::string& file) {
  if (episodes::set_of_file(file, value_or_raise(io::data_folder())).empty()) return "";
  return value_or_raise(without_interpreter([&]() -> Result<std::string> {
    MARKETGEN_TRY(const episodes::EpisodeFile read, episodes::read_episode_file(file));
    return read.set;
  }));
}

// By name, the sets of episodes that come with the program.
std::map<std::string, std::string> episode_sets() {
  std::map<std::string, std::string> sets;
  for (const auto& [name, file] : episodes::episode_sets(value_or_raise(io::data_folder())))
    sets[name] = file.string();
  return sets;
}

std::string data_folder_or_raise() {
  return value_or_raise(io::data_folder()).string();
}

}  // namespace

void add_evaluations(nb::module_& module) {
  nb::class_<io::ProcessGroup>(module, "ProcessGroup")
      .def("is_over", &io::ProcessGroup::is_over)
      .def("cpu_s", &io::ProcessGroup::cpu_s)
      .def("end", [](io::ProcessGroup& group) { return io::end_of_program(group.end()); })
      .def(
          "wait",
          [](io::ProcessGroup& group, double limit_s) {
            return io::end_of_program(group.wait(limit_s));
          },
          nb::call_guard<nb::gil_scoped_release>());
  module.def("check_interrupt", [] { check_or_raise(check_interrupt()); });
  module.def("start_process_group", &started);
  module.def("evaluate", &evaluate);
  module.def("evaluate_with", &evaluate_with);
  module.def("serve_episodes", &serve);
  module.def("find_episode_file", &find_episode_file);
  module.def("set_of_episodes", &set_of_episodes);
  module.def("read_shard", [](const std::string& text) {
    const evaluation::Shard shard = value_or_raise(evaluation::read_shard(text));
    return std::pair(shard.part, shard.of);
  });
  module.def("episode_sets", &episode_sets);
  module.def("thread_count", &thread_count);
  module.def("data_folder", &data_folder_or_raise);
  module.def("cache_folder", [] { return io::cache_folder().string(); });
}

}  // namespace marketgen::python
