// What keeps the floor whole when something more is put on it.
#pragma once
#include <vector>

#include "layout/design.h"
#include "layout/layout.h"
#include "layout/reach.h"

namespace marketgen::layout {

class FloorGuard {
 public:
  // Of what stands already; its aisles are those that must stay as wide.
  FloorGuard(const Design& design, const std::vector<Fixture>& fixtures);

  // Whether it may stand there: no aisle becomes narrower than it may be, every front that a
  // wheelchair or a robot gets to is still got to, so is its own, and no free floor is cut off.
  bool allows(const Fixture& item) const;
  void add(const Fixture& item);

 private:
  // The floor of something round that goes about, and where it stands before fronts.
  struct Walker {
    int width_mm;
    Reach reach;
    std::vector<RectMm> fronts;
  };
  bool leaves_aisles(const RectMm& rect) const;

  int min_untight_aisle_mm_;
  std::vector<Aisle> aisles_;
  std::vector<Walker> walkers_;
};

}  // namespace marketgen::layout
