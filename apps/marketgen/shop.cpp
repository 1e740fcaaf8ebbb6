// marketgen shop: what to buy in a store for a request in words.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <memory>

#include "catalog/country.h"
#include "command.h"
#include "environments/store_assortment.h"
#include "environments/store_shopping.h"
#include "io/json.h"
#include "io/output.h"
#include "planner_flags.h"
#include "planners/make_planner.h"
#include "say.h"
#include "scene/scene.h"
#include "shopping/shopping_plan.h"
#include "store/store.h"

namespace marketgen::app {
namespace {

struct ShopFlags {
  CommonFlags common;
  std::string folder, words, planner = "offline", record;
  std::vector<std::string> sold_out;
  planners::PlannerAccess access;
};

std::string price(double amount, const catalog::Country& country) {
  return catalog::price_text(amount, country);
}

void print_lines(const shopping::ShoppingPlan& plan, const catalog::Country& country) {
  std::size_t name = 0, net = 0;
  for (const shopping::ShoppingLine& line : plan.lines) {
    name = std::max(name, line.name.size());
    net = std::max(net, line.net.size());
  }
  for (const shopping::ShoppingLine& line : plan.lines) {
    say("{:>3} x  {:<{}}  {:<{}}  {:>9}  {}\n",
        line.count,
        line.name,
        name,
        line.net,
        net,
        price(line.count * line.price, country),
        fmt::format("{}", fmt::join(line.answers, "; ")));
    say("       {}; {}\n", line.sku, line.why);
    for (const shopping::Substitute& other : line.substitutes)
      say("       or {} x {}, {}\n", other.count, other.name, price(other.price, country));
  }
}

void print_plan(const shopping::ShoppingPlan& plan, const catalog::Country& country) {
  for (const std::string& menu : plan.menus)
    say("menu        {}\n", menu);
  if (!plan.request.at_home.empty())
    say("at home     {}\n", fmt::format("{}", fmt::join(plan.request.at_home, ", ")));
  print_lines(plan, country);
  say("total       {}", price(plan.total, country));
  if (plan.request.budget) say(" of {}", price(plan.request.budget->amount, country));
  say("\n");
  for (const shopping::UnmetPart& part : plan.unmet)
    say("{}{}: {}\n",
        part.kind == shopping::UnmetKind::not_told ? "not told    " : "not bought  ",
        part.part,
        part.reason);
  if (!plan.left_out.empty())
    say("left out    {}\n", fmt::format("{}", fmt::join(plan.left_out, "; ")));
  if (const auto& shopper = plan.shopper)
    say("planner     {}: plan of the {}, {}\n", shopper->model, shopper->kept, shopper->why);
}

Result<void> shop(const ShopFlags& flags) {
  io::Outputs record;
  if (!flags.record.empty()) MARKETGEN_CHECK(record.add_folder(flags.record));
  MARKETGEN_TRY(const catalog::Catalog rows, load_rows_of_store(flags.folder));
  MARKETGEN_TRY(const scene::Scene scene, store::open_store_scene(flags.folder));
  const shopping::Assortment assortment = environments::assortment_of(scene, flags.sold_out);
  environments::ShoppingOptions options{flags.planner, flags.access};
  options.access.record = flags.record;
  MARKETGEN_TRY(const shopping::ShoppingPlan plan,
                environments::shop(flags.words, assortment, rows, options));
  if (flags.common.json)
    fmt::print("{}", io::write_json(plan));
  else
    print_plan(plan, shopping::country_of(assortment));
  return {};
}

}  // namespace

Run add_shop(CLI::App& app) {
  auto flags = std::make_shared<ShopFlags>();
  CLI::App* command =
      app.add_subcommand("shop", "What to buy in a store for a request in words, and substitutes");
  command->add_option("folder", flags->folder, "store folder")->type_name("STORE")->required();
  command
      ->add_option("request",
                   flags->words,
                   "a meal, items, persons, a budget, what is at home, what must not be in it")
      ->type_name("WORDS")
      ->required();
  command->add_option("--sold-out", flags->sold_out, "what is not there today (repeatable)")
      ->type_name("SKU");
  add_planner_flags(*command, flags->planner, flags->access, flags->record);
  add_common_flags(*command, flags->common, Takes::json);
  command->footer("Example:  marketgen shop shop \"breakfast for two under 10 euros\"");
  return [flags] {
    const auto done = shop(*flags);
    return done.ok() ? 0 : fail(done.error());
  };
}

}  // namespace marketgen::app
