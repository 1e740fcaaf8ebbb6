// Where a hand came upon something that pictures had not shown, or to where it found no way.
//
// Base frame of the arm, metres.
#pragma once
#include <map>
#include <vector>

#include "geometry/pose.h"
#include "perception/product_look.h"

namespace marketgen::policy {

class FeltContacts {
 public:
  void forget();  // when something was taken out, and all lies otherwise
  bool any() const { return !grasps_.empty(); }  // at grasps
  // At a grasp of this product; where what was held was to be put down.
  void note_grasp(const Pose& base_from_tip, const perception::ProductLook& look);
  // Of a grasp to which no way was found: others come first.
  void note_no_way(const Pose& base_from_tip) { grasps_.push_back(base_from_tip); }
  void note_place(Vec3 tip) { places_.push_back(tip); }

  // Whether it was at this grasp, or one that is nearly the same; at a place beside this one.
  bool has_grasp(const Pose& base_from_tip) const;
  bool has_place(Vec3 tip) const;
  int count(const perception::ProductLook& look) const;  // at its grasps

 private:
  std::vector<Pose> grasps_;
  std::map<const perception::ProductLook*, int> counts_;
  std::vector<Vec3> places_;
};

}  // namespace marketgen::policy
