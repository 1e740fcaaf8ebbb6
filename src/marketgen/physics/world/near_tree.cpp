#include "physics/world/near_tree.h"

#include <algorithm>

namespace marketgen::physics {
namespace {

// A mover is looked round as far as it goes in ten steps, at least so far; and again when it has
// gone half of that.
constexpr double steps_ahead = 10, min_round_m = 0.006, max_round_m = 0.06, spent_share = 0.5;
// Added to the boxes of the tree, so that rounding there never decides about a contact.
constexpr double box_slack_m = 1e-6;

Box3 grown(const Box3& box, double by) {
  const Vec3 all{by, by, by};
  return {box.low - all, box.high + all};
}

bool within(const Box3& inner, const Box3& outer) {
  return inner.low.x >= outer.low.x && inner.low.y >= outer.low.y && inner.low.z >= outer.low.z &&
         inner.high.x <= outer.high.x && inner.high.y <= outer.high.y &&
         inner.high.z <= outer.high.z;
}

double middle_along(const Box3& box, int axis) {
  return axis == 0   ? box.low.x + box.high.x
         : axis == 1 ? box.low.y + box.high.y
                     : box.low.z + box.high.z;
}

}  // namespace

NearTree::NearTree(mjModel& m, int body)
    : still_(m, body),
      body_(body),
      movers_(static_cast<std::size_t>(m.body_geomadr[body])),
      listed_(static_cast<std::size_t>(m.ngeom), false) {
  for (int geom = m.body_geomadr[body]; geom < m.ngeom; ++geom) {
    if (m.geom_type[geom] == mjGEOM_PLANE) planes_.push_back(geom);
  }
}

void NearTree::follow(int mover, const Box3& box) {
  Mover& here = movers_[static_cast<std::size_t>(mover)];
  const double way = here.known ? length(box.low - here.box.low) : 0;
  here.box = box;
  const double round = std::clamp(steps_ahead * way, min_round_m, max_round_m);
  if (here.known && within(grown(box, spent_share * here.round_m), here.looked_in)) return;
  here.known = true;
  here.round_m = round;
  here.looked_in = grown(box, round);
  std::vector<int> near = still_.near(grown(here.looked_in, box_slack_m));
  if (near == here.near) return;
  here.near = std::move(near);
  changed_ = true;
}

void NearTree::leave(int mover) {
  Mover& here = movers_[static_cast<std::size_t>(mover)];
  if (!here.known) return;
  here = {};
  changed_ = true;
}

bool NearTree::holds(int mover, const Box3& box) const {
  const Mover& here = movers_[static_cast<std::size_t>(mover)];
  return here.known && within(box, here.looked_in);
}

void NearTree::refit(const mjModel& m, int geom) {
  still_.refit(m, geom);
  const Box3& box = still_.box(geom);
  for (Mover& mover : movers_) {
    if (mover.known && mover.looked_in.meets(box, box_slack_m)) mover.known = false;
  }
  changed_ = true;  // it may be in the tree, where it was
}

void NearTree::forget() {
  std::ranges::fill(movers_, Mover{});
  changed_ = true;
}

std::vector<int> NearTree::all_near() {
  std::vector<int> all;
  for (const Mover& mover : movers_) {
    for (const int geom : mover.near) {
      if (listed_[static_cast<std::size_t>(geom)]) continue;
      listed_[static_cast<std::size_t>(geom)] = true;
      all.push_back(geom);
    }
  }
  for (const int geom : all)
    listed_[static_cast<std::size_t>(geom)] = false;
  return all;
}

// A node with its box, or one without end; its children and geom are still missing.
int NearTree::next_node(mjModel& m, const Box3* box) {
  const int at = m.body_bvhadr[body_] + nodes_;
  mjtNum* to = m.bvh_aabb + 6 * at;
  std::fill(to, to + 3, 0.0), std::fill(to + 3, to + 6, mjMAXVAL);
  if (box != nullptr) {
    const Vec3 middle = (box->low + box->high) / 2, half = (box->high - box->low) / 2;
    to[0] = middle.x, to[1] = middle.y, to[2] = middle.z;
    to[3] = half.x + box_slack_m, to[4] = half.y + box_slack_m, to[5] = half.z + box_slack_m;
  }
  m.bvh_nodeid[at] = -1;
  m.bvh_child[2 * at] = m.bvh_child[2 * at + 1] = -1;
  return at;
}

// Halves at the median: the lists are short.
void NearTree::grow(mjModel& m, std::vector<int>::iterator from, std::vector<int>::iterator to) {
  Box3 box = still_.box(*from);
  Box3 middles{box.low + box.high, box.low + box.high};
  for (auto geom = from; geom != to; ++geom) {
    const Box3& one = still_.box(*geom);
    const Vec3 middle = one.low + one.high;
    const auto take_in = [](Box3& into, Vec3 low, Vec3 high) {
      into.low = {
          std::min(into.low.x, low.x), std::min(into.low.y, low.y), std::min(into.low.z, low.z)};
      into.high = {std::max(into.high.x, high.x),
                   std::max(into.high.y, high.y),
                   std::max(into.high.z, high.z)};
    };
    take_in(box, one.low, one.high);
    take_in(middles, middle, middle);
  }
  const int at = next_node(m, &box);
  ++nodes_;
  if (to - from == 1) {
    m.bvh_nodeid[at] = *from;
    return;
  }
  const Vec3 spread = middles.high - middles.low;
  const int axis = spread.x >= spread.y && spread.x >= spread.z ? 0 : spread.y >= spread.z ? 1 : 2;
  const auto half = from + (to - from) / 2;
  std::nth_element(from, half, to, [&](int a, int b) {
    return middle_along(still_.box(a), axis) < middle_along(still_.box(b), axis);
  });
  m.bvh_child[2 * at] = nodes_;
  grow(m, from, half);
  m.bvh_child[2 * at + 1] = nodes_;
  grow(m, half, to);
}

void NearTree::write(mjModel& m) {
  if (!changed_) return;
  changed_ = false;
  std::vector<int> geoms = all_near();
  nodes_ = 0;
  for (std::size_t i = 0; i < planes_.size(); ++i) {  // split off one by one
    const bool last = i + 1 == planes_.size() && geoms.empty();
    const int inner = next_node(m, nullptr);
    int leaf = inner;
    if (!last) {
      m.bvh_child[2 * inner] = ++nodes_;
      m.bvh_child[2 * inner + 1] = nodes_ + 1;
      leaf = next_node(m, nullptr);
    }
    m.bvh_nodeid[leaf] = planes_[i];
    ++nodes_;
  }
  if (!geoms.empty()) grow(m, geoms.begin(), geoms.end());
  m.body_bvhnum[body_] = nodes_;
}

void shorten_bit_filter(mjModel& m, int body) {
  m.body_geomnum[body] = std::min(2, m.body_geomnum[body]);
}

}  // namespace marketgen::physics
