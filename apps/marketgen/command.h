// What every command shares: its flags, how it reports errors, and the list of commands.
#pragma once
#include <CLI/CLI.hpp>

#include <cstdint>
#include <functional>
#include <string>

#include "base/progress.h"
#include "base/result.h"
#include "catalog/catalog.h"
#include "scene/scene.h"
#include "store/planogram.h"

namespace marketgen::app {

struct CommonFlags {
  std::uint64_t seed = 1;
  int threads = 0;
  bool quiet = false;
  bool json = false;
};

// Adds --threads, --quiet and the others that were asked for.
enum class Takes { nothing = 0, seed = 1, json = 2, seed_and_json = 3 };
void add_common_flags(CLI::App& command, CommonFlags& flags, Takes takes);

// An option that names an output: shown as OUTPUT in the help, and refused when it is empty. The
// path goes to Outputs (io/output.h) before any work.
CLI::Option* add_output(CLI::App& command,
                        const std::string& name,
                        std::string& path,
                        const std::string& what);

// Prints the error to stderr; the exit status that belongs to its code.
int fail(const Error& error);

// The rows under data_folder() and the user's own.
Result<catalog::Catalog> load_rows(const std::vector<std::string>& extra = {});

// The store's own rows beside ours.
Result<catalog::Catalog> load_rows_of_store(const std::string& folder);

// The planogram's file, read for the store. Rows that are refused are all printed; the error is the
// first of them.
Result<scene::PlanogramFile> planogram_for(const std::string& file,
                                           const store::Store& store,
                                           const catalog::Catalog& catalog);

// The scene of a store folder; in the look of another style when `skin` names one.
Result<scene::Scene> scene_in_skin(const std::string& folder, const std::string& skin);

// Progress on stderr, or none when --quiet.
Progress& progress_for(const CommonFlags& flags);

using Run = std::function<int()>;  // returns the exit status

// One function a command, each in its own file: adds the subcommand to `app` and returns what runs
// it.
#define COMMAND(name) Run add_##name(CLI::App& app);
#include "commands.inc"
#undef COMMAND

}  // namespace marketgen::app
