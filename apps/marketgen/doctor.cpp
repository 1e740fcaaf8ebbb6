// marketgen doctor: is everything there that the program needs, and what mends what is not.
#include <unistd.h>

#include <fmt/format.h>

#include <thread>

#include "assets/print/fonts.h"
#include "assets/shapes/convex_worker.h"
#include "base/build_info.h"
#include "build_facts.h"
#include "command.h"
#include "io/file.h"
#include "io/json.h"
#include "io/program.h"

namespace marketgen::app {
namespace {

namespace fs = std::filesystem;

struct Finding {
  std::string part, state, detail, mend;  // state: ok, missing, optional
  static constexpr auto fields =
      field_list(field("part", &Finding::part, "what was looked at"),
                 field("state", &Finding::state, "ok, missing or optional"),
                 field("detail", &Finding::detail, "what was found"),
                 field("mend", &Finding::mend, "what mends it"));
};

Finding check_processor() {
  const bool good = __builtin_cpu_supports("avx2") != 0 && __builtin_cpu_supports("fma") != 0;
  return {"processor",
          good ? "ok" : "missing",
          fmt::format(
              "{} cores, x86-64-v3 {}", std::thread::hardware_concurrency(), good ? "yes" : "no"),
          good ? "" : "use a processor with AVX2 (Intel 2013, AMD 2015 or later)"};
}

Finding check_memory() {
  const double gigabytes = static_cast<double>(sysconf(_SC_PHYS_PAGES)) *
                           static_cast<double>(sysconf(_SC_PAGE_SIZE)) / 1e9;
  constexpr double wanted = 2;
  return {"memory",
          gigabytes >= wanted ? "ok" : "missing",
          fmt::format("{:.1f} GB", gigabytes),
          gigabytes >= wanted ? "" : "2 GB are needed for a 40 x 25 m store"};
}

Finding check_rows() {
  const auto folder = io::data_folder();
  if (!folder.ok())
    return {"data rows",
            "missing",
            folder.error().message,
            "set MARKETGEN_DATA to the data folder of the installation"};
  const auto catalog = catalog::load_catalog(*folder);
  if (!catalog.ok())
    return {"data rows",
            "missing",
            to_string(catalog.error()),
            "restore the data folder: " + folder->string()};
  return {"data rows",
          "ok",
          fmt::format("{} products, {} fixture kinds in {}",
                      catalog->products.size(),
                      catalog->fixture_kinds.size(),
                      folder->string()),
          ""};
}

Finding check_cache() {
  std::error_code failed;
  fs::create_directories(io::cache_folder(), failed);
  const bool writable = access(io::cache_folder().c_str(), W_OK) == 0;
  return {"cache",
          writable ? "ok" : "missing",
          io::cache_folder().string(),
          writable ? "" : "set MARKETGEN_CACHE to a folder that can be written"};
}

Finding check_fonts() {
  const std::string absent = fmt::format("{}", fmt::join(assets::missing_fonts(), " "));
  return {"fonts",
          absent.empty() ? "ok" : "missing",
          absent.empty() ? "DejaVu, Lato, Open Sans" : "not found: " + absent,
          absent.empty() ? "" : "apt-get install " + absent + ", or install marketgen again"};
}

Finding check_program(const std::string& name,
                      const std::string& used_for,
                      const std::string& package) {
  const char* path = std::getenv("PATH");
  for (std::string rest = path == nullptr ? "" : path; !rest.empty();) {
    const std::size_t end = rest.find(':');
    if (fs::exists(fs::path(rest.substr(0, end)) / name)) return {name, "ok", used_for, ""};
    rest = end == std::string::npos ? "" : rest.substr(end + 1);
  }
  return {name, "optional", "not found; " + used_for, package};
}

Finding check_worker_part(const std::string& package,
                          const std::string& use,
                          const std::string& without) {
  const Result<std::string> version = io::worker_part(package);
  if (version.ok()) return {package, "ok", *version + "; " + use, ""};
  return {package,
          "optional",
          "not found; " + without,
          io::worker_python() + " -m pip install " + package};
}

// What it was built of is no fault, but whoever reports one is asked for it.
Finding program() {
  return {"program", "ok", fmt::format("marketgen {}, {}", program_version, build_in_words()), ""};
}

Finding check_libraries() {
  std::vector<std::string> found;
  for (const BuildFact& library : deciding_libraries())
    found.push_back(library.name + " " + library.value);
  return {"libraries", "ok", fmt::format("{}", fmt::join(found, ", ")), ""};
}

std::vector<Finding> look() {
  return {program(),
          check_processor(),
          check_memory(),
          check_rows(),
          check_cache(),
          check_fonts(),
          check_libraries(),
          check_program(
              "zbarimg", "reads the printed bar codes in tests", "apt-get install zbar-tools"),
          check_worker_part("coacd",
                            "contact pieces of imported models",
                            "imported models get one hull as contact shape"),
          check_worker_part("av", "films of episodes", "`replay` writes no films"),
          check_worker_part(
              "usd-core", "reads USD exports back", "`export --format usd` goes without --check"),
          check_program("flatc", "reads scene.bin as JSON", "apt-get install flatbuffers-compiler"),
          check_program("node", "runs the glTF validator in tests", "tools/setup test")};
}

int doctor(const CommonFlags& flags) {
  const std::vector<Finding> findings = look();
  bool healthy = true;
  for (const Finding& f : findings)
    healthy = healthy && f.state != "missing";
  if (flags.json) {
    fmt::print("{}", io::write_json(findings));
    return healthy ? 0 : 1;
  }
  for (const Finding& f : findings) {
    fmt::print("{:<9} {:<10} {}\n", f.state == "missing" ? "MISSING" : f.state, f.part, f.detail);
    if (!f.mend.empty()) fmt::print("{:<20} mend: {}\n", "", f.mend);
  }
  fmt::print("{}\n", healthy ? "everything needed is there" : "something needed is missing");
  return healthy ? 0 : 1;
}

}  // namespace

Run add_doctor(CLI::App& app) {
  auto flags = std::make_shared<CommonFlags>();
  CLI::App* command = app.add_subcommand(
      "doctor", "Check the machine, libraries and data; say what mends what is missing");
  add_common_flags(*command, *flags, Takes::json);
  command->footer("Example:  marketgen doctor");
  return [flags] { return doctor(*flags); };
}

}  // namespace marketgen::app
