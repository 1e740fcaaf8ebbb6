// marketgen grasps: try grasps of products in physics and keep how often they hold.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <mutex>

#include "base/interrupt.h"
#include "base/parallel.h"
#include "base/seed.h"
#include "command.h"
#include "episodes/aisle/grasp_book.h"
#include "grasping/grasp_database.h"
#include "grasping/grasp_shares.h"
#include "grasping/grasp_table.h"
#include "io/file.h"
#include "io/json.h"
#include "io/output.h"
#include "named_flag.h"
#include "number_flags.h"
#include "say.h"

namespace marketgen::app {
namespace {

struct GraspFlags {
  CommonFlags common;
  std::vector<std::string> skus, tools, settings, catalogs;
  std::string archetype;
  std::filesystem::path table;
  int tries = 3;
  std::size_t sample = 0;  // so many of the products, by the seed; 0: all
};

// What `--json` prints.
struct GraspReport {
  int products = 0;
  double seconds = 0;
  std::string database;
  std::vector<grasping::GraspShare> shares;
  std::vector<grasping::GraspRate> rates;
  static constexpr auto fields =
      field_list(field("products", &GraspReport::products, "products tried"),
                 field("seconds", &GraspReport::seconds, "wall clock"),
                 field("database", &GraspReport::database, "where the rates are kept"),
                 field("shares", &GraspReport::shares, "by tool, setting and shape"),
                 field("rates", &GraspReport::rates, "of each product, only when SKUs are named"));
};

Result<std::vector<const catalog::Product*>> chosen_products(const catalog::Catalog& catalog,
                                                             const GraspFlags& flags) {
  std::vector<const catalog::Product*> chosen;
  std::vector<std::string_view> skus;
  for (const catalog::Product& product : catalog.products) {
    skus.push_back(product.sku);
    const bool wanted = flags.archetype.empty() || product.archetype == flags.archetype;
    if (flags.skus.empty() && wanted) chosen.push_back(&product);
  }
  for (const std::string& sku : flags.skus) {
    const catalog::Product* product = catalog.product(sku);
    if (product == nullptr)
      return catalog::unknown_name("catalog.unknown_sku", "grasps", "product", sku, skus);
    chosen.push_back(product);
  }
  if (flags.sample > 0 && flags.sample < chosen.size()) {
    Stream draw = Seed(flags.common.seed).child("sample").stream();
    draw.shuffle(std::span<const catalog::Product*>(chosen));
    chosen.resize(flags.sample);
    std::ranges::sort(chosen, {}, &catalog::Product::sku);
  }
  if (chosen.empty())
    return Error{
        "catalog.unknown_kind",
        "--archetype",
        "no product has the shape \"" + flags.archetype + "\"; see `marketgen assets list`"};
  return chosen;
}

Result<std::vector<robots::GraspTool>> chosen_tools(const GraspFlags& flags) {
  MARKETGEN_TRY(const std::filesystem::path data, io::data_folder());
  MARKETGEN_TRY(std::vector<std::string> ids, robots::grasp_tool_ids(data));
  if (!flags.tools.empty()) ids = flags.tools;
  std::vector<robots::GraspTool> tools;
  for (const std::string& id : ids) {
    MARKETGEN_TRY(robots::GraspTool tool, robots::load_grasp_tool(data, id));
    tools.push_back(std::move(tool));
  }
  return tools;
}

Result<std::vector<grasping::GraspSetting>> chosen_settings(const GraspFlags& flags) {
  const auto names = grasping::names_of(grasping::GraspSetting{});
  std::vector<grasping::GraspSetting> settings;
  for (const std::string& name : flags.settings) {
    const auto found = std::ranges::find(names, name);
    if (found == names.end())
      return catalog::unknown_name(
          "usage.bad_flag", "--setting", "setting", name, {names.begin(), names.end()});
    settings.push_back(static_cast<grasping::GraspSetting>(found - names.begin()));
  }
  if (settings.empty()) settings.push_back(grasping::GraspSetting::free);
  return settings;
}

std::string percent(const grasping::Share& share) {
  if (share.of == 0) return "-";
  return fmt::format(
      "{:5.1f} % ({:.1f}-{:.1f})", share.share * 100, share.low * 100, share.high * 100);
}

std::string excluded_text(const grasping::GraspShare& share) {
  std::vector<std::string> parts;
  for (const grasping::ExclusionCount& count : share.excluded)
    parts.push_back(fmt::format("{} {}", name_of(count.why), count.products));
  return fmt::format("{}", fmt::join(parts, ", "));
}

void print_shares(const std::vector<grasping::GraspShare>& shares) {
  for (const grasping::GraspShare& share : shares) {
    const bool all = share.archetype.empty();
    if (all)
      say("\n{}, {}\n{:<18} {:>5} {:>5}  {:<20} {:<20} {:>8}  {} | {}\n",
          share.tool,
          name_of(share.setting),
          "shape",
          "SKUs",
          "fit",
          "best held (95 %)",
          "any held (95 %)",
          "slip mm",
          "excluded",
          "lost");
    say("{:<18} {:>5} {:>5}  {:<20} {:<20} {:>8.2f}  {} | {}\n",
        all ? "all" : share.archetype,
        share.products,
        share.fit.number,
        percent(share.first),
        percent(share.any),
        share.slip_p99_mm,
        excluded_text(share),
        fmt::join(share.lost, ", "));
  }
}

void print_rate(const grasping::GraspRate& rate) {
  say("{} {} {}: ", rate.sku, rate.tool, name_of(rate.setting));
  if (!rate.fits()) return say("{}: {}\n", name_of(rate.excluded), rate.reason);
  say("{} of {} held\n", rate.held(), rate.tries.size());
  for (const grasping::GraspTry& t : rate.tries)
    say("  {:<14} {:<9} {:5.1f} mm {:5.1f} N  slip {:.3f} mm, turned {:.2f} deg, neighbours {:.1f} "
        "N\n",
        name_of(t.strategy),
        name_of(t.end),
        t.width_mm,
        t.force_n,
        t.slip_mm,
        t.turned_deg,
        t.neighbour_n);
}

// Products that were named, none of which any of the tools can take hold of.
Result<void> check_graspable(const std::vector<grasping::GraspRate>& rates) {
  if (std::ranges::any_of(rates, &grasping::GraspRate::fits)) return {};
  return Error{"motion.no_grasp",
               rates.front().sku,
               fmt::format("{} ({})", rates.front().reason, rates.front().tool)};
}

// Keeps the rates of the study; those that were finished, too, when it was broken off.
Result<std::vector<grasping::GraspRate>> study_and_keep(
    const std::vector<const catalog::Product*>& products,
    const std::vector<robots::GraspTool>& tools,
    const catalog::Catalog& catalog,
    grasping::StudyOptions options,
    const GraspFlags& flags) {
  MARKETGEN_TRY(const std::filesystem::path data, io::data_folder());
  MARKETGEN_TRY(const std::string key,
                grasping::grasp_study_key(data, catalog.content_hash, options));
  constexpr double keep_every_s = 5;  // a study of the catalogue takes hours
  std::mutex mutex;
  std::vector<grasping::GraspRate> finished;
  double kept_s = monotonic_seconds();
  options.finished = [&](const std::vector<grasping::GraspRate>& rates) {
    const std::scoped_lock lock(mutex);
    finished.insert(finished.end(), rates.begin(), rates.end());
    if (monotonic_seconds() < kept_s + keep_every_s) return;
    kept_s = monotonic_seconds();  // an error shows at the end
    (void)grasping::keep_grasp_rates(finished, key, options.seed).ok();
  };
  auto rates = until_interrupted([&] {
    return grasping::study_grasps(
        products, tools, catalog.frictions, options, progress_for(flags.common));
  });
  const NoForcedEnd keeping;
  MARKETGEN_CHECK(grasping::keep_grasp_rates(finished, key, options.seed));
  return rates;
}

Result<void> grasps(const GraspFlags& flags) {
  const ThreadLimit limit(flags.common.threads);
  (void)grasping::kept_grasp_rates({});  // takes away what lies there and cannot be used
  io::Outputs database;
  MARKETGEN_CHECK(database.add(
      {{"MARKETGEN_CACHE", grasping::grasp_database_file()}, {"--table", flags.table}}));
  const double started_s = monotonic_seconds();
  MARKETGEN_TRY(const catalog::Catalog catalog, load_rows(flags.catalogs));
  MARKETGEN_TRY(const std::vector<const catalog::Product*> products,
                chosen_products(catalog, flags));
  MARKETGEN_TRY(const std::vector<robots::GraspTool> tools, chosen_tools(flags));
  grasping::StudyOptions options;
  options.tries = flags.tries;
  options.seed = flags.common.seed;
  MARKETGEN_TRY(options.settings, chosen_settings(flags));
  if (!flags.table.empty()) options = episodes::GraspBook::options();
  MARKETGEN_TRY(const std::vector<grasping::GraspRate> rates,
                study_and_keep(products, tools, catalog, options, flags));
  if (!flags.table.empty()) {
    MARKETGEN_TRY(const std::string text,
                  grasping::grasp_table_text(rates, products, tools, catalog.frictions));
    MARKETGEN_CHECK(database.put(flags.table, text));
    MARKETGEN_CHECK(database.commit());
  }

  GraspReport report{static_cast<int>(products.size()),
                     monotonic_seconds() - started_s,
                     grasping::grasp_database_file().string(),
                     grasping::grasp_shares(rates),
                     {}};
  const bool named = !flags.skus.empty();
  if (named) report.rates = rates;
  if (flags.common.json) {
    fmt::print("{}", io::write_json(report));
  } else {
    if (named)
      std::ranges::for_each(rates, print_rate);
    else
      print_shares(report.shares);
    say("\n{} products in {:.0f} s; rates kept in {}\n",
        report.products,
        report.seconds,
        report.database);
  }
  return named ? check_graspable(rates) : Result<void>();
}

}  // namespace

Run add_grasps(CLI::App& app) {
  auto flags = std::make_shared<GraspFlags>();
  CLI::App* command = app.add_subcommand(
      "grasps", "Try grasps of products in physics; keep and print how often they hold");
  command->add_option("skus", flags->skus, "products; none = the whole catalogue")
      ->type_name("SKU");
  command
      ->add_option("--tool",
                   flags->tools,
                   "row of a tool: panda-hand, parallel-gripper, suction-cup; "
                   "again for more; none = all")
      ->type_name("TOOL")
      ->allow_extra_args(false);
  CLI::Option* setting =
      command
          ->add_option(
              "--setting",
              flags->settings,
              "free (on a table), stocked (on a shelf, gaps of 2 to 8 mm), spaced (gaps of "
              "30 mm) or basket (among its likes); again for more; none = free")
          ->type_name(choice_of(grasping::names_of(grasping::GraspSetting{})))
          ->allow_extra_args(false);
  command->add_option("--archetype", flags->archetype, "only products of this shape")
      ->type_name("SHAPE");
  command->add_option("--sample", flags->sample, "only so many of them, drawn by the seed; 0 = all")
      ->check(whole_number(0, 100000));
  CLI::Option* tries =
      command->add_option("--tries", flags->tries, "candidates tried of each product, best first")
          ->check(whole_number(1, 20))
          ->capture_default_str();
  command
      ->add_option("--table",
                   flags->table,
                   "also write what episodes in aisles ask for as rows, like data/grasps.csv")
      ->type_name("FILE")
      ->excludes(setting)
      ->excludes(tries);
  command
      ->add_option("--catalog",
                   flags->catalogs,
                   "products of your own: CSV, JSON or asset.json (repeatable)")
      ->type_name("FILE");
  add_common_flags(*command, flags->common, Takes::seed_and_json);
  command->footer(
      "Example:  marketgen grasps beverages-cola-original-330ml --tool panda-hand --tries 5");
  return [flags] {
    const auto done = grasps(*flags);
    return done.ok() ? 0 : fail(done.error());
  };
}

}  // namespace marketgen::app
