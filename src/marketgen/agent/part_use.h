// What a policy asked of parts of it that run in servers of their own, and what came of it.
#pragma once
#include <optional>
#include <string>

#include "base/fields.h"

namespace marketgen::agent {

// Every question ends as exactly one of `answered` to `bad_answer`; `skipped` counts those that
// were not put any more after failures in a row.
struct PartUse {
  std::string url;
  int questions = 0, answered = 0;
  int refused = 0, timed_out = 0, unreachable = 0, bad_answer = 0;
  int skipped = 0;
  int offline = 0;  // times that the program's own part stood in

  PartUse& operator+=(const PartUse& other) {
    url = other.url;
    questions += other.questions, answered += other.answered;
    refused += other.refused, timed_out += other.timed_out, unreachable += other.unreachable;
    bad_answer += other.bad_answer, skipped += other.skipped, offline += other.offline;
    return *this;
  }

  static constexpr auto fields = field_list(
      field("url", &PartUse::url, "of the server"),
      field("questions", &PartUse::questions, "that were put to it"),
      field("answered", &PartUse::answered, "questions that it answered as it should"),
      field("refused", &PartUse::refused, "questions that it answered by a status of failure"),
      field("timed_out", &PartUse::timed_out, "questions without an answer in time"),
      field("unreachable", &PartUse::unreachable, "questions that no server or record answered"),
      field("bad_answer", &PartUse::bad_answer, "questions answered by what is no answer"),
      field("skipped", &PartUse::skipped, "questions not put, after failures in a row"),
      field("offline", &PartUse::offline, "times that the program's own part stood in"));
};

struct PartsUse {
  std::optional<PartUse> masks, grasps;

  PartsUse& operator+=(const PartsUse& other) {
    for (const auto part : {&PartsUse::masks, &PartsUse::grasps}) {
      if (!(other.*part)) continue;
      if (!(this->*part)) this->*part = PartUse{};
      *(this->*part) += *(other.*part);
    }
    return *this;
  }

  static constexpr auto fields =
      field_list(field("masks", &PartsUse::masks, "a segmentation server"),
                 field("grasps", &PartsUse::grasps, "a grasp server"));
};

}  // namespace marketgen::agent
