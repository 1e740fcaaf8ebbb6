// MuJoCo's tree over what stands still, cut down to what is near something that moves.
//
// MuJoCo holds each body that moves against the tree of the whole store at every step: 5 us a body.
// Most of what it meets there is as far away as it was in the step before. Here each mover has a
// list of what stands near it, looked up anew when it has moved by some millimetres, and MuJoCo's
// tree is made of these lists alone.
//
// What touches what does not depend on the tree: MuJoCo sorts the contacts of two bodies by their
// geoms, and the lists hold all that could touch. So a World may forget them at any time.
#pragma once
#include <cstdint>
#include <vector>

#include "physics/world/still_tree.h"

namespace marketgen::physics {

class NearTree {
 public:
  // `body` stands still at the origin and its geoms are the model's last; one of them is a plane.
  // Movers are known by a geom, one of those before.
  NearTree(mjModel& model, int body);

  // The mover is in `box`: looks round it unless it has done so nearby.
  void follow(int mover, const Box3& box);
  void leave(int mover);  // it touches nothing any more
  // Whether all that can touch a mover in `box` is in the tree.
  bool holds(int mover, const Box3& box) const;
  void refit(const mjModel& model, int geom);  // that stands still, elsewhere than before
  void forget();                               // the lists of all movers
  void write(mjModel& model);                  // the tree, when it has changed

 private:
  struct Mover {
    bool known = false;
    Box3 box, looked_in;  // where it was last, and that and `round_m` round where it was
    double round_m = 0;
    std::vector<int> near;
  };
  std::vector<int> all_near();
  void grow(mjModel& model, std::vector<int>::iterator from, std::vector<int>::iterator to);
  int next_node(mjModel& model, const Box3* box);

  StillTree still_;
  int body_;
  std::vector<int> planes_;
  std::vector<Mover> movers_;
  std::vector<bool> listed_;  // by still geom, while lists are joined
  bool changed_ = true;
  int nodes_ = 0;
};

// While it lives MuJoCo sees only the geoms before `count`. Its loops over all geoms place what
// moves and find its middle: 55 us of a step, for 27,000 goods that do neither. Pairs are found by
// the tree, which knows them all.
class FirstGeoms {
 public:
  FirstGeoms(mjModel& model, int count) : model_(model), all_(model.ngeom) { model.ngeom = count; }
  ~FirstGeoms() { model_.ngeom = all_; }
  FirstGeoms(const FirstGeoms&) = delete;
  FirstGeoms& operator=(const FirstGeoms&) = delete;

 private:
  mjModel& model_;
  decltype(mjModel::ngeom) all_;
};

// For every body that moves, at every step, MuJoCo joins the contact bits of all geoms of what
// stands still, to see whether the two can meet at all: 3 us a body. Goods have the same bits, and
// fixtures those of the floor: the first two geoms are enough. After NearTree has been made.
void shorten_bit_filter(mjModel& model, int body);

}  // namespace marketgen::physics
