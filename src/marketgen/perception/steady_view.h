// Pictures that one camera takes of one scene while it stands still, as one picture: what a depth
// camera errs by is another error in each.
#pragma once
#include <vector>

#include "agent/eyes.h"

namespace marketgen::perception {

class SteadyView {
 public:
  SteadyView() = default;
  // Wants pictures until depth a metre away has so little noise (one sigma), at most twelve.
  explicit SteadyView(double wanted_noise_m) : wanted_noise_m_(wanted_noise_m) {}
  // Left out when it was taken by another camera or from elsewhere than the first one.
  void add(agent::View view);
  bool empty() const { return views_.empty(); }
  // Whether another picture would tell more: two say how noisy depth is, and of that it depends.
  bool wants_more() const;
  // Of one picture, one sigma of depth a metre away: stereo's grows with the square of distance, m.
  double noise_m() const { return noise_m_; }
  // Depth is the mean of most of what was measured, pixel by pixel; none where most measured none.
  // Without noise the first picture as it is. Forgets its pictures, of which there must be one.
  agent::View take();

 private:
  double wanted_noise_m_ = 0.0018;
  std::vector<agent::View> views_;
  int added_ = 0;  // with those left out
  double noise_m_ = 0;
};

}  // namespace marketgen::perception
