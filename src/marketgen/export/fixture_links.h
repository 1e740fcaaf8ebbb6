// The rigid bodies of which a fixture is made up, for formats that have links and joints.
#pragma once
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "geometry/pose.h"
#include "scene/scene.h"

namespace marketgen::exporters {

// A hinge that turns further has no limits in formats that have a word for that.
constexpr double endless_hinge_rad = 8 * 3.14159265358979;

// A fixture's own body, or what one joint moves. The link's frame is the joint's: it moves about or
// along Z; the body's is the fixture's.
struct FixtureLink {
  int joint = -1;  // row in Scene::joints; -1: the fixture's body
  Pose fixture_from_link;
  std::vector<std::uint32_t> parts;  // rows in Scene::parts
};

// The fixture's own body first, parents before children. `still_fixtures`: the body alone, with all
// parts.
std::vector<FixtureLink> fixture_links(const scene::Scene& scene,
                                       std::uint32_t fixture,
                                       bool still_fixtures);

// What moves the link; not of the fixture's own body.
const scene::SceneJoint& joint_of(const scene::Scene& scene, const FixtureLink& link);
// Whether the link moves in its fixture. A belt stands still: it carries what lies on it.
bool moves(const scene::Scene& scene, const FixtureLink& link);

// "<unit>-<n>", unique in its fixture.
std::string part_name(const scene::Scene& scene, std::uint32_t part);
// "<fixture id>/<part>", unique in the store.
std::string part_id(const scene::Scene& scene, std::uint32_t part);
// The factor of x^3 in the spring's force -k x - factor x^3.
double hold_open_factor(const scene::SceneJoint& joint);
// Wheels: engines take limits of no more than two turns.
bool turns_endlessly(const scene::SceneJoint& joint);
// The limits of a joint that has none.
constexpr double no_upper_limit = std::numeric_limits<double>::infinity();
constexpr double no_lower_limit = -no_upper_limit;

}  // namespace marketgen::exporters
