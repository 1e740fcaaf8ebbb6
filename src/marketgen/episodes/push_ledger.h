// Pushes, one after another, by the greatest force of each (mean over 10 ms): below 10 N, to 50 N,
// above. A value.
#pragma once
#include <cstdint>
#include <map>

#include "base/byte_archive.h"
#include "episodes/episode_result.h"

namespace marketgen::episodes {

class PushLedger {
 public:
  // After every step: the force on each thing that is pushed, N. A thing that is left out is not.
  void follow(const std::map<std::uint64_t, double>& force_n, double step_s);
  // Counts pushes that still last as ended.
  void add_to(SideEffects& effects) const;

  template <class Archive, class Self>
  static void bytes(Archive& archive, Self& self) {
    archive(self.pushes_);
    auto& ended = self.ended_;  // of pushes; the rest of it is not this ledger's
    archive(ended.light_contacts, ended.firm_contacts, ended.hard_contacts, ended.hardest_n);
  }

 private:
  struct Push {
    double smooth_n = 0, peak_n = 0;
    bool lasts = false;

    template <class Archive, class Self>
    static void bytes(Archive& archive, Self& self) {
      archive(self.smooth_n, self.peak_n, self.lasts);
    }
  };
  bool follow(Push& push, double force_n, double step_s);  // false: nothing is left of it
  std::map<std::uint64_t, Push> pushes_;
  SideEffects ended_;
};

}  // namespace marketgen::episodes
