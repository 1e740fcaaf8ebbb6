// Pictures that one camera takes of what stands still, made one.
//
// Noise of a depth camera differs from picture to picture; what stands still does not.
#pragma once
#include <vector>

#include "agent/eyes.h"

namespace marketgen::perception {

class SteadyViews {
 public:
  // Where the camera has moved since the last one, those before are forgotten.
  void add(agent::View view);
  // Whether more would not better depth by much: by how much the first two differ. At most eight
  // are enough.
  bool enough() const;
  // Of those that were added, at least one: mean colour; depth the mean of what is near the middle
  // value, none where most have none. Time and place are the last one's.
  agent::View merged() const;

 private:
  std::vector<agent::View> views_;
};

}  // namespace marketgen::perception
