#include "robots/self_collision.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/seed.h"

namespace marketgen::robots {
namespace {

constexpr int sampled_postures = 500;

double clamped_share(double numerator, double denominator) {
  return denominator > 0 ? std::clamp(numerator / denominator, 0.0, 1.0) : 0;
}

// Between the segments a0..a1 and b0..b1 (Ericson, Real-Time Collision Detection, 2005, 5.1.9).
double segment_distance(const Capsule& first, const Capsule& second) {
  const Vec3 d1 = first.b - first.a, d2 = second.b - second.a, r = first.a - second.a;
  const double a = dot(d1, d1), e = dot(d2, d2), f = dot(d2, r), c = dot(d1, r), b = dot(d1, d2);
  double s = clamped_share(b * f - c * e, a * e - b * b);
  const double t = clamped_share(b * s + f, e);
  s = clamped_share(b * t - c, a);
  return length(first.a + d1 * s - (second.a + d2 * t));
}

Capsule carried(const Capsule& capsule, const Pose& pose) {
  return {pose * capsule.a, pose * capsule.b, capsule.radius};
}

// The link to which each is bolted, over any number of fixed joints.
std::vector<int> bodies_of(const Robot& robot) {
  std::vector<int> body(robot.links.size(), 0);
  for (const Joint& joint : robot.joints) {
    const auto link = static_cast<std::size_t>(joint.link);
    body[link] = joint.dof < 0 ? body[static_cast<std::size_t>(joint.parent)] : joint.link;
  }
  return body;
}

int leader_of(const Robot& robot, int body) {
  if (body == 0) return -1;
  const Joint& joint = robot.joints[static_cast<std::size_t>(body - 1)];
  return joint.follows >= 0 ? joint.follows : joint.dof;
}

// Bodies `a` < `b`, parents first: whether one joint lies between them, or they move together.
bool always_apart(const Robot& robot, const std::vector<int>& body, int a, int b) {
  if (a == b) return true;
  const int parent = robot.joints[static_cast<std::size_t>(b - 1)].parent;
  return body[static_cast<std::size_t>(parent)] == a || leader_of(robot, a) == leader_of(robot, b);
}

std::vector<double> drawn_posture(const Robot& robot, Stream& draw) {
  std::vector<double> q(robot.dof_count());
  for (std::size_t i = 0; i < q.size(); ++i) {
    const Joint& joint = robot.joint_of_dof(i);
    q[i] = draw.uniform(std::max(joint.lower, -3.2), std::min(joint.upper, 3.2));
  }
  return with_followers(robot, std::move(q));
}

// Without the pairs that overlap in every posture drawn.
std::vector<LinkPair> ever_apart(const Robot& robot, const std::vector<LinkPair>& pairs) {
  Stream draw = Seed(0).child("pairs_that_may_touch").stream();
  std::vector<bool> apart(pairs.size(), false);
  for (int i = 0; i < sampled_postures; ++i) {
    const std::vector<Pose> poses = link_poses(robot, drawn_posture(robot, draw));
    for (std::size_t k = 0; k < pairs.size(); ++k) {
      if (!apart[k]) apart[k] = link_distance(robot, poses, pairs[k]) > 0;
    }
  }
  std::vector<LinkPair> kept;
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    if (apart[k]) kept.push_back(pairs[k]);
  }
  return kept;
}

}  // namespace

double distance_between(const Capsule& a, const Capsule& b) {
  return segment_distance(a, b) - a.radius - b.radius;
}

std::vector<LinkPair> pairs_that_may_touch(const Robot& robot) {
  const std::vector<int> body = bodies_of(robot);
  std::vector<LinkPair> pairs;
  for (std::size_t a = 0; a < robot.links.size(); ++a) {
    for (std::size_t b = a + 1; b < robot.links.size(); ++b) {
      if (robot.links[a].capsules.empty() || robot.links[b].capsules.empty()) continue;
      const auto [low, high] = std::minmax(body[a], body[b]);
      if (!always_apart(robot, body, low, high))
        pairs.push_back({static_cast<int>(a), static_cast<int>(b)});
    }
  }
  return ever_apart(robot, pairs);
}

double link_distance(const Robot& robot, std::span<const Pose> base_from_link, LinkPair pair) {
  const auto a = static_cast<std::size_t>(pair.a), b = static_cast<std::size_t>(pair.b);
  double least = std::numeric_limits<double>::infinity();
  for (const Capsule& own : robot.links[a].capsules) {
    const Capsule first = carried(own, base_from_link[a]);
    for (const Capsule& other : robot.links[b].capsules)
      least = std::min(least, distance_between(first, carried(other, base_from_link[b])));
  }
  return least;
}

std::optional<LinkPair> first_contact(const Robot& robot,
                                      std::span<const Pose> base_from_link,
                                      std::span<const LinkPair> pairs,
                                      double margin_m) {
  for (const LinkPair& pair : pairs) {
    if (link_distance(robot, base_from_link, pair) < margin_m) return pair;
  }
  return std::nullopt;
}

}  // namespace marketgen::robots
