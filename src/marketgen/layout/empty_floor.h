// How far the floor is empty round each point of it, on a coarse grid.
#pragma once
#include <optional>
#include <vector>

#include "layout/design.h"
#include "layout/layout.h"
#include "navigation/occupancy.h"

namespace marketgen::layout {

// A round piece of floor on which nothing stands.
struct EmptyDisc {
  PointMm center;
  int radius_mm;
};

class EmptyFloor {
 public:
  EmptyFloor(const Floor& floor, const std::vector<Fixture>& fixtures);

  // The largest whose middle lies in the rectangle; nothing when all of it is taken.
  std::optional<EmptyDisc> largest_in(const RectMm& area) const;
  void add(const RectMm& footprint);

 private:
  navigation::OccupancyGrid grid_;
  std::vector<float> radius_mm_;  // by cell
};

}  // namespace marketgen::layout
