// Which links of a robot may touch one another, and whether they do: exact distances between the
// capsules of its links.
//
// Poses are base_from_link of every link, as forward_kinematics() writes them. No errors.
#pragma once
#include <optional>
#include <span>
#include <vector>

#include "robots/robot.h"

namespace marketgen::robots {

// Of the surfaces; negative where they overlap, down to minus the sum of the radii. Metres.
double distance_between(const Capsule& a, const Capsule& b);

struct LinkPair {
  int a = 0, b = 0;  // a < b
  friend bool operator==(const LinkPair&, const LinkPair&) = default;
};

// The pairs of links with capsules to check, in order. Left out are pairs that cannot move against
// one another, neighbours across one joint (the joint's limits keep those apart), links of joints
// that follow one another (a gripper's fingers meet when it closes), and pairs that overlap in
// every one of 500 postures over the limits: their capsules are wider than the bodies.
std::vector<LinkPair> pairs_that_may_touch(const Robot& robot);

// Between the capsules of two links; infinity when one has none.
double link_distance(const Robot& robot, std::span<const Pose> base_from_link, LinkPair pair);

// The first of `pairs` nearer than `margin_m`.
std::optional<LinkPair> first_contact(const Robot& robot,
                                      std::span<const Pose> base_from_link,
                                      std::span<const LinkPair> pairs,
                                      double margin_m = 0);

}  // namespace marketgen::robots
