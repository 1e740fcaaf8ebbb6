// What the oracle has tried: so often, of each item, and how it failed.
#pragma once
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

#include "geometry/pose.h"
#include "robots/robot.h"

namespace marketgen::oracle {

class OracleTries {
 public:
  // Whether the item may be taken once more.
  bool may_take(std::size_t item) const;
  // Whether nearly the same grasp failed before; of a cup, however it was turned about its axis.
  // Product frame.
  bool failed_before(std::size_t item,
                     const Pose& product_from_tip,
                     robots::ToolKind tool = robots::ToolKind::gripper) const;

  int take(std::size_t item);  // now; which try it is, since the item was last put down
  void fail(std::size_t item, const Pose& product_from_tip);
  void put_down(std::size_t item);  // where it belongs

 private:
  std::map<std::size_t, int> tries_, takes_;
  std::vector<std::pair<std::size_t, Pose>> failed_;
};

}  // namespace marketgen::oracle
