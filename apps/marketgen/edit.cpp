// marketgen edit: a store, changed by patches or words, as a new store folder.
#include <algorithm>

#include <fmt/format.h>

#include "base/parallel.h"
#include "base/text.h"
#include "command.h"
#include "intake/conflicts.h"
#include "io/file.h"
#include "io/json.h"
#include "say.h"
#include "say_unparsed.h"
#include "store/edit.h"
#include "store/edit_words.h"

namespace marketgen::app {
namespace {

struct EditFlags {
  CommonFlags common;
  std::string store, patch_file, words, planogram_file, folder;
  bool dry_run = false, strict = false, no_previews = false;
};

// What --json prints.
struct EditOutput {
  std::string folder;
  std::vector<plan::Patch> patches;
  store::SceneChanges changes;
  std::vector<std::string> lost, so_already;
  std::vector<intake::UnparsedWord> unparsed;
  store::StoreReport report;
  static constexpr auto fields = field_list(
      field("folder", &EditOutput::folder, "the new store folder; empty when there is none"),
      field("patches", &EditOutput::patches, "what was done"),
      field("changes", &EditOutput::changes, "what differs"),
      field("lost", &EditOutput::lost, "wishes of the prompt that are no longer met"),
      field("so_already", &EditOutput::so_already, "wishes that the store met as it was"),
      field("unparsed", &EditOutput::unparsed, "words not understood"),
      field("report", &EditOutput::report, "report.json"));
};

Result<store::SaidPatches> patches_of_planogram(const EditFlags& flags,
                                                const store::Store& store,
                                                const catalog::Catalog& catalog) {
  MARKETGEN_TRY(const scene::PlanogramFile planogram,
                planogram_for(flags.planogram_file, store, catalog));
  scene::PlanogramChanges changes = scene::changes_by(planogram, store.scene, store.plan, catalog);
  store::SaidPatches said;
  said.patches = std::move(changes.patches);
  if (changes.as_they_were > 0)
    said.so_already.push_back(fmt::format("{} of {} shelves of {}",
                                          changes.as_they_were,
                                          planogram.shelves.size(),
                                          flags.planogram_file));
  return said;
}

Result<store::SaidPatches> patches_of(const EditFlags& flags,
                                      const store::Store& store,
                                      const catalog::Catalog& catalog) {
  if (!flags.words.empty()) return store::patches_of_words(store, flags.words, catalog);
  if (!flags.planogram_file.empty()) return patches_of_planogram(flags, store, catalog);
  constexpr std::uint64_t max_bytes = 4U << 20;
  MARKETGEN_TRY(const std::string text, io::read_file(flags.patch_file, max_bytes));
  store::SaidPatches said;
  MARKETGEN_TRY(said.patches, plan::read_patches(text, flags.patch_file));
  return said;
}

std::string words_of(const store::ChangeCount& count) {
  const auto number = [](std::uint64_t n) { return with_thousands(static_cast<std::int64_t>(n)); };
  return fmt::format("{} kept, {} moved, {} new, {} gone",
                     number(count.kept),
                     number(count.moved),
                     number(count.added),
                     number(count.gone));
}

void print_summary(const EditOutput& output) {
  for (const plan::Patch& patch : output.patches) {
    if (patch.stock_shelves)  // as long as a planogram is
      say("restocked   {} shelves\n", patch.stock_shelves->shelves.size());
    else
      say("patch       {}\n", io::write_json_line(patch));
  }
  for (const std::string& wish : output.so_already)
    say("so already  \"{}\"\n", wish);
  if (output.folder.empty()) {
    say_unparsed(output.unparsed);
    return;
  }
  say("store       {}\n", output.folder);
  say("changes     zones {}; fixtures {}; products {}\n",
      words_of(output.changes.zones),
      words_of(output.changes.fixtures),
      words_of(output.changes.products));
  std::size_t met = 0;
  for (const audit::RequirementResult& r : output.report.requirements)
    met += r.met ? 1 : 0;
  say("wishes      {} of {} of the prompt met\n", met, output.report.requirements.size());
  for (const std::string& wish : output.lost)
    say("  no longer \"{}\"\n", wish);
  say_unparsed(output.unparsed);
  for (const layout::Violation& v : output.report.rules)
    say("  {:<9} {} {}: {}\n", name_of(v.severity), v.code, v.where, v.message);
}

Result<void> check_flags(const EditFlags& flags) {
  const int given = (flags.words.empty() ? 0 : 1) + (flags.patch_file.empty() ? 0 : 1) +
                    (flags.planogram_file.empty() ? 0 : 1);
  if (given == 1) return {};
  return Error{"usage.bad_flag",
               given == 0                 ? "--say"
               : flags.patch_file.empty() ? "--planogram"
                                          : "--patch",
               "give either words, --say \"swap dairy and bakery\", or a market-patch/1 file, "
               "--patch F, or a planogram, --planogram F"};
}

std::string source_of(const EditFlags& flags) {
  if (!flags.planogram_file.empty()) return flags.planogram_file;
  return flags.patch_file.empty() ? "--say" : flags.patch_file;
}

// Words that contradict themselves: what holds, and what does not.
bool warn_of_contradictions(const store::SaidPatches& said) {
  for (const intake::Conflict& conflict : said.conflicts)
    fmt::print(stderr,
               "given up: \"{}\" for \"{}\": {}\n",
               shown(conflict.dropped),
               shown(conflict.kept),
               shown(conflict.why));
  return std::ranges::any_of(said.conflicts, intake::is_contradiction);
}

Result<int> edit(const EditFlags& flags) {
  const ThreadLimit limit(flags.common.threads);
  MARKETGEN_CHECK(check_flags(flags));
  MARKETGEN_TRY(const catalog::Catalog catalog, load_rows_of_store(flags.store));
  MARKETGEN_TRY(const store::Store store, store::open_store(flags.store, catalog));
  MARKETGEN_TRY(store::SaidPatches said, patches_of(flags, store, catalog));
  const bool contradicts = warn_of_contradictions(said);
  const int status = flags.strict && (contradicts || !said.unparsed.empty()) ? 1 : 0;
  if (flags.dry_run) {
    MARKETGEN_TRY(const store::Replanned then,
                  store::replan(store, said.patches, source_of(flags), catalog));
    if (!then.offences.empty()) return store::error_of(then.offences.front());
    fmt::print("{}", io::write_json(said.patches));
    for (const std::string& wish : said.so_already)
      fmt::print(stderr, "so already: \"{}\"\n", shown(wish));
    for (const intake::UnparsedWord& word : said.unparsed)
      fmt::print(stderr, "not understood: \"{}\"\n", shown(word.text));
    return status;
  }
  EditOutput output;
  output.patches = said.patches.patches;
  output.so_already = said.so_already;
  output.unparsed = said.unparsed;
  if (!said.patches.patches.empty() && status == 0) {
    store::EditOptions options;
    options.folder = flags.folder.empty() ? store::next_edit_folder(flags.store)
                                          : std::filesystem::path(flags.folder);
    options.step.patches = std::move(said.patches);
    options.step.source = source_of(flags);
    options.step.words = flags.words;
    options.previews = !flags.no_previews;
    MARKETGEN_TRY(store::Edited edited,
                  store::edit_store(store, options, catalog, progress_for(flags.common)));
    output.folder = options.folder.string();
    output.changes = edited.changes;
    output.lost = std::move(edited.lost);
    output.report = std::move(edited.created.report);
  }
  if (flags.common.json)
    fmt::print("{}\n", io::write_json_line(output));
  else
    print_summary(output);
  return status;
}

}  // namespace

Run add_edit(CLI::App& app) {
  auto flags = std::make_shared<EditFlags>();
  CLI::App* command =
      app.add_subcommand("edit", "Change a store: a new folder, in which the rest is as it was");
  command->add_option("store", flags->store, "store folder; it is not written")
      ->type_name("STORE")
      ->required();
  command->add_option("--say", flags->words, "what shall change, in words")->type_name("WORDS");
  command->add_option("--patch", flags->patch_file, "what shall change, as a market-patch/1 file")
      ->type_name("FILE");
  command
      ->add_option("--planogram",
                   flags->planogram_file,
                   "what shall stand on its shelves, as a CSV file like that of export --format "
                   "planogram")
      ->type_name("FILE");
  add_output(*command,
             "-o,--output",
             flags->folder,
             "folder to make; left out: STORE-edit-1, or the next number that is free");
  command->add_flag("--dry-run", flags->dry_run, "write nothing, print the patches as JSON");
  command->add_flag(
      "--strict",
      flags->strict,
      "write nothing when a word was not understood or the words contradict themselves");
  command->add_flag("--no-previews", flags->no_previews, "draw no pictures");
  add_common_flags(*command, flags->common, Takes::json);
  command->footer(
      "Exit status 1 when a hard rule would be broken, or with --strict when a word was not "
      "understood.\nExample:  marketgen edit shop --say \"swap dairy and bakery, add two "
      "self-checkouts\"");
  return [flags] {
    const auto status = edit(*flags);
    return status.ok() ? *status : fail(status.error());
  };
}

}  // namespace marketgen::app
