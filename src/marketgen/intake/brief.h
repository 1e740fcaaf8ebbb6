// Intake: what a person wants, in words (and later drawings and photos), made into a plan.
//
// A planner is a plug-in: the offline one here, language models in `planners`. All see the same
// Brief and answer with the same Planned.
#pragma once
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "base/fields.h"
#include "base/result.h"
#include "base/seed.h"
#include "catalog/catalog.h"
#include "intake/drawn_zones.h"
#include "photo/read_photo.h"
#include "plan/plan.h"
#include "plan/requirement.h"

namespace marketgen::intake {

// Everything that was asked for. Flags beat text.
struct Brief {
  std::string prompt;                           // UTF-8, at most 20,000 bytes
  std::vector<std::string> image_files;         // --image: one drawing of zones at most, and photos
  std::optional<std::array<int, 2>> size_mm;    // --size
  std::optional<std::string> profile;           // --profile
  std::optional<std::string> style;             // --style
  std::optional<std::string> country;           // --country
  std::optional<std::string> time;              // --time (plan/store_time.h)
  std::optional<plan::Vary> vary;               // --vary
  std::string planner = "offline";              // --planner
  std::optional<std::string> skin;              // --skin: the style whose look the store gets
  std::optional<std::string> floor_plan;        // --floor-plan: SVG, DXF, PNG or JPEG
  std::optional<std::string> floor_plan_scale;  // --floor-plan-scale
  std::optional<plan::Shell> shell;             // read from it (intake/drawn_shell.h); not saved
  double shell_confidence = 1;
  std::optional<DrawnZones> zones;  // read from the pictures (intake/drawn_shell.h); not saved
  std::vector<photo::PhotoReading> photos;  // read from them, too; not saved
  // Of the same photos, as a language model read them (intake/settled_look.h); not saved.
  std::vector<photo::PhotoReading> seen;

  static constexpr auto fields =
      field_list(field("prompt", &Brief::prompt, "the words", at_most_bytes(20000)),
                 field("image_files", &Brief::image_files, "drawings and photos"),
                 field("size_mm", &Brief::size_mm, "size given by a flag", range(0, 1e6)),
                 field("profile", &Brief::profile, "profile given by a flag"),
                 field("style", &Brief::style, "style given by a flag"),
                 field("country", &Brief::country, "country given by a flag"),
                 field("time", &Brief::time, "weekday and hour given by a flag"),
                 field("vary", &Brief::vary, "seeds of single axes given by a flag"),
                 field("planner", &Brief::planner, "who plans"),
                 field("skin", &Brief::skin, "style that sets materials, colours and light only"),
                 field("floor_plan", &Brief::floor_plan, "drawing of the shell"),
                 field("floor_plan_scale", &Brief::floor_plan_scale, "scale given by a flag"));
};

struct UnparsedWord {
  std::string text;
  IntRange span{0, 0};

  static constexpr auto fields =
      field_list(field("text", &UnparsedWord::text, "words that were not understood"),
                 field("span", &UnparsedWord::span, "bytes of the prompt"));
};

// Two wishes that cannot both hold, and which one won.
struct Conflict {
  std::string what, kept, dropped, why;
  // Of two pieces of the prompt: their clauses, in bytes, what was kept first. Else empty.
  std::vector<IntRange> where = {};

  static constexpr auto fields =
      field_list(field("what", &Conflict::what, "value in question"),
                 field("kept", &Conflict::kept, "what holds"),
                 field("dropped", &Conflict::dropped, "what was given up"),
                 field("why", &Conflict::why, "reason"),
                 field("where",
                       &Conflict::where,
                       "of a prompt that contradicts itself: the clauses of what holds and of what "
                       "was given up, in bytes"));
};

// How a language model planned, for the report.
struct PlannerRecord {
  std::string planner, kept, why;
  int requests = 0;
  std::int64_t tokens_in = 0, tokens_out = 0;
  double seconds = 0;
  std::optional<double> usd;
  std::vector<std::string> warnings;

  static constexpr auto fields =
      field_list(field("planner", &PlannerRecord::planner, "which language model"),
                 field("kept", &PlannerRecord::kept, "whose plan the store has"),
                 field("why", &PlannerRecord::why, "why"),
                 field("requests", &PlannerRecord::requests, "questions to the model"),
                 field("tokens_in", &PlannerRecord::tokens_in, "tokens that it read"),
                 field("tokens_out", &PlannerRecord::tokens_out, "tokens that it wrote"),
                 field("seconds", &PlannerRecord::seconds, "wall time of its work"),
                 field("usd", &PlannerRecord::usd, "US dollars; absent without prices"),
                 field("warnings",
                       &PlannerRecord::warnings,
                       "pictures that it did not see, and what it read of them otherwise than the "
                       "bank of renderings"));
};

// A file that a planner leaves in the store's folder.
struct PlannerFile {
  std::string path, bytes;  // "agents/trace.json"
};

struct Planned {
  plan::Plan plan;
  std::vector<plan::Requirement> requirements;
  std::vector<UnparsedWord> unparsed;
  std::vector<Conflict> conflicts;
  bool understood = true;               // false: not one word of the prompt said anything
  bool floor_is_open = false;           // nobody said how large the floor is
  std::optional<DrawnZones> drawn;      // what the brief's drawing has
  std::vector<std::string> trace;       // what the planner decided, for a person
  std::optional<PlannerRecord> record;  // of a language model
  // What it read of the photos: the brief has it (Brief::seen) when it is planned again.
  std::vector<photo::PhotoReading> seen;
  std::vector<PlannerFile> files;
};

// What a planner no longer insists on, because the store that it planned broke a hard rule.
struct Concessions {
  std::size_t max_zones = 1000;     // the least important ones are left out first
  bool till_counter = false;        // a counter instead of lanes
  bool relations_may_fail = false;  // every relation is only preferred
  bool plain = false;               // nothing but a till and ordinary shelves
  int growth = 0;                   // how often a floor of no said size was made larger
  int draw = 0;                     // which of the floors that the seed can give
  int plans_before = 0;             // of the same brief: each plan may take half the work
  // Of a zone's own fixtures, by its type; of those beside them, by "type/kind"; of runs, with
  // "/runs" behind that; of equipment at the doors, by its kind.
  std::map<std::string, int> max_count;
  std::set<std::string> without;  // ids of zones that found no floor; tills stay

  friend bool operator==(const Concessions&, const Concessions&) = default;
};

// Turns a brief into a plan. Implementations must be deterministic for a given seed.
class Planner {
 public:
  virtual ~Planner() = default;
  virtual Result<Planned> plan(const Brief& brief,
                               const catalog::Catalog& catalog,
                               Seed seed,
                               const Concessions& concessions) const = 0;
};

// The one that needs no network. Planners on language models: planners/make_planner.h.
// Errors: of Language::load.
Result<std::unique_ptr<Planner>> offline_planner();

// Checks the brief (empty, too long, not UTF-8, bad size, unknown profile or style), runs the
// planner and validates its plan.
Result<Planned> plan_from_brief(const Brief& brief,
                                const catalog::Catalog& catalog,
                                const Planner& planner,
                                Seed seed,
                                const Concessions& concessions = {});

// "24x15m", "24 x 15 m", "40m x 25m", "80x50ft" -> millimetres [width, depth]. Error:
// brief.bad_size.
Result<std::array<int, 2>> parse_size(std::string_view text, const std::string& where);

}  // namespace marketgen::intake
