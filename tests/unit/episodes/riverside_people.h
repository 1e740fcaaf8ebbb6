// People in the aisles of one store, for tests.
#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <memory>
#include <sstream>

#include "collect/drive_graph.h"
#include "episodes/aisle/aisle_store.h"
#include "episodes/aisle/people_around.h"
#include "layout/layout.h"
#include "support/committed_catalog.h"

namespace marketgen::people_test {

using episodes::FloorDisc;
using episodes::PeopleAround;

inline constexpr double dt = 0.05;
inline constexpr double bodies_m = 2 * episodes::person_radius_m;

inline scene::Scene riverside_scene() {
  const std::string file = "tests/fixtures/plans/riverside.json";
  std::ifstream stream(std::filesystem::path(MARKETGEN_SOURCE_DIR) / file);
  std::stringstream text;
  text << stream.rdbuf();
  const plan::Plan plan = plan::read_plan(text.str(), file, committed_catalog()).value();
  const layout::Layout laid = layout::make_layout(plan, committed_catalog(), Seed(7)).value();
  return scene::build_scene(laid, plan, committed_catalog(), Seed(7)).value();
}

inline std::shared_ptr<const episodes::AisleStore> riverside() {
  static const std::shared_ptr<const episodes::AisleStore> store = [] {
    auto opened = episodes::open_aisle_store(std::filesystem::path(MARKETGEN_SOURCE_DIR) / "data",
                                             riverside_scene());
    if (!opened.ok()) fatal(to_string(opened.error()).c_str());
    return std::move(opened).value();
  }();
  return store;
}

// So many, where they find room; a robot far away.
inline PeopleAround people_of(int count, Vec2 robot = {-9, -9}, std::uint64_t seed = 3) {
  const double free_m2 = collect::free_floor_m2(riverside()->scene, 2.0);
  auto made = PeopleAround::make(riverside()->scene, (count + 0.5) / free_m2, Seed(seed), robot);
  if (!made.ok()) fatal(to_string(made.error()).c_str());
  return std::move(made).value();
}

inline double apart(Vec2 a, Vec2 b) {
  return std::hypot(a.x - b.x, a.y - b.y);
}

inline double min_apart(const PeopleAround& people) {
  double least = 1e9;
  for (std::size_t i = 0; i < people.count(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      least = std::min(least, apart(people.place(i), people.place(j)));
  return least;
}

inline double gap_to(const FloorDisc& robot, Vec2 person) {
  return apart(robot.at, person) - robot.radius_m - episodes::person_radius_m;
}

}  // namespace marketgen::people_test
