// marketgen check: a store folder or a plan against schema, digests and design rules.
#include <fmt/format.h>

#include "audit/audit.h"
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
  std::string path;
};

struct CheckOutput {
  std::string path;
  bool ok = true;
  std::vector<layout::Violation> rules;
  std::vector<audit::RequirementResult> requirements;
  std::vector<std::string> repairs;
  static constexpr auto fields =
      field_list(field("path", &CheckOutput::path, "what was checked"),
                 field("ok", &CheckOutput::ok, "no hard rule is broken"),
                 field("rules", &CheckOutput::rules, "broken rules"),
                 field("requirements", &CheckOutput::requirements, "wishes"),
                 field("repairs", &CheckOutput::repairs, "what generate would mend in the plan"));
};

// A plan: all that generate makes of it, in memory.
Result<CheckOutput> check_plan(const CheckFlags& flags, const catalog::Catalog& catalog) {
  store::CreateOptions options;
  options.plan_file = flags.path;
  options.seed = flags.common.seed;
  MARKETGEN_TRY(store::StoreReport report,
                store::try_store(options, catalog, progress_for(flags.common)));
  return CheckOutput{flags.path, true, std::move(report.rules), {}, std::move(report.repairs)};
}

Result<CheckOutput> check_store(const CheckFlags& flags, const catalog::Catalog& catalog) {
  MARKETGEN_CHECK(store::verify_store(flags.path, catalog));
  MARKETGEN_TRY(const store::Store store, store::open_store(flags.path, catalog));
  MARKETGEN_TRY(audit::Audit audit,
                audit::audit_store(store.scene, catalog, store.manifest.requirements));
  return CheckOutput{flags.path, true, std::move(audit.rules), std::move(audit.requirements), {}};
}

Result<int> check(const CheckFlags& flags) {
  const ThreadLimit limit(flags.common.threads);
  MARKETGEN_TRY(const catalog::Catalog catalog, load_rows());
  std::error_code failed;
  if (!std::filesystem::exists(flags.path, failed))
    return Error{"input.not_found", flags.path, "there is no such file or folder"};
  const bool is_file = std::filesystem::is_regular_file(flags.path, failed);
  MARKETGEN_TRY(CheckOutput output,
                is_file ? check_plan(flags, catalog) : check_store(flags, catalog));
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
