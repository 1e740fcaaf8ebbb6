// What a policy asked of a model outside of the program, and what came of it.
#pragma once
#include <cstdint>

#include "base/fields.h"

namespace marketgen::agent {

// Every question ends as exactly one of `chosen` to `no_pose`; `skipped` counts those that were not
// put any more after failures in a row.
struct ModelUse {
  int questions = 0, requests = 0;  // a question is one request or several
  std::int64_t tokens_in = 0, tokens_out = 0;
  int chosen = 0, absent = 0;
  int refused = 0, timed_out = 0, unreachable = 0, bad_answer = 0, off_picture = 0, no_pose = 0;
  int skipped = 0;
  int offline = 0;  // times that the program's own choice stood in

  ModelUse& operator+=(const ModelUse& other) {
    questions += other.questions, requests += other.requests;
    tokens_in += other.tokens_in, tokens_out += other.tokens_out;
    chosen += other.chosen, absent += other.absent;
    refused += other.refused, timed_out += other.timed_out, unreachable += other.unreachable;
    bad_answer += other.bad_answer, off_picture += other.off_picture, no_pose += other.no_pose;
    skipped += other.skipped, offline += other.offline;
    return *this;
  }

  static constexpr auto fields = field_list(
      field("questions", &ModelUse::questions, "that were put to it"),
      field("requests", &ModelUse::requests, "sent to it, answered or not"),
      field("tokens_in", &ModelUse::tokens_in, "read, as it says"),
      field("tokens_out", &ModelUse::tokens_out, "written, as it says"),
      field("chosen", &ModelUse::chosen, "questions that ended with a mark"),
      field("absent", &ModelUse::absent, "questions that ended with: it is not there"),
      field("refused", &ModelUse::refused, "questions that it, or its server, refused"),
      field("timed_out", &ModelUse::timed_out, "questions without an answer in time"),
      field("unreachable", &ModelUse::unreachable, "questions that no server or record answered"),
      field("bad_answer", &ModelUse::bad_answer, "questions answered by what is no answer, twice"),
      field("off_picture",
            &ModelUse::off_picture,
            "questions answered by a number that no mark has, twice"),
      field("no_pose",
            &ModelUse::no_pose,
            "questions that ended with a mark where the product does not fit in any pose"),
      field("skipped", &ModelUse::skipped, "questions not put, after failures in a row"),
      field("offline",
            &ModelUse::offline,
            "times that the choice without a model stood in, after a failure"));
};

}  // namespace marketgen::agent
