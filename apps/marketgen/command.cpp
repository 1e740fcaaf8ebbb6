#include "command.h"

#include <fmt/format.h>

#include "assets/usable_catalog.h"
#include "base/error_codes.h"
#include "catalog/user_products.h"
#include "number_flags.h"
#include "plan/style_look.h"
#include "scene/reskin.h"
#include "store/store.h"

namespace marketgen::app {
void add_common_flags(CLI::App& command, CommonFlags& flags, Takes takes) {
  const int bits = static_cast<int>(takes);
  if ((bits & static_cast<int>(Takes::seed)) != 0)
    command.add_option("--seed", flags.seed, "seed of every random choice")
        ->check(whole_number(0, any_seed))
        ->capture_default_str();
  if ((bits & static_cast<int>(Takes::json)) != 0)
    command.add_flag("--json", flags.json, "print the result as JSON");
  command
      .add_option(
          "--threads", flags.threads, "threads to use; 0 = all cores (results do not depend on it)")
      ->check(whole_number(0, 1024));
  command.add_flag("--quiet", flags.quiet, "no progress, no remarks");
}

CLI::Option* add_output(CLI::App& command,
                        const std::string& name,
                        std::string& path,
                        const std::string& what) {
  return command.add_option(name, path, what)
      ->type_name("OUTPUT")
      ->check([](const std::string& text) {
        return text.empty() ? "is empty; name a file or folder to write" : "";
      });
}

int fail(const Error& error) {
  fmt::print(stderr, "{}\n", to_string(error));
  return exit_status_of(error.code);
}

Result<catalog::Catalog> load_rows(const std::vector<std::string>& extra) {
  return assets::usable_catalog({extra.begin(), extra.end()});
}

Result<catalog::Catalog> load_rows_of_store(const std::string& folder) {
  MARKETGEN_TRY(catalog::Catalog catalog, load_rows());
  MARKETGEN_TRY(const store::Manifest manifest, store::read_manifest(folder));
  if (!manifest.own) return catalog;
  return catalog::with_own_products(std::move(catalog), *manifest.own);
}

Result<scene::PlanogramFile> planogram_for(const std::string& file,
                                           const store::Store& store,
                                           const catalog::Catalog& catalog) {
  MARKETGEN_TRY(scene::PlanogramFile planogram, store::read_planogram_file(file, store, catalog));
  for (std::size_t i = 1; i < planogram.refused.size(); ++i)
    fail(planogram.refused[i]);
  if (!planogram.refused.empty()) return planogram.refused.front();
  return planogram;
}

Result<scene::Scene> scene_in_skin(const std::string& folder, const std::string& skin) {
  MARKETGEN_TRY(scene::Scene scene, store::open_store_scene(folder));
  if (skin.empty()) return scene;
  MARKETGEN_TRY(const catalog::Catalog catalog, load_rows());
  MARKETGEN_TRY(const catalog::StyleRow* style, plan::style_called(catalog, skin, "--skin"));
  return scene::reskin(std::move(scene), *style, catalog);
}

Progress& progress_for(const CommonFlags& flags) {
  static ConsoleProgress console;
  return flags.quiet ? silent_progress() : console;
}

}  // namespace marketgen::app
