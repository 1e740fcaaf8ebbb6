// marketgen check: a store folder or a plan against schema, digests and design rules.
#include <fmt/format.h>

#include "audit/audit.h"
#include "audit/compliance.h"
#include "base/parallel.h"
#include "command.h"
#include "io/file.h"
#include "io/json.h"
#include "say.h"
#include "store/store.h"

namespace marketgen::app {
namespace {

struct CheckFlags {
  CommonFlags common;
  std::string path, planogram_file;
};

struct CheckOutput {
  std::string path;
  bool ok = true;
  std::vector<layout::Violation> rules;
  std::vector<audit::RequirementResult> requirements;
  std::vector<std::string> repairs;
  std::optional<audit::Compliance> compliance;
  static constexpr auto fields =
      field_list(field("path", &CheckOutput::path, "what was checked"),
                 field("ok", &CheckOutput::ok, "no hard rule is broken"),
                 field("rules", &CheckOutput::rules, "broken rules"),
                 field("requirements", &CheckOutput::requirements, "wishes"),
                 field("repairs", &CheckOutput::repairs, "what generate would mend in the plan"),
                 field("compliance", &CheckOutput::compliance, "with --planogram"));
};

// A plan: all that generate makes of it, in memory.
Result<CheckOutput> check_plan(const CheckFlags& flags) {
  if (!flags.planogram_file.empty())
    return Error{"usage.bad_flag", "--planogram", "goes with a store folder, not with a plan"};
  MARKETGEN_TRY(const catalog::Catalog catalog, load_rows());
  store::CreateOptions options;
  options.plan_file = flags.path;
  options.seed = flags.common.seed;
  MARKETGEN_TRY(store::StoreReport report,
                store::try_store(options, catalog, progress_for(flags.common)));
  return CheckOutput{flags.path, true, std::move(report.rules), {}, std::move(report.repairs), {}};
}

Result<CheckOutput> check_store(const CheckFlags& flags) {
  MARKETGEN_TRY(const catalog::Catalog catalog, load_rows_of_store(flags.path));
  MARKETGEN_CHECK(store::verify_store(flags.path, catalog));
  MARKETGEN_TRY(const store::Store store, store::open_store(flags.path, catalog));
  MARKETGEN_TRY(audit::Audit audit,
                audit::audit_store(store.scene, catalog, store.manifest.requirements));
  CheckOutput output{
      flags.path, true, std::move(audit.rules), std::move(audit.requirements), {}, {}};
  if (flags.planogram_file.empty()) return output;
  MARKETGEN_TRY(const scene::PlanogramFile planogram,
                planogram_for(flags.planogram_file, store, catalog));
  output.compliance = audit::compliance_of(store.scene, planogram, catalog);
  return output;
}

void print_compliance(const audit::Compliance& c) {
  const audit::FacingCounts& f = c.facings;
  for (const audit::UnmetFacing& u : c.unmet)
    say("line {:<6} {:<13} {}, {}, shelf {}, position {}, facing {}: {}{}\n",
        u.line,
        name_of(u.fault),
        u.fixture,
        name_of(u.side),
        u.shelf,
        u.position,
        u.column,
        u.sku,
        u.stands.empty() ? "" : ", not " + u.stands);
  for (const audit::CategoryCompliance& row : c.categories)
    say("category    {:<16} {:.4f}  {} of {} facings\n",
        row.category,
        row.score,
        row.facings.met,
        row.facings.planned);
  say("compliance  {:.4f}: {} of {} facings; {} missing, {} wrong products, {} misplaced; {} packs "
      "where none is planned\n",
      c.score,
      f.met,
      f.planned,
      f.missing,
      f.wrong_product,
      f.misplaced,
      c.extra);
  say("price tags  {:.4f}: {} of {} right; {} missing, {} of wrong price, {} of wrong product, {} "
      "doubled\n",
      c.tag_score,
      c.tags.right,
      c.tags.planned,
      c.tags.missing,
      c.tags.wrong_price,
      c.tags.wrong_product,
      c.tags.doubled);
}

Result<int> check(const CheckFlags& flags) {
  const ThreadLimit limit(flags.common.threads);
  std::error_code failed;
  if (!std::filesystem::exists(flags.path, failed))
    return Error{"input.not_found", flags.path, "there is no such file or folder"};
  const bool is_file = std::filesystem::is_regular_file(flags.path, failed);
  MARKETGEN_TRY(CheckOutput output, is_file ? check_plan(flags) : check_store(flags));
  for (const layout::Violation& v : output.rules)
    output.ok = output.ok && v.severity != layout::Severity::hard;
  if (flags.common.json) {
    fmt::print("{}", io::write_json(output));
    return output.ok ? 0 : 1;
  }
  for (const std::string& repair : output.repairs)
    say("mend  {}\n", repair);
  for (const layout::Violation& v : output.rules) {
    say("{:<5} {:<20} {}: {}\n", name_of(v.severity), v.code, v.where, v.message);
    if (const std::string_view remedy = audit::remedy_of(v.code); !remedy.empty())
      say("      {:<20} {}\n", "what mends it", remedy);
  }
  for (const audit::RequirementResult& r : output.requirements) {
    if (!r.met) say("wish  not met              \"{}\": {}\n", r.text, r.why);
  }
  if (output.compliance) print_compliance(*output.compliance);
  const auto hard =
      std::ranges::count(output.rules, layout::Severity::hard, &layout::Violation::severity);
  say("{} {}: {} hard and {} soft rules broken\n",
      output.ok ? "ok" : "FAILED",
      flags.path,
      hard,
      std::ssize(output.rules) - hard);
  return output.ok ? 0 : 1;
}

}  // namespace

Run add_check(CLI::App& app) {
  auto flags = std::make_shared<CheckFlags>();
  CLI::App* command =
      app.add_subcommand("check", "Check a store folder or a plan against schema and design rules");
  command->add_option("path", flags->path, "store folder, or market-plan/1 file")
      ->type_name("PATH")
      ->required();
  command
      ->add_option("--planogram",
                   flags->planogram_file,
                   "measure, too, how far the store stands as this planogram says: a CSV file like "
                   "that of export --format planogram")
      ->type_name("FILE");
  add_common_flags(*command, flags->common, Takes::seed_and_json);
  command->footer(
      "Exit status 1 when a hard rule is broken or a file was changed.\nExample:  marketgen check "
      "shop --json");
  return [flags] {
    const auto status = check(*flags);
    return status.ok() ? *status : fail(status.error());
  };
}

}  // namespace marketgen::app
