#include "motion/rrt_connect.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/interrupt.h"

namespace marketgen::motion {
namespace {

constexpr int root = -1;

// Configurations one after the other, with the parent of each.
class Tree {
 public:
  explicit Tree(std::size_t joints) : joints_(joints) {}

  std::size_t size() const { return parents_.size(); }
  std::span<const double> operator[](std::size_t node) const {
    return {&values_[node * joints_], joints_};
  }
  std::size_t add(std::span<const double> q, int parent) {
    values_.insert(values_.end(), q.begin(), q.end());
    parents_.push_back(parent);
    return size() - 1;
  }
  std::size_t nearest(std::span<const double> q) const {
    std::size_t best = 0;
    double least = 1e300;
    for (std::size_t node = 0; node < size(); ++node) {
      const double* at = &values_[node * joints_];
      double sum = 0;
      for (std::size_t j = 0; j < joints_; ++j)
        sum += (at[j] - q[j]) * (at[j] - q[j]);
      if (sum < least) {
        least = sum;
        best = node;
      }
    }
    return best;
  }
  JointPath way_to_root(std::size_t node) const {
    JointPath way;
    for (int at = static_cast<int>(node); at != root; at = parents_[static_cast<std::size_t>(at)]) {
      const std::span<const double> q = (*this)[static_cast<std::size_t>(at)];
      way.emplace_back(q.begin(), q.end());
    }
    return way;
  }

 private:
  std::size_t joints_;
  std::vector<double> values_;
  std::vector<int> parents_;
};

Configuration between(std::span<const double> a, std::span<const double> b, double share) {
  Configuration q(a.size());
  for (std::size_t j = 0; j < q.size(); ++j)
    q[j] = a[j] + share * (b[j] - a[j]);
  return q;
}

Result<void> check(const ConfigurationSpace& space, const Configuration& q, const char* which) {
  const auto bad = [&](const std::string& message) {
    return Error{"motion.bad_configuration", which, message};
  };
  if (q.size() != space.lower.size() || q.size() != space.upper.size() || q.empty())
    return bad(fmt::format("has {} joints, expected {}", q.size(), space.lower.size()));
  for (std::size_t j = 0; j < q.size(); ++j) {
    if (!std::isfinite(q[j])) return bad(fmt::format("joint {} is not a finite number", j));
    if (q[j] < space.lower[j] - 1e-9 || q[j] > space.upper[j] + 1e-9) {
      return bad(fmt::format("joint {} is at {:.4f}; its limits are {:.4f} to {:.4f}",
                             j,
                             q[j],
                             space.lower[j],
                             space.upper[j]));
    }
  }
  return {};
}

// Extends `tree` towards `target` until it is there or something is in the way; returns the last
// node.
std::size_t connect(const ConfigurationSpace& space,
                    Tree& tree,
                    std::span<const double> target,
                    double range,
                    std::size_t max_nodes) {
  std::size_t at = tree.nearest(target);
  while (tree.size() < max_nodes) {
    interrupt_point();
    const double left = distance(tree[at], target);
    if (left < 1e-12) return at;
    const double share = std::min(1.0, range / left);
    Configuration next =
        share < 1 ? between(tree[at], target, share) : Configuration(target.begin(), target.end());
    if (!space.motion_free(tree[at], next)) return at;
    at = tree.add(next, static_cast<int>(at));
  }
  return at;
}

JointPath joined(const Tree& from_start, std::size_t a, const Tree& from_goal, std::size_t b) {
  JointPath path = from_start.way_to_root(a);
  std::reverse(path.begin(), path.end());
  const JointPath rest = from_goal.way_to_root(b);
  path.insert(path.end(), rest.begin() + 1, rest.end());  // both hold the meeting place
  return path;
}

// Grows the two trees in turn. Errors: motion.no_path.
Result<JointPath> grow(const ConfigurationSpace& space,
                       Tree start_tree,
                       Tree goal_tree,
                       Seed seed,
                       const RrtOptions& options) {
  const std::size_t joints = space.lower.size();
  const auto most = static_cast<std::size_t>(std::max(options.max_nodes, 4)) / 2;
  Stream draw = seed.child("rrt_connect").stream();
  for (int i = 0; i < options.max_iterations; ++i) {
    const bool forward = start_tree.size() <= goal_tree.size();  // the smaller tree is balanced up
    Tree& grown = forward ? start_tree : goal_tree;
    Tree& other = forward ? goal_tree : start_tree;
    if (grown.size() >= most) break;
    Configuration sample(joints);
    for (std::size_t j = 0; j < joints; ++j)
      sample[j] = draw.uniform(space.lower[j], space.upper[j]);
    const std::size_t near = grown.nearest(sample);
    const double away = distance(grown[near], sample);
    if (away > options.range) sample = between(grown[near], sample, options.range / away);
    if (!space.motion_free(grown[near], sample)) continue;
    const std::size_t added = grown.add(sample, static_cast<int>(near));
    const std::size_t met = connect(space, other, sample, options.range, most);
    if (distance(other[met], sample) > 1e-12) continue;
    return forward ? joined(start_tree, added, goal_tree, met)
                   : joined(start_tree, met, goal_tree, added);
  }
  return Error{"motion.no_path",
               "arm path",
               fmt::format("none found in {} samples ({} and {} nodes); move the base or take "
                           "another grasp",
                           options.max_iterations,
                           start_tree.size(),
                           goal_tree.size())};
}

// Each corner is followed by the farthest later one that it can reach.
JointPath without_needless_corners(const ConfigurationSpace& space, const JointPath& path) {
  JointPath kept{path.front()};
  for (std::size_t at = 0; at + 1 < path.size();) {
    std::size_t next = path.size() - 1;
    while (next > at + 1 && !space.motion_free(path[at], path[next]))
      --next;
    kept.push_back(path[next]);
    at = next;
  }
  return kept;
}

struct Place {
  std::size_t piece;  // between path[piece] and path[piece + 1]
  Configuration q;
};
Place place_at(const JointPath& path, double along) {
  for (std::size_t i = 0; i + 2 < path.size(); ++i) {
    const double piece = distance(path[i], path[i + 1]);
    if (along <= piece) return {i, between(path[i], path[i + 1], piece > 0 ? along / piece : 0)};
    along -= piece;
  }
  const std::size_t last = path.size() - 2;
  const double piece = distance(path[last], path[last + 1]);
  return {last, between(path[last], path[last + 1], piece > 0 ? std::min(1.0, along / piece) : 0)};
}

}  // namespace

double distance(std::span<const double> a, std::span<const double> b) {
  double sum = 0;
  for (std::size_t j = 0; j < a.size(); ++j)
    sum += (a[j] - b[j]) * (a[j] - b[j]);
  return std::sqrt(sum);
}

double length_of(const JointPath& path) {
  double sum = 0;
  for (std::size_t i = 0; i + 1 < path.size(); ++i)
    sum += distance(path[i], path[i + 1]);
  return sum;
}

Result<JointPath> rrt_connect(const ConfigurationSpace& space,
                              const Configuration& start,
                              const std::vector<Configuration>& goals,
                              Seed seed,
                              const RrtOptions& options) {
  MARKETGEN_CHECK(check(space, start, "start of the arm path"));
  for (const Configuration& goal : goals)
    MARKETGEN_CHECK(check(space, goal, "goal of the arm path"));
  if (!space.free(start))
    return Error{"motion.start_in_collision", "start of the arm path", "the arm touches something"};
  const std::size_t joints = space.lower.size();
  Tree start_tree(joints), goal_tree(joints);
  start_tree.add(start, root);
  for (const Configuration& goal : goals) {
    if (!space.free(goal)) continue;
    if (space.motion_free(start, goal)) return JointPath{start, goal};
    goal_tree.add(goal, root);
  }
  if (goal_tree.size() == 0) {
    return Error{"motion.goal_in_collision",
                 "goal of the arm path",
                 fmt::format("the arm touches something in each of {} goals", goals.size())};
  }
  return grow(space, std::move(start_tree), std::move(goal_tree), seed, options);
}

JointPath shortcut(const ConfigurationSpace& space, JointPath path, Seed seed, int tries) {
  if (path.size() < 3) return path;
  path = without_needless_corners(space, path);
  Stream draw = seed.child("shortcut").stream();
  for (int i = 0; i < tries && path.size() > 2; ++i) {
    const double whole = length_of(path);
    double a = draw.uniform(0, whole), b = draw.uniform(0, whole);
    if (a > b) std::swap(a, b);
    const Place from = place_at(path, a), to = place_at(path, b);
    if (from.piece == to.piece) continue;
    if (!space.motion_free(from.q, to.q)) continue;
    JointPath shorter(path.begin(), path.begin() + static_cast<std::ptrdiff_t>(from.piece) + 1);
    shorter.push_back(from.q);
    shorter.push_back(to.q);
    shorter.insert(
        shorter.end(), path.begin() + static_cast<std::ptrdiff_t>(to.piece) + 1, path.end());
    path = std::move(shorter);
  }
  return without_needless_corners(space, path);
}

}  // namespace marketgen::motion
