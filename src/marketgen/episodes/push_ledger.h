// Pushes, one after another, by the greatest force of each (mean over 10 ms): below 10 N, to 50 N,
// above. A value.
#pragma once
#include <cstdint>
#include <map>
#include <vector>

#include "base/byte_archive.h"
#include "episodes/episode_result.h"

namespace marketgen::episodes {

// One push, with the thing that was pushed.
struct Push {
  std::uint64_t thing = 0;
  double peak_n = 0, lasted_s = 0;
};

class PushLedger {
 public:
  // After every step: the force on each thing that is pushed, N. A thing that is left out is not.
  void follow(const std::map<std::uint64_t, double>& force_n, double step_s);
  // Counts pushes that still last as ended.
  void add_to(SideEffects& effects) const;

  // For recordings: those that ended, in that order, and those that last. Of a moment that was
  // restored they are forgotten, and a push lasts since then.
  const std::vector<Push>& ended() const { return past_; }
  std::vector<Push> lasting() const;

  template <class Archive, class Self>
  static void bytes(Archive& archive, Self& self) {
    archive(self.pushes_);
    auto& ended = self.ended_;  // of pushes; the rest of it is not this ledger's
    archive(ended.light_contacts, ended.firm_contacts, ended.hard_contacts, ended.hardest_n);
  }

 private:
  struct Pressed {
    double smooth_n = 0, peak_n = 0;
    bool lasts = false;
    double lasted_s = 0;  // no part of a moment

    template <class Archive, class Self>
    static void bytes(Archive& archive, Self& self) {
      archive(self.smooth_n, self.peak_n, self.lasts);
    }
  };
  // False: nothing is left of it.
  bool follow(std::uint64_t thing, Pressed& push, double force_n, double step_s);
  std::map<std::uint64_t, Pressed> pushes_;
  SideEffects ended_;
  std::vector<Push> past_;
};

}  // namespace marketgen::episodes
