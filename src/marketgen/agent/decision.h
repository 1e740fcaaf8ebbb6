// What a policy decided, and by what: for traces, and to find out afterwards which of its parts was
// wrong first (evaluation/decision_judge.h). Nothing acts by it.
//
// Places are in the frame that the policy is told things in: that of the station at a counter, of
// the store in an aisle. Metres.
#pragma once
#include <array>
#include <chrono>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/fields.h"
#include "geometry/image.h"
#include "geometry/vector.h"

namespace marketgen::agent {

// read     which products a goal's words mean: `readings`, the likeliest first
// look     what pictures show: `found` and `pictures`
// reach    the hand goes to a product at `middle`, after what it has `tried`
// hold     the hand has shut, and holds it or not
// place    it is let go where it belongs, or not
// contact  something was met where nothing was to be
// stop     the policy stops
enum class DecisionKind { read, look, reach, hold, place, contact, stop };
constexpr std::array<std::string_view, 7> names_of(DecisionKind) {
  return {"read", "look", "reach", "hold", "place", "contact", "stop"};
}

// A product of a goal, as pictures show it.
struct FoundGoal {
  std::size_t goal = 0;
  std::string sku;
  Vec3 middle;       // of its bounds
  double score = 0;  // 0..1, as the policy has it
};

// A grasp that was thought of.
struct TriedGrasp {
  std::array<double, 3> tip_m{};  // between the pads
  double opening_m = 0;
  double intrusion_m = 0;        // of the open hand into what else is seen
  std::string outcome = "None";  // a name of FailureCode; "None": this one is taken
  static constexpr auto fields = field_list(
      field("tip_m", &TriedGrasp::tip_m, "between the pads"),
      field("opening_m", &TriedGrasp::opening_m, "of the hand"),
      field("intrusion_m", &TriedGrasp::intrusion_m, "of the open hand into what else is seen"),
      field("outcome", &TriedGrasp::outcome, "None: taken; else a failure code"));
};

// A mark of a picture, in shares of its width and height from the top left.
struct PictureMark {
  std::array<double, 4> box{};  // left, top, right, bottom
  int goal = -1;                // -1: it is no goal's, but something of its own
  static constexpr auto fields =
      field_list(field("box", &PictureMark::box, "left, top, right, bottom in shares of the sides"),
                 field("goal", &PictureMark::goal, "whose it is taken to be; -1: a mask"));
};

struct LookedAt {
  std::string camera;
  Image picture;  // smaller than the camera's
  std::vector<PictureMark> marks;
};

struct Decision {
  DecisionKind kind = DecisionKind::look;
  double time_s = 0;      // of the observation that it was made by
  double computed_s = 0;  // of wall time, since the decision before or the answer's beginning
  int goal = -1;          // number of the task's goal; -1: none
  std::string sku = {};   // what is reached for, held or placed
  std::optional<Vec3> middle = {};
  std::string outcome = "None";  // a name of FailureCode
  std::vector<std::string> readings = {};
  std::vector<FoundGoal> found = {};
  std::vector<TriedGrasp> tried = {};
  std::vector<LookedAt> pictures = {};
};

// Not thread-safe.
class DecisionLog {
 public:
  // From now on decisions are kept; until then nothing is.
  void keep() { kept_ = true; }
  bool keeps() const { return kept_; }
  // An answer begins, by an observation of that time.
  void begin_answer(double time_s) {
    time_s_ = time_s;
    since_ = Clock::now();
  }
  void add(Decision decision) {
    if (!kept_) return;
    const Clock::time_point now = Clock::now();
    decision.time_s = time_s_;
    decision.computed_s = std::chrono::duration<double>(now - since_).count();
    since_ = now;
    decisions_.push_back(std::move(decision));
  }
  const std::vector<Decision>& decisions() const { return decisions_; }

 private:
  using Clock = std::chrono::steady_clock;
  bool kept_ = false;
  double time_s_ = 0;
  Clock::time_point since_ = Clock::now();
  std::vector<Decision> decisions_;
};

}  // namespace marketgen::agent
