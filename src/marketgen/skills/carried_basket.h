// The basket that a robot carries, what lies in it, and how low something more can be let down.
//
// Base frame: that of the robot (on the floor, X ahead). Basket's frame: middle of its inner floor,
// Z up. Metres.
#pragma once
#include <vector>

#include "geometry/pose.h"
#include "motion/collision_world.h"
#include "skills/held_product.h"

namespace marketgen::skills {

// The inside of the basket: a box that is open above.
struct CarriedBasket {
  Pose base_from_floor;                    // middle of its inner floor, Z up
  Vec3 size;                               // inner; z up to the rim
  std::vector<motion::BoxObstacle> walls;  // base frame, floor included
};

// Something that lies in it.
struct CarriedItem {
  std::vector<assets::ContactPiece> pieces;  // product frame
  Pose base_from_product;
};
// Of which only the box is known that holds it.
CarriedItem carried_box(const TurnedBox& base_box);
// Its own box, as it lies.
motion::BoxObstacle box_of(const CarriedItem& item);

// What is held, seen from below: how high its surface begins, column by column.
class Underside {
 public:
  // As it is turned: the rotation counts, in the basket's frame.
  Underside(const assets::ProductBody& held, const Quaternion& basket_from_product);
  const TurnedBox& box() const { return box_; }  // about the held product's origin

 private:
  friend class BasketFill;
  struct Column {
    int x = 0, y = 0;  // of the grid, from the middle of the box
    double low_m = 0;  // from that middle up; negative below
  };
  std::vector<Column> columns_;
  TurnedBox box_;
};

// How high what lies in the basket reaches, column by column; never less wide than it is.
class BasketFill {
 public:
  BasketFill(const CarriedBasket& basket, const std::vector<CarriedItem>& inside);
  // Straight down, its box's middle over (x, y) of the basket's frame: how high over the floor its
  // lowest point is when it first meets the floor or something that lies there. Within some
  // millimetres.
  double rest_m(const Underside& held, double x, double y) const;

 private:
  Vec3 low_;  // corner of the first column
  int wide_ = 0, deep_ = 0;
  std::vector<double> tops_;  // x fastest; 0 where nothing lies
};

}  // namespace marketgen::skills
