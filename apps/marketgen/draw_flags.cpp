#include "draw_flags.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/text.h"
#include "episodes/checkout/checkout_station.h"
#include "episodes/track_entry.h"
#include "named_flag.h"

namespace marketgen::app {
namespace {

// Of a list like "products,looks".
Result<std::vector<episodes::Unseen>> unseen_named(const std::string& list) {
  std::vector<episodes::Unseen> unseen;
  for (const std::string& name : split(list, ',')) {
    MARKETGEN_TRY(const episodes::Unseen kind,
                  value_of_flag<episodes::Unseen>("--unseen", "there is no", name));
    unseen.push_back(kind);
  }
  return unseen;
}

// What a flag says of a field that not every track has: `--doors`, `--station`.
Result<void> check_has_field(const std::string& track,
                             const std::string& field,
                             const std::string& remedy) {
  MARKETGEN_TRY(const episodes::Track named, episodes::track_named(track));
  const auto fields = episodes::entry_of(named).own_fields();
  if (std::ranges::find(fields, field) != fields.end()) return {};
  return Error{"usage.bad_flag", "--" + field, fmt::format("the track {} has {}", track, remedy)};
}

Result<episodes::Doors> doors_of(const DrawFlags& flags, const std::string& track) {
  if (!flags.doors) return episodes::Doors::none;
  MARKETGEN_CHECK(check_has_field(
      track, "doors", "no goals behind doors: leave it out, or name the track aisle"));
  return episodes::Doors::hinged;
}

// Empty for the track's own.
Result<std::string> station_of(const DrawFlags& flags, const std::string& track) {
  if (flags.station.empty()) return std::string();
  MARKETGEN_CHECK(
      check_has_field(track, "station", "no stations: leave it out, or name the track checkout"));
  MARKETGEN_TRY(
      const auto station,
      value_of_flag<episodes::UnloadingStation>("--station", "there is no station", flags.station));
  return station == episodes::UnloadingStation::eased ? std::string() : flags.station;
}

}  // namespace

Result<episodes::DrawRules> draw_rules_of(const DrawFlags& flags,
                                          const std::string& track,
                                          const std::filesystem::path& data) {
  episodes::DrawRules rules;
  MARKETGEN_TRY(rules.difficulty, episodes::load_difficulty(data, flags.difficulty));
  MARKETGEN_TRY(rules.doors, doors_of(flags, track));
  MARKETGEN_TRY(rules.station, station_of(flags, track));
  MARKETGEN_TRY(rules.split,
                value_of_flag<episodes::Split>("--split", "there is no split", flags.split));
  MARKETGEN_TRY(rules.instructions,
                value_of_flag<episodes::Instructions>(
                    "--instructions", "there are no instructions in", flags.instructions));
  MARKETGEN_TRY(std::vector<episodes::Unseen> unseen, unseen_named(flags.unseen));
  const std::vector<std::filesystem::path> files(flags.trained_on.begin(), flags.trained_on.end());
  MARKETGEN_TRY(rules.trained_on, episodes::TrainingSet::read(files, std::move(unseen)));
  return rules;
}

void add_draw_flags(CLI::App& command, DrawFlags& flags) {
  command
      .add_option(
          "--split",
          flags.split,
          "what every episode is shown to be: planned (a way through it), certified (done "
          "in physics, in ten perturbed worlds, too: minutes an episode), paper (a way to the "
          "place, front row), all (nothing)")
      ->type_name(choice_of(names_of(episodes::Split{})))
      ->capture_default_str();
  command
      .add_option("--instructions",
                  flags.instructions,
                  "how goals are told: words (a text that fits one product on offer) or ids (SKUs, "
                  "too)")
      ->type_name(choice_of(names_of(episodes::Instructions{})))
      ->capture_default_str();
  command
      .add_option("--difficulty",
                  flags.difficulty,
                  "how much is asked for, how full baskets are, how much is alike, on which boards "
                  "goals stand, how far they are apart: easy, standard, hard, or a JSON file of "
                  "your own")
      ->type_name("DIFFICULTY")
      ->capture_default_str();
  command.add_flag("--doors",
                   flags.doors,
                   "aisle: goals stand behind cooler and freezer doors, which the robot opens and "
                   "shuts again; without it, behind none");
  command
      .add_option(
          "--station",
          flags.station,
          "checkout: what the robot works with: checkout (by itself) has longer fingers and "
          "a basket with a ledge, checkout-stock the fingers that a Franka Hand comes with "
          "and a plain basket")
      ->type_name(choice_of(names_of(episodes::UnloadingStation{})));
  CLI::Option* trained_on =
      command
          .add_option("--trained-on",
                      flags.trained_on,
                      "a file of episodes that a policy was trained on: what is drawn it has not "
                      "seen; may be given again")
          ->type_name("EPISODES")
          ->allow_extra_args(false);
  command
      .add_option("--unseen",
                  flags.unseen,
                  "with --trained-on, what is to be new, with commas: products (no goal is one of "
                  "those files' products, or easily taken for one), layouts and looks (a store "
                  "with one of theirs is refused)")
      ->type_name("TEXT")
      ->needs(trained_on)
      ->capture_default_str();
}

}  // namespace marketgen::app
