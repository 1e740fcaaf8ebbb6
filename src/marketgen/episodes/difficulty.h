// How hard the tasks of a file are drawn: how much is asked for, how full a basket is, how much of
// it is alike, on which boards goals stand, how far they are apart. A realism (episodes/realism.h)
// is of a run; a difficulty is of the task itself, and an episode says which it was drawn with.
//
// Three are rows, data/benchmark/difficulty/NAME.json: `easy`, `standard`, which is what is drawn
// by itself, and `hard`.
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/fields.h"
#include "base/result.h"
#include "base/seed.h"

namespace marketgen::episodes {

// What a learner's observation has room for.
inline constexpr int max_goal_kinds = 4, max_other_goods = 8;

// Drawn evenly, both included.
struct DrawnCount {
  int min = 0, max = 0;
  static constexpr auto fields = field_list(
      field("min", &DrawnCount::min, "at least", required(), range(0, max_other_goods)),
      field("max", &DrawnCount::max, "at most, no less", required(), range(0, max_other_goods)));
};

struct LevelBand {
  double low_m = 0, high_m = 0;
  static constexpr auto fields = field_list(
      field("low_m", &LevelBand::low_m, "metres above the floor", required(), range(0, 3)),
      field("high_m", &LevelBand::high_m, "no less", required(), range(0, 3)));
};

struct Difficulty {
  std::string schema = "market-difficulty/1";
  std::string name = "standard";
  DrawnCount goals{2, max_goal_kinds}, others{4, max_other_goods};
  double two_of_one = 0.25, look_alikes = 0.5;
  std::vector<LevelBand> levels;
  double way = 0;

  // Whether goals may stand on boards of that height.
  bool has_level(double height_m) const;

  // Of tasks of it: in their ids, behind their kind; what they draw from; what they say of it.
  // Standard ones are drawn and called as if there were no other.
  bool is_standard() const { return name == "standard"; }
  std::string kind_of(const std::string& kind) const;
  Seed seed_of(Seed own) const { return is_standard() ? own : own.child("difficulty " + name); }
  std::optional<std::string> told() const;

  static constexpr auto fields = field_list(
      field("schema", &Difficulty::schema, "schema tag", constant("market-difficulty/1")),
      field("name",
            &Difficulty::name,
            "of a row: its file's; episodes name a file of one's own by the hash of its dials",
            identifier()),
      field("goals",
            &Difficulty::goals,
            "kinds of goods that are asked for, 1 to 4; fewer of a small stock"),
      field("others",
            &Difficulty::others,
            "checkout: kinds of goods that lie in the basket beside them, 0 to 8"),
      field("two_of_one",
            &Difficulty::two_of_one,
            "share of tasks, as they are drawn, that ask for two of one product, where two can be "
            "had",
            range(0, 1)),
      field("look_alikes",
            &Difficulty::look_alikes,
            "share of tasks, as they are drawn, in which something in the basket, or on the shelf "
            "within a metre of a goal, is easily taken for a goal, where the stock has such goods; "
            "in the rest nothing is, where it has enough others",
            range(0, 1)),
      field(
          "levels",
          &Difficulty::levels,
          "aisle: heights of the boards on which all items of a goal stand; any within reach when "
          "empty",
          at_most_items(8)),
      field("way",
            &Difficulty::way,
            "aisle: the shortest way past all goals is at least so many times the longer side of "
            "the store's floor",
            range(0, 5)));
};

// A row by its name, or a file of one's own (load_named_dials). Errors: those of it;
// catalog.bad_row for dials that contradict themselves.
Result<Difficulty> load_difficulty(const std::filesystem::path& data, const std::string& asked);

}  // namespace marketgen::episodes
