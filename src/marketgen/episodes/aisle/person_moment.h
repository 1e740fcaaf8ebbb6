// What somebody is doing, and for how long by now; what pictures of a moment are made by.
#pragma once
#include "collect/person_round.h"

namespace marketgen::episodes {

struct PersonMoment {
  collect::PersonWalk walk;
  double time_s = 0;

  bool operator==(const PersonMoment&) const = default;
  template <class Archive, class Self>
  static void bytes(Archive& archive, Self& self) {
    archive(self.walk, self.time_s);
  }
};

}  // namespace marketgen::episodes
