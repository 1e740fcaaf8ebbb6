// Outside programs: started with a command, fed a text, read to the end, within limits. What they
// start ends with them (io/process_group.h).
#pragma once
#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"

namespace marketgen::io {

struct ProgramLimits {
  double seconds = 60;                   // then it is ended
  std::size_t output_bytes = 64U << 20;  // of its standard output; more ends it too
};

// What the program wrote to its standard output. `command[0]` is a path, or a name that is looked
// up in PATH; no shell is involved. Its standard error is kept for the message. Errors:
// usage.unavailable when it cannot be started; program.failed when it ends with another status
// than 0, with a signal, or breaks a limit; internal.interrupted.
Result<std::string> run_program(const std::vector<std::string>& command,
                                std::string_view input,
                                const ProgramLimits& limits = {});

// The Python that runs our workers: $MARKETGEN_PYTHON, the one this is running in, that of the
// environment it is installed into, .venv of the source tree, else python3.
std::string worker_python();
// For Python's module: says which interpreter it is running in. Before any thread asks.
void use_python(const std::string& interpreter);
// The script of our workers, run by itself: beside the data of the installation or in the source
// tree. Error: usage.unavailable.
Result<std::filesystem::path> worker_script();
// The version of a Python package that a worker uses: "coacd", "av" or "usd-core". Error:
// usage.unavailable or program.failed, with what installs it.
Result<std::string> worker_part(const std::string& package);
// What the worker answers to one job (python/marketgen/worker.py). Errors: those of both above and
// of run_program.
Result<std::string> run_worker(const std::string& job, std::string_view request, double seconds);

}  // namespace marketgen::io
