// Asks a language model that sees pictures which mark shows a product, twice: among all marks, and
// again with that part alone (the paper's prompting after Set-of-Mark).
//
// Every question ends as one of MarkOutcome; no answer, however odd, is an error of the caller's.
// Sent out are the marked pictures, the part alone and the product's words; nothing else.
#pragma once
#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "agent/model_use.h"
#include "llm/language_model.h"
#include "perception/marked_picture.h"

namespace marketgen::perception {

enum class MarkOutcome {
  chosen,       // one that is on the pictures
  absent,       // the model says that none shows it
  refused,      // the model declined, or its server did
  timed_out,    // no answer in time
  unreachable,  // no server, or nothing recorded
  bad_answer,   // twice no JSON that was asked for
  off_picture,  // twice a number that no mark has
  skipped,      // not asked any more, after `max_failed` failures in a row
};
constexpr int max_failed = 3;

// Whether the model has said something that can be used.
constexpr bool has_answered(MarkOutcome outcome) {
  return outcome == MarkOutcome::chosen || outcome == MarkOutcome::absent;
}

struct MarkChoice {
  MarkOutcome outcome = MarkOutcome::absent;
  std::size_t mark = 0;     // number in MarkedPictures::marks, from 0; of `chosen` only
  bool remembered = false;  // it was asked and counted before
};

// One thread's. Counts what it asks.
class MarkQuestioner {
 public:
  explicit MarkQuestioner(llm::LanguageModel model) : model_(std::move(model)) {}

  // Which of the marks shows the product of these words. Answers are remembered: the same pictures
  // and words are sent once. Without marks nothing is sent, and it is absent.
  MarkChoice which(const std::string& words,
                   const MarkedPictures& marked,
                   const std::vector<ViewCloud>& views,
                   const std::vector<MaskedView>& masked);

  // What came of choices afterwards: no pose fits the mark that was chosen; the choice without a
  // model stood in.
  void count_no_pose(const MarkChoice& choice) {
    if (!choice.remembered) --use_.chosen, ++use_.no_pose;
  }
  void count_offline() { ++use_.offline; }
  const agent::ModelUse& use() const { return use_; }

 private:
  struct Asked {
    MarkOutcome outcome;
    int number;  // as the pictures have it; -1: none
  };
  MarkChoice ask(const std::string& words,
                 const MarkedPictures& marked,
                 std::vector<std::string> pictures,
                 const std::vector<ViewCloud>& views,
                 const std::vector<MaskedView>& masked);
  Asked put(std::string text, std::vector<std::string> pictures, std::size_t marks);
  llm::LanguageModel counted();
  void count(MarkOutcome outcome);

  llm::LanguageModel model_;
  agent::ModelUse use_;
  int failed_in_a_row_ = 0;
  std::map<std::pair<std::string, std::uint64_t>, MarkChoice> remembered_;
};

}  // namespace marketgen::perception
