// marketgen episodes: draws tasks from stores and writes them as JSON Lines.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <map>

#include "base/build_info.h"
#include "base/hash.h"
#include "base/interrupt.h"
#include "base/parallel.h"
#include "base/text.h"
#include "command.h"
#include "draw_flags.h"
#include "environments/environment_entry.h"
#include "environments/travelling_stores.h"
#include "episodes/episode_journal.h"
#include "episodes/frozen_store.h"
#include "episodes/track_entry.h"
#include "freeze_stores.h"
#include "io/file.h"
#include "io/gzip.h"
#include "io/json.h"
#include "io/output.h"
#include "named_flag.h"
#include "number_flags.h"
#include "say.h"

namespace marketgen::app {
namespace {

struct EpisodesFlags {
  CommonFlags common;
  std::vector<std::string> folders;
  std::string track = "checkout", tools, output;
  DrawFlags draw;
  int count = 10;
  bool resume = false, frozen = false, skip_impossible = false;
};

struct StockedStore {
  episodes::EpisodeStore store;
  std::unique_ptr<environments::StoreSampler> sampler;
};

Result<std::vector<StockedStore>> stocked_stores(
    const std::vector<std::shared_ptr<const store::Store>>& opened,
    const episodes::TrainingSet& trained_on,
    environments::EpisodeSampler& sampler,
    environments::Arena& arena) {
  std::vector<StockedStore> stores;
  for (const auto& store : opened) {
    StockedStore made{environments::store_row(*store), nullptr};
    arena.offer(store);
    const episodes::EpisodeStore& row = made.store;
    MARKETGEN_CHECK(trained_on.check_store(row));
    MARKETGEN_TRY(made.sampler, sampler.of_store({row.name, row.scene_hash, row.plan_hash}));
    stores.push_back(std::move(made));
  }
  return stores;
}

std::vector<catalog::Product> rows_of(const std::map<std::string, catalog::Product>& by_sku) {
  std::vector<catalog::Product> rows;
  for (const auto& [sku, product] : by_sku)
    rows.push_back(product);
  return rows;
}

// The rows of what lies in the baskets and of what is asked for, by SKU.
std::vector<catalog::Product> products_of(const std::vector<episodes::EpisodeSpec>& episodes,
                                          const std::vector<StockedStore>& stores) {
  std::map<std::string, catalog::Product> products;
  const auto add = [&](const std::string& sku) {
    for (const StockedStore& store : stores) {
      const std::vector<catalog::Product>& rows = store.sampler->products();
      const auto row = std::ranges::find(rows, sku, &catalog::Product::sku);
      if (row != rows.end()) products.emplace(sku, *row);
    }
  };
  for (const episodes::EpisodeSpec& spec : episodes)
    for (const std::string& sku : episodes::skus_of(spec))
      add(sku);
  return rows_of(products);
}

// Of all that the stores sell, by SKU: in physics, episodes are tried while they are drawn.
std::vector<catalog::Product> products_of(const std::vector<StockedStore>& stores) {
  std::map<std::string, catalog::Product> products;
  for (const StockedStore& store : stores)
    for (const catalog::Product& row : store.sampler->products())
      products.emplace(row.sku, row);
  return rows_of(products);
}

// What decides the episodes, beside their number.
std::string draw_hash(const EpisodesFlags& flags,
                      const episodes::DrawRules& rules,
                      const std::vector<StockedStore>& stores,
                      const catalog::Catalog& catalog) {
  Hasher hasher;
  hasher.add(program_version).add(catalog.content_hash).add(flags.track).add(flags.tools);
  hasher.add(flags.draw.split).add(flags.draw.instructions);
  if (flags.draw.doors) hasher.add("doors");
  if (!flags.draw.station.empty()) hasher.add("station").add(flags.draw.station);
  if (!rules.difficulty.is_standard()) hasher.add(io::write_json(rules.difficulty));
  if (const auto unseen = rules.trained_on.row()) hasher.add(io::write_json(*unseen));
  hasher.add(std::to_string(flags.common.seed));
  for (const StockedStore& from : stores)
    hasher.add(from.store.scene_hash).add(from.store.plan_hash);
  return hasher.hex();
}

// Beside the output, as long as not all are drawn; none when the output is a device or pipe.
Result<std::unique_ptr<episodes::EpisodeJournal>> begin_journal(const EpisodesFlags& flags,
                                                                const std::string& draw) {
  MARKETGEN_TRY(const auto file, io::LineJournal::place_beside(flags.output));
  if (!file) return std::unique_ptr<episodes::EpisodeJournal>();
  return episodes::EpisodeJournal::begin(*file, draw, flags.resume);
}

// Draws one after the other, shared out over the stores in turn.
class Drawing {
 public:
  Drawing(const EpisodesFlags& flags,
          const std::vector<StockedStore>& stores,
          episodes::EpisodeJournal* journal)
      : flags_(flags), stores_(stores), journal_(journal) {}

  // With --skip-impossible without those that its store has none of.
  Result<std::vector<episodes::EpisodeSpec>> draw() {
    Progress& progress = progress_for(flags_.common);
    const auto count = static_cast<std::size_t>(flags_.count);
    progress.begin("episodes", count);
    const auto made = parallel_map(count, [&](std::size_t i) {
      auto spec = episode(i);
      progress.advance();
      return std::make_shared<Result<episodes::EpisodeSpec>>(std::move(spec));
    });
    progress.end();
    std::vector<episodes::EpisodeSpec> episodes;
    for (const auto& spec : made) {
      if (spec->ok())
        episodes.push_back(spec->value());
      else if (!leave_out(spec->error()))
        return spec->error();
    }
    if (episodes.empty()) return made.front()->error();
    return episodes;
  }

 private:
  // The number `i` of the file: kept before, or drawn now and kept.
  Result<episodes::EpisodeSpec> episode(std::size_t i) {
    const StockedStore& from = stores_[i % stores_.size()];
    const int number = static_cast<int>(i);
    if (journal_ == nullptr) return drawn(from, i);
    if (const auto before = journal_->before().find(number); before != journal_->before().end()) {
      from.sampler->consider(before->second.considered);
      return before->second.episode;
    }
    MARKETGEN_TRY(episodes::EpisodeSpec spec, drawn(from, i));
    MARKETGEN_CHECK(journal_->keep({number, spec, from.sampler->considered()}));
    return spec;
  }

  bool leave_out(const Error& why) const {
    if (!flags_.skip_impossible || why.code != "episode.impossible") return false;
    if (!flags_.common.quiet) say("left out: {}: {}\n", why.where, why.message);
    return true;
  }

  Result<episodes::EpisodeSpec> drawn(const StockedStore& from, std::size_t i) const {
    const Seed seed = Seed(flags_.common.seed).child("store", from.store.scene_hash);
    return from.sampler->sample(seed, static_cast<int>(i / stores_.size()));
  }

  const EpisodesFlags& flags_;
  const std::vector<StockedStore>& stores_;
  episodes::EpisodeJournal* journal_;
};

// The episodes, or why there are none: what was drawn and studied until then is kept.
Result<std::vector<episodes::EpisodeSpec>> draw(const EpisodesFlags& flags,
                                                const std::vector<StockedStore>& stores,
                                                environments::EpisodeSampler& sampler,
                                                episodes::EpisodeJournal* journal) {
  auto episodes = until_interrupted([&] { return Drawing(flags, stores, journal).draw(); });
  const NoForcedEnd keeping;
  MARKETGEN_CHECK(sampler.keep());
  if (episodes.ok() || journal == nullptr) return episodes;
  if (episodes.error().code != interrupted_error().code) {
    journal->lines().remove();  // it would end so again
    return episodes;
  }
  return io::interrupted_with(
      journal->lines(), flags.output, static_cast<std::size_t>(flags.count), "episodes");
}

void print_exclusions(const episodes::EpisodeStore& store) {
  int left_out = 0;
  std::string reasons;
  for (const auto& [reason, products] : store.exclusions.left_out) {
    left_out += products;
    reasons += fmt::format("{}{} {}", reasons.empty() ? "" : ", ", reason, products);
  }
  if (store.exclusions.on_offer > 0)
    say("{}: {} of {} products {} are never asked for ({})\n",
        store.name,
        left_out,
        store.exclusions.on_offer,
        store.exclusions.lanes ? "on its shelves" : "that were looked at",
        reasons);
  if (!store.exclusions.lanes) return;
  for (const auto& [lane, reason] : *store.exclusions.lanes)
    say("{}: no episode is at {}: {}\n", store.name, lane, reason);
}

// Those of checkout that are not at a lane of theirs, and why (print_exclusions says it of lanes).
void print_rooms(const episodes::EpisodeFile& file) {
  const auto in_room = std::ranges::count_if(file.episodes, [](const episodes::EpisodeSpec& spec) {
    return spec.track == episodes::Track::checkout && !spec.lane;
  });
  if (in_room > 0)
    say("{} episodes are in a room of their own: their store has no checkout lane with room for "
        "the robot\n",
        in_room);
}

// How many candidates were drawn for the episodes, and why others were not kept.
void print_shares(const episodes::DrawShares& shares) {
  if (shares.drawn == 0) return;
  std::string reasons;
  for (const episodes::DrawRefusal& refusal : shares.refused)
    reasons += fmt::format(
        "{}{} {}", reasons.empty() ? " (not kept: " : ", ", refusal.reason, refusal.drawn);
  say("{} of {} that were drawn were kept{}{}\n",
      shares.kept,
      shares.drawn,
      reasons,
      reasons.empty() ? "" : ")");
  const int tried = shares.planned_tried + shares.other_tried;
  if (tried == 0) return;
  say("in physics: {} of {} with a planned way through were done, {} of {} without\n",
      shares.planned_held,
      shares.planned_tried,
      shares.other_held,
      shares.other_tried);
  for (const episodes::ProvedBy& by : shares.proved_by)
    say("  {} by {}\n", by.episodes, by.by);
}

void finish_header(const EpisodesFlags& flags,
                   const episodes::DrawRules& rules,
                   std::vector<StockedStore>& stores,
                   episodes::EpisodeFile& file) {
  file.header.seed = flags.common.seed;
  file.header.episodes = static_cast<int>(file.episodes.size());
  file.header.split = rules.split;
  file.header.unseen = rules.trained_on.row();
  file.header.drawn = episodes::draw_shares(file.episodes);
  file.header.products = products_of(file.episodes, stores);
  for (StockedStore& store : stores) {
    store.store.exclusions = store.sampler->exclusions();
    file.header.stores.push_back(store.store);
  }
}

void print_drawn(const episodes::EpisodeFile& file) {
  for (const episodes::EpisodeStore& store : file.header.stores)
    print_exclusions(store);
  print_rooms(file);
  print_shares(*file.header.drawn);
}

std::filesystem::path scenes_folder(const EpisodesFlags& flags) {
  return std::filesystem::path(flags.output).parent_path() / episodes::scenes_folder;
}

// What will be written, before any work.
Result<void> add_outputs(const EpisodesFlags& flags, io::Outputs& outputs) {
  MARKETGEN_CHECK(outputs.add({{"--output", flags.output}}));
  if (!flags.frozen) return {};
  MARKETGEN_TRY(const auto file, io::LineJournal::place_beside(flags.output));
  if (!file)
    return Error{"usage.bad_flag",
                 "--frozen",
                 "writes the stores' scenes beside the episodes: name a file with --output"};
  return outputs.add_folder(scenes_folder(flags));
}

// Goods of a user's own have meshes and pictures, which do not travel with a scene.
Result<void> check_can_freeze(const EpisodesFlags& flags,
                              const std::vector<std::shared_ptr<const store::Store>>& stores) {
  if (!flags.frozen) return {};
  for (const auto& store : stores)
    if (store->manifest.own)
      return Error{"usage.bad_flag",
                   "--frozen",
                   fmt::format("{} has goods of your own, which cannot be frozen yet: leave "
                               "--frozen out, or draw from stores without them",
                               store->manifest.name)};
  return {};
}

// A frozen store's plan may give another store by now.
Result<void> check_stays_frozen(const EpisodesFlags& flags,
                                const environments::NamedStores& named) {
  if (flags.frozen || named.frozen.empty()) return {};
  return Error{"usage.bad_flag",
               "--frozen",
               fmt::format("the stores of {} are frozen, and so are episodes that are drawn from "
                           "them: add --frozen",
                           named.frozen)};
}

Result<void> write(const EpisodesFlags& flags) {
  const ThreadLimit limit(flags.common.threads);
  io::Outputs outputs;
  MARKETGEN_CHECK(add_outputs(flags, outputs));
  MARKETGEN_TRY(const std::filesystem::path data, io::data_folder());
  MARKETGEN_TRY(const episodes::Track track, episodes::track_named(flags.track));
  MARKETGEN_TRY(const episodes::DrawRules rules, draw_rules_of(flags.draw, flags.track, data));
  MARKETGEN_TRY(catalog::Catalog rows, load_rows());
  MARKETGEN_TRY(const environments::NamedStores named,
                environments::open_named_stores(flags.folders, std::move(rows)));
  const store::OpenedStores& opened = named.opened;
  MARKETGEN_CHECK(check_can_freeze(flags, opened.stores));
  MARKETGEN_CHECK(check_stays_frozen(flags, named));
  const catalog::Catalog& catalog = opened.catalog;
  episodes::EpisodeFile file;
  environments::Arena arena(data, file.header, catalog);
  MARKETGEN_TRY(const auto sampler,
                environments::environment_entry_of(track).sampler(arena, flags.tools, rules));
  MARKETGEN_TRY(std::vector<StockedStore> stores,
                stocked_stores(opened.stores, rules.trained_on, *sampler, arena));
  if (rules.split == episodes::Split::certified) file.header.products = products_of(stores);
  MARKETGEN_TRY(const std::unique_ptr<episodes::EpisodeJournal> journal,
                begin_journal(flags, draw_hash(flags, rules, stores, catalog)));
  const std::size_t before = journal ? journal->before().size() : 0;
  const auto began = std::chrono::steady_clock::now();
  MARKETGEN_TRY(file.episodes, draw(flags, stores, *sampler, journal.get()));
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - began;
  finish_header(flags, rules, stores, file);
  if (flags.frozen) MARKETGEN_CHECK(freeze_stores(data, named, arena, flags.output, outputs, file));
  const std::string text = episodes::write_episodes(file);
  const bool packed = flags.output.ends_with(".gz");
  MARKETGEN_CHECK(outputs.put(flags.output, packed ? io::gzip(text) : text));
  MARKETGEN_CHECK(outputs.commit());
  if (journal) journal->lines().remove();
  if (flags.common.quiet) return {};
  print_drawn(file);
  if (file.episodes.size() > before)
    say("{:.1f} s an episode\n", took.count() / static_cast<double>(file.episodes.size() - before));
  say("{} episodes of {} stores: {}\n", file.episodes.size(), stores.size(), flags.output);
  return {};
}

}  // namespace

Run add_episodes(CLI::App& app) {
  auto flags = std::make_shared<EpisodesFlags>();
  CLI::App* command = app.add_subcommand("episodes", "Draw tasks for robots from stores");
  command
      ->add_option("folders",
                   flags->folders,
                   "store folders; of a file or set of episodes (v1/checkout) all its stores")
      ->type_name("STORE")
      ->required();
  command->add_option("--track", flags->track, "what kind of task")
      ->type_name(choice_of(names_of(episodes::Track{})))
      ->capture_default_str();
  command->add_option("--tools", flags->tools, "what the robot takes goods with; gripper by itself")
      ->type_name("{gripper,suction}");
  add_draw_flags(*command, flags->draw);
  command->add_option("--count", flags->count, "episodes, shared out over the stores")
      ->check(whole_number(1, 100000))
      ->capture_default_str();
  add_output(*command,
             "-o,--output",
             flags->output,
             "JSON Lines file; packed with gzip when it ends with .gz")
      ->required();
  command->add_flag("--frozen",
                    flags->frozen,
                    "also write the stores' scenes, to the folder scenes beside the output: later "
                    "versions of marketgen then run the episodes in the same stores");
  command->add_flag("--skip-impossible",
                    flags->skip_impossible,
                    "an episode that its store has none of, in as many tries as are made, is left "
                    "out and said; without it, no file is written then");
  command->add_flag("--resume", flags->resume, "go on with a draw that was broken off");
  add_common_flags(*command, flags->common, Takes::seed);
  command->footer("Example:  marketgen episodes shop --track checkout --count 20 -o tasks.jsonl");
  return [flags] {
    const auto done = write(*flags);
    return done.ok() ? 0 : fail(done.error());
  };
}

}  // namespace marketgen::app
