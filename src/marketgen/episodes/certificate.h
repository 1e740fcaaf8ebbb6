// What is known of an episode: that it can be done, and how that was found out.
#pragma once
#include <algorithm>
#include <array>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/fields.h"
#include "base/result.h"
#include "episodes/failure_code.h"
#include "episodes/perturbation_sizes.h"
#include "episodes/side_effects.h"

namespace marketgen::episodes {

struct EpisodeSpec;

constexpr std::string_view shown_in_physics = "physics";  // in EpisodeCertificate::proved
// Only a search that looks farther than that of Split::planned has found a way to some goal.
constexpr std::string_view shown_by_wider_search = "wider_search";
constexpr std::string_view refused_by_physics = "physics: ";  // DrawRefusal::reason begins so

// What every episode of a file was shown to be, before it was kept. planned: a way through it was
// planned. certified: it was carried out in physics, and again where things are a little other.
// paper: the paper's conditions alone, a way to the place and the front row of a shelf. all:
// nothing, they are as they were drawn.
enum class Split { planned, certified, paper, all };
constexpr std::array<std::string_view, 4> names_of(Split) {
  return {"planned", "certified", "paper", "all"};
}

// On the store's floor.
struct FloorPlaceRow {
  double x_m = 0, y_m = 0, heading_deg = 0;
  static constexpr auto fields =
      field_list(field("x_m", &FloorPlaceRow::x_m, "east", range(-1000, 1000)),
                 field("y_m", &FloorPlaceRow::y_m, "north", range(-1000, 1000)),
                 field("heading_deg", &FloorPlaceRow::heading_deg, "from east", range(-360, 360)));
};

// The door before a goal: where the robot stands to open it, and to shut it.
struct WitnessDoor {
  std::string id;  // FIXTURE/JOINT
  FloorPlaceRow opened_from, shut_from;
  static constexpr auto fields =
      field_list(field("id", &WitnessDoor::id, "fixture/joint", required()),
                 field("opened_from", &WitnessDoor::opened_from, "where the robot opens it"),
                 field("shut_from", &WitnessDoor::shut_from, "where it shuts it"));
};

// One way to fetch a goal that was found when the episode was drawn.
struct WitnessPick {
  std::string sku, product, arm, strategy;
  std::vector<int> grasps;
  FloorPlaceRow base;
  double lift_m = 0, drive_m = 0;
  std::optional<WitnessDoor> door = {};  // that is before it
  static constexpr auto fields =
      field_list(field("sku", &WitnessPick::sku, "of the goal", identifier()),
                 field("product", &WitnessPick::product, "item id"),
                 field("arm", &WitnessPick::arm, "of the robot"),
                 field("strategy", &WitnessPick::strategy, "how it takes hold"),
                 field("grasps",
                       &WitnessPick::grasps,
                       "candidates of the grasp study that held it as stocked, from 0"),
                 field("base", &WitnessPick::base, "where the robot stands"),
                 field("lift_m", &WitnessPick::lift_m, "height of its lift"),
                 field("drive_m", &WitnessPick::drive_m, "way to there from the pick before"),
                 field("door", &WitnessPick::door, "that is opened first, and shut afterwards"));
};

// What became of one run in physics.
struct RunLedger {
  int hits = 0, asked = 0;
  bool strict = false, clean = false;
  FailureCode failure = FailureCode::none;
  SideEffects side_effects;
  double simulated_s = 0;
  std::string state_hash;
  static constexpr auto fields =
      field_list(field("hits", &RunLedger::hits, "goals that count", range(0, 1e6)),
                 field("asked", &RunLedger::asked, "goals that there are", range(0, 1e6)),
                 field("strict", &RunLedger::strict, "all goals"),
                 field("clean", &RunLedger::clean, "strict, within the limits on side effects"),
                 field("failure", &RunLedger::failure, "what kept it from its goals"),
                 field("side_effects", &RunLedger::side_effects, "the ledger"),
                 field("simulated_s", &RunLedger::simulated_s, "simulated seconds", range(0, 1e6)),
                 field("state_hash", &RunLedger::state_hash, "of the physics at the end"));
};

struct FailedRuns {
  FailureCode failure = FailureCode::none;
  int runs = 0;
  static constexpr auto fields =
      field_list(field("failure", &FailedRuns::failure, "what kept it from its goals"),
                 field("runs", &FailedRuns::runs, "how many", range(1, 1e6)));
};

// What one actor made of the episode: as it is, and, when that went well, where things are a little
// other, until it was certain whether enough of these hold.
struct ProofTrial {
  std::string by;
  RunLedger nominal;
  int tried = 0, held = 0, clean = 0;
  std::vector<FailedRuns> failures;
  static constexpr auto fields =
      field_list(field("by", &ProofTrial::by, "policy", required()),
                 field("nominal", &ProofTrial::nominal, "its run of the episode as it is"),
                 field("tried", &ProofTrial::tried, "perturbed worlds", range(0, 1000)),
                 field("held", &ProofTrial::held, "of these, with all goals", range(0, 1000)),
                 field("clean", &ProofTrial::clean, "of these, clean", range(0, 1000)),
                 field("failures", &ProofTrial::failures, "of the others"));
};

// In physics. `by` is empty when no actor has shown it.
struct PhysicsProof {
  std::string by;
  int replays = 0, needed = 0;
  PerturbationSizes perturbation;
  std::vector<ProofTrial> trials;
  static constexpr auto fields = field_list(
      field("by", &PhysicsProof::by, "policy that has done it; empty: none"),
      field("replays", &PhysicsProof::replays, "perturbed worlds at most", range(0, 1000)),
      field("needed", &PhysicsProof::needed, "in which all goals are met", range(0, 1000)),
      field("perturbation", &PhysicsProof::perturbation, "how far these worlds may be off"),
      field("trials", &PhysicsProof::trials, "of each actor, in their order", at_most_items(16)));

  bool held() const { return !by.empty(); }
  double simulated_s() const;  // of the runs of the episode as it is
};
using EpisodeProver = std::function<Result<PhysicsProof>(const EpisodeSpec& spec)>;

// Episodes that were drawn and not kept.
struct DrawRefusal {
  std::string reason;
  int drawn = 0, planned = 0;
  static constexpr auto fields =
      field_list(field("reason", &DrawRefusal::reason, "why they were not kept", required()),
                 field("drawn", &DrawRefusal::drawn, "how many", range(1, 1e9)),
                 field("planned",
                       &DrawRefusal::planned,
                       "of these, with a way through them that was planned",
                       range(0, 1e9)));
};
void add_refusal(std::vector<DrawRefusal>& to, const DrawRefusal& refusal);

struct EpisodeCertificate {
  std::vector<std::string> proved;  // conditions that were shown: "settled", "physics"
  std::vector<WitnessPick> witness;
  std::optional<PhysicsProof> physics = {};
  std::optional<std::vector<DrawRefusal>> refused = {};
  static constexpr auto fields =
      field_list(field("proved", &EpisodeCertificate::proved, "conditions that were shown"),
                 field("witness", &EpisodeCertificate::witness, "picks, in their order"),
                 field("physics", &EpisodeCertificate::physics, "how it was done in physics"),
                 field("refused",
                       &EpisodeCertificate::refused,
                       "what was drawn before it in its place",
                       at_most_items(64)));
  bool has(std::string_view condition) const {
    return std::ranges::find(proved, condition) != proved.end();
  }
};

// A way through all of it was planned, by the search of Split::planned.
bool is_planned(const EpisodeCertificate& certificate);

struct ProvedBy {
  std::string by;
  int episodes = 0;
  static constexpr auto fields = field_list(field("by", &ProvedBy::by, "policy", required()),
                                            field("episodes", &ProvedBy::episodes, "how many"));
};

// Of a file: what was drawn for its episodes.
struct DrawShares {
  int drawn = 0, kept = 0;
  std::vector<DrawRefusal> refused;
  int planned_tried = 0, planned_held = 0, other_tried = 0, other_held = 0;
  std::vector<ProvedBy> proved_by;
  static constexpr auto fields = field_list(
      field("drawn", &DrawShares::drawn, "candidates", range(0, 1e9)),
      field("kept", &DrawShares::kept, "of these", range(0, 1e9)),
      field("refused", &DrawShares::refused, "the others, by reason", at_most_items(64)),
      field("planned_tried", &DrawShares::planned_tried, "in physics, with a planned way"),
      field("planned_held", &DrawShares::planned_held, "of these, done"),
      field("other_tried", &DrawShares::other_tried, "in physics, without a planned way"),
      field("other_held", &DrawShares::other_held, "of these, done"),
      field("proved_by", &DrawShares::proved_by, "who has done them", at_most_items(64)));
};

// Keeps what is drawn: tries it in physics when there is a prover, and notes why others were not
// kept. One an episode.
class CandidateJudge {
 public:
  explicit CandidateJudge(const EpisodeProver& prove) : prove_(prove) {}

  bool proves() const { return static_cast<bool>(prove_); }
  // Of a candidate that is no task, or not known to be one.
  void refuse(const std::string& reason, bool planned = false);
  // Whether it is kept: its certificate then says all. Errors: those of the prover.
  Result<bool> keep(EpisodeSpec& spec);
  std::string spoken() const;  // what was refused so far: "no_witness 3, restless 1"

 private:
  const EpisodeProver& prove_;
  std::vector<DrawRefusal> refused_;
};

// Whether it says of itself what can be: runs that add up, an actor that has done it where it says
// so. Error episode.bad_value at `where`/physics/...
Result<void> check_certificate(const EpisodeCertificate& certificate, const std::string& where);

}  // namespace marketgen::episodes
