// marketgen generate: a prompt or a plan becomes a store folder.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/parallel.h"
#include "base/text.h"
#include "command.h"
#include "intake/drawn_shell.h"
#include "intake/photo_wishes.h"
#include "io/file.h"
#include "io/json.h"
#include "io/output.h"
#include "number_flags.h"
#include "planner_flags.h"
#include "say.h"
#include "say_unparsed.h"
#include "store/store.h"

namespace marketgen::app {
namespace {

struct GenerateFlags {
  CommonFlags common;
  std::vector<std::string> words;
  std::string prompt_file, plan_file, planogram_file, floor_plan, floor_plan_scale, size, profile,
      style, country, time, skin, planner = "offline", folder, record;
  std::vector<std::string> catalogs, images, vary;
  planners::PlannerAccess planner_access;
  int count = 1;
  bool strict = false, no_previews = false;
};

// What --json prints for each store.
struct GenerateOutput {
  std::string folder;
  store::Manifest manifest;
  store::StoreReport report;
  std::vector<std::string> pictures;
  static constexpr auto fields =
      field_list(field("folder", &GenerateOutput::folder, "the store folder"),
                 field("manifest", &GenerateOutput::manifest, "store.json"),
                 field("report", &GenerateOutput::report, "report.json"),
                 field("pictures", &GenerateOutput::pictures, "pictures drawn"));
};

Result<intake::Brief> brief_of(const GenerateFlags& flags) {
  intake::Brief brief;
  for (const std::string& word : flags.words)
    brief.prompt += (brief.prompt.empty() ? "" : " ") + word;
  if (!flags.prompt_file.empty()) {
    if (!brief.prompt.empty())
      return Error{
          "usage.bad_flag", "--prompt-file", "give the prompt as words or as a file, not both"};
    constexpr std::uint64_t max_bytes = 1U << 20;
    MARKETGEN_TRY(brief.prompt, io::read_file(flags.prompt_file, max_bytes));
  }
  if (!flags.plan_file.empty() && !brief.prompt.empty()) {
    return Error{"usage.bad_flag", "--plan", "a plan needs no prompt: it says everything itself"};
  }
  if (!flags.plan_file.empty() && !flags.floor_plan.empty())
    return Error{"usage.bad_flag",
                 "--floor-plan",
                 "a plan has its shell already: give one of --plan and --floor-plan"};
  if (!flags.plan_file.empty() && !flags.country.empty())
    return Error{
        "usage.bad_flag", "--country", "a plan says everything itself: write \"country\" into it"};
  if (!flags.floor_plan_scale.empty() && flags.floor_plan.empty())
    return Error{
        "usage.bad_flag", "--floor-plan-scale", "there is no --floor-plan whose scale it would be"};
  if (!flags.plan_file.empty() && !flags.images.empty())
    return Error{"usage.bad_flag",
                 "--image",
                 "a plan has its zones already: give one of --plan and --image"};
  brief.image_files = flags.images;
  if (!flags.floor_plan.empty()) brief.floor_plan = flags.floor_plan;
  if (!flags.floor_plan_scale.empty()) brief.floor_plan_scale = flags.floor_plan_scale;
  if (!flags.size.empty()) {
    MARKETGEN_TRY(brief.size_mm, intake::parse_size(flags.size, "--size"));
  }
  if (!flags.profile.empty()) brief.profile = flags.profile;
  if (!flags.style.empty()) brief.style = flags.style;
  if (!flags.country.empty()) brief.country = flags.country;
  if (!flags.time.empty()) brief.time = flags.time;
  for (const std::string& axis : flags.vary) {
    if (!brief.vary) brief.vary.emplace();
    MARKETGEN_CHECK(plan::add_vary(*brief.vary, axis, "brief.bad_vary", "--vary"));
  }
  if (!flags.skin.empty()) brief.skin = flags.skin;
  brief.planner = flags.planner;
  return brief;
}

std::vector<std::string> pictures_of(const std::filesystem::path& folder,
                                     const store::Manifest& manifest) {
  std::vector<std::string> pictures;
  for (const store::FileDigest& file : manifest.files) {
    if (file.path.ends_with(".png")) pictures.push_back((folder / file.path).string());
  }
  return pictures;
}

void print_requirements(const store::StoreReport& report) {
  if (!report.understood)
    say("understood  nothing: this is the usual store, not what was asked for\n");
  std::size_t met = 0;
  for (const audit::RequirementResult& r : report.requirements)
    met += r.met ? 1 : 0;
  say("wishes      {} of {} met\n", met, report.requirements.size());
  for (const audit::RequirementResult& r : report.requirements) {
    if (!r.met) say("  not met   \"{}\": {}\n", r.text, r.why);
  }
  for (const intake::Conflict& c : report.conflicts)
    say("  given up  {}: kept {}, not \"{}\": {}\n", c.what, c.kept, c.dropped, c.why);
  say_unparsed(report.unparsed);
}

void print_rules(const store::StoreReport& report) {
  std::size_t hard = 0;
  for (const layout::Violation& v : report.rules)
    hard += v.severity == layout::Severity::hard ? 1 : 0;
  say("rules       {} hard and {} soft violations, {} repairs\n",
      hard,
      report.rules.size() - hard,
      report.repairs.size());
  for (const layout::Violation& v : report.rules)
    say("  {:<9} {} {}: {}\n", name_of(v.severity), v.code, v.where, v.message);
}

void print_planner(const std::optional<intake::PlannerRecord>& record) {
  if (!record) return;
  say("planner     {}: plan of the {}, {}\n", record->planner, record->kept, record->why);
  say("cost        {} questions, {} tokens read, {} written, {:.1f} s{}\n",
      record->requests,
      record->tokens_in,
      record->tokens_out,
      record->seconds,
      record->usd ? fmt::format(", {:.4f} US dollars", *record->usd) : "");
}

void print_drawing(const std::optional<intake::DrawnFit>& drawing) {
  if (!drawing) return;
  int runs = 0, drawn_runs = 0;
  for (const intake::DrawnZoneFit& zone : drawing->zones) {
    drawn_runs += zone.drawn_runs.value_or(0);
    if (zone.drawn_runs) runs += std::min(zone.runs.value_or(0), *zone.drawn_runs);
  }
  const std::string shelves =
      drawn_runs > 0 ? fmt::format(", {} of {} runs of shelves", runs, drawn_runs) : "";
  say("drawing     zones agree on {:.0f} % of the floor (IoU){}\n", 100 * drawing->iou, shelves);
}

void print_summary(const GenerateOutput& output) {
  const scene::SceneCounts& counts = output.manifest.counts;
  const auto number = [](std::uint64_t n) { return with_thousands(static_cast<std::int64_t>(n)); };
  say("store       {}  \"{}\"\n", output.folder, output.manifest.name);
  say("counts      {} products, {} SKUs, {} facings, {} fixtures\n",
      number(counts.products),
      number(counts.skus),
      number(counts.facings),
      number(counts.fixtures));
  const audit::Metrics& m = output.report.metrics;
  say("metrics     {:.0f} items/m2, {:.0f} % of shelf front stocked, COL {:.2f} %, OOB {}, NAV "
      "{:.3f}\n",
      m.DENS,
      100 * m.fill,
      100 * m.COL,
      m.OOB,
      m.NAV);
  print_planner(output.report.planner);
  print_drawing(output.report.drawing);
  print_requirements(output.report);
  print_rules(output.report);
  for (const scene::Unstocked& own : output.report.unstocked)
    say("not stocked {}: {}\n", own.sku, own.why);
  std::string times;
  for (const store::StageTiming& t : output.report.timing_s)
    times += fmt::format("{}{} {:.2f}", times.empty() ? "" : ", ", t.stage, t.seconds);
  say("seconds     {}; peak memory {:.0f} MB\n", times, output.report.peak_rss_mb);
  say("scene_hash  {}\n", output.manifest.scene_hash);
  for (const std::string& picture : output.pictures)
    say("picture     {}\n", picture);
}

std::filesystem::path folder_of(const GenerateFlags& flags, int variant) {
  const std::filesystem::path folder = flags.folder;
  return flags.count > 1 ? folder / fmt::format("variant-{}", variant + 1) : folder;
}

// Before any work: whether every store, and what a model says, has a place.
Result<void> probe_folders(const GenerateFlags& flags) {
  io::Outputs record;
  if (!flags.record.empty()) MARKETGEN_CHECK(record.add_folder(flags.record));
  for (int variant = 0; variant < flags.count; ++variant) {
    const Result<io::FolderDraft> draft = io::FolderDraft::begin(folder_of(flags, variant));
    if (!draft.ok()) return draft.error();
  }
  return {};
}

Result<void> generate_one(const GenerateFlags& flags,
                          const intake::Brief& brief,
                          const catalog::Catalog& catalog,
                          int variant) {
  store::CreateOptions options;
  options.folder = folder_of(flags, variant);
  options.brief = brief;
  if (!flags.plan_file.empty()) options.plan_file = flags.plan_file;
  if (!flags.planogram_file.empty()) options.planogram_file = flags.planogram_file;
  options.planner = flags.planner_access;
  options.planner.record = flags.record;
  options.seed = flags.common.seed + static_cast<std::uint64_t>(variant);
  options.previews = !flags.no_previews;
  options.strict = flags.strict;
  MARKETGEN_TRY(store::Created created,
                store::create_store(options, catalog, progress_for(flags.common)));
  GenerateOutput output{
      options.folder.string(), std::move(created.manifest), std::move(created.report), {}};
  output.pictures = pictures_of(options.folder, output.manifest);
  if (const auto& record = output.report.planner) {
    for (const std::string& warning : record->warnings)
      fmt::print(stderr, "warning: {}\n", shown(warning));
  }
  if (!output.report.understood)
    fmt::print(
        stderr,
        "warning: nothing of the prompt was understood; {} is the usual store. Describe it in "
        "English, as in \"a 24 x 15 m supermarket with a bakery\" (docs/prompts.md)\n",
        shown(output.folder));
  if (flags.common.json)
    fmt::print("{}\n", io::write_json_line(output));
  else
    print_summary(output);
  return {};
}

Result<void> generate(const GenerateFlags& flags) {
  const ThreadLimit limit(flags.common.threads);
  MARKETGEN_TRY(intake::Brief asked, brief_of(flags));
  MARKETGEN_CHECK(probe_folders(flags));
  MARKETGEN_TRY(const catalog::Catalog catalog, load_rows(flags.catalogs));
  MARKETGEN_TRY(const intake::Drawn drawn, intake::with_drawing(std::move(asked), catalog));
  const intake::Brief& brief = drawn.brief;
  for (const std::string& warning : drawn.warnings)
    fmt::print(stderr, "warning: {}\n", shown(warning));
  for (const photo::PhotoReading& photo : brief.photos)
    if (!flags.common.json) say("photo       {}: {}\n", photo.file, intake::words_of(photo));
  for (int variant = 0; variant < flags.count; ++variant)
    MARKETGEN_CHECK(generate_one(flags, brief, catalog, variant));
  return {};
}

// What the store is made of beside words.
void add_sources(CLI::App& command, GenerateFlags& flags) {
  command.add_option("--prompt-file", flags.prompt_file, "read the prompt from a file")
      ->type_name("FILE");
  command
      .add_option("--plan", flags.plan_file, "start from a market-plan/1 file instead of a prompt")
      ->type_name("FILE");
  command
      .add_option("--planogram",
                  flags.planogram_file,
                  "what shall stand on its shelves, as a CSV file like that of export --format "
                  "planogram; shelves that it does not name are stocked as usual")
      ->type_name("FILE");
  command
      .add_option("--floor-plan",
                  flags.floor_plan,
                  "SVG, DXF, PNG or JPEG of the room: outline, doors and columns")
      ->type_name("FILE");
  command
      .add_option("--floor-plan-scale",
                  flags.floor_plan_scale,
                  "its scale where the file says none: \"1 unit = 10 mm\", \"1 px = 2 cm\", 1:100")
      ->type_name("SCALE");
  command
      .add_option("--image",
                  flags.images,
                  "PNG or JPEG: a photo of a shop, whose materials, light and shelves the store "
                  "gets, or one drawing of zones with names on them (repeatable); a language "
                  "model that plans "
                  "is shown them, too")
      ->type_name("FILE");
}

// What of it is said apart from the words.
void add_room(CLI::App& command, GenerateFlags& flags) {
  command.add_option("--size", flags.size, "size of the room, e.g. 24x15m")->type_name("SIZE");
  command
      .add_option("--profile",
                  flags.profile,
                  "kind of shop, e.g. supermarket-eu, discounter, convenience-us")
      ->type_name("PROFILE");
  command.add_option("--style", flags.style, "look, e.g. scandinavian, industrial, warm-deli")
      ->type_name("STYLE");
  command
      .add_option("--country",
                  flags.country,
                  "whose money and units price tags have, e.g. us, gb, cn, jp; by itself euro, or "
                  "what the kind of shop says (\"American supermarket\")")
      ->type_name("COUNTRY");
  command
      .add_option("--time",
                  flags.time,
                  "weekday and hour that the shelves show, \"Sat 17:30\": what shoppers took since "
                  "the last restocking is gone; by itself no time")
      ->type_name("TIME");
  command
      .add_option("--vary",
                  flags.vary,
                  "AXIS=SEED, repeatable: what a seed of its own draws in this store, whatever "
                  "--seed is: " +
                      fmt::format("{}", fmt::join(plan::vary_axes(), ", ")))
      ->type_name("AXIS=SEED")
      ->allow_extra_args(false)
      ->delimiter(',');
  command
      .add_option(
          "--skin", flags.skin, "a style's materials, colours and light; the layout stays as it is")
      ->type_name("STYLE");
  command
      .add_option(
          "--catalog", flags.catalogs, "products of your own: CSV, JSON or asset.json (repeatable)")
      ->type_name("FILE");
}

}  // namespace

Run add_generate(CLI::App& app) {
  auto flags = std::make_shared<GenerateFlags>();
  CLI::App* command = app.add_subcommand("generate", "Make a store folder from a prompt or a plan");
  command->add_option("prompt", flags->words, "what the store should be, in words")
      ->type_name("WORDS");
  add_output(*command, "-o,--output", flags->folder, "folder to make; must not exist or be empty")
      ->required();
  add_sources(*command, *flags);
  add_room(*command, *flags);
  add_planner_flags(*command, flags->planner, flags->planner_access, flags->record);
  command->add_option("--count", flags->count, "make this many variants, DIR/variant-1 ...")
      ->check(whole_number(1, 10000));
  command->add_flag("--strict",
                    flags->strict,
                    "fail when a hard rule is broken or the prompt contradicts itself");
  command->add_flag("--no-previews", flags->no_previews, "draw no pictures");
  add_common_flags(*command, flags->common, Takes::seed_and_json);
  command->footer(
      "Example:  marketgen generate \"a 24 x 15 m supermarket, dairy along the back wall, five "
      "checkouts\" -o shop --seed 7");
  return [flags] {
    const auto done = generate(*flags);
    return done.ok() ? 0 : fail(done.error());
  };
}

}  // namespace marketgen::app
