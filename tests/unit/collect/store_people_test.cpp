// People in stores: clear of everything and of one another at any time, the same for the same seed.
#include "collect/store_people.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <sstream>

#include "base/parallel.h"
#include "layout/layout.h"
#include "scene/scene.h"
#include "support/committed_catalog.h"
#include "support/hand_laid_shop.h"

namespace marketgen {
namespace {

using collect::StorePeople;

scene::Scene hand_laid_hall() {
  const HandLaidShop shop = shop_of(selling_types());
  return scene::build_scene(shop.layout, shop.plan, committed_catalog(), Seed(2)).value();
}

scene::Scene store_of_plan(const std::string& file, std::uint64_t seed) {
  std::ifstream stream(std::filesystem::path(MARKETGEN_SOURCE_DIR) / file);
  std::stringstream text;
  text << stream.rdbuf();
  const plan::Plan plan = plan::read_plan(text.str(), file, committed_catalog()).value();
  const layout::Layout laid = layout::make_layout(plan, committed_catalog(), Seed(seed)).value();
  return scene::build_scene(laid, plan, committed_catalog(), Seed(seed)).value();
}

struct NamedStore {
  std::string name;
  scene::Scene scene;
  int people;
};

const std::vector<NamedStore>& three_stores() {
  static const std::vector<NamedStore> stores = [] {
    std::vector<NamedStore> made;
    made.push_back({"hall", hand_laid_hall(), 12});
    made.push_back({"riverside", store_of_plan("tests/fixtures/plans/riverside.json", 7), 12});
    made.push_back({"corner shop", store_of_plan("examples/corner-shop.json", 4), 4});
    return made;
  }();
  return stores;
}

StorePeople people_in(const NamedStore& store) {
  auto people = StorePeople::make(store.scene, store.people, Seed(5));
  if (!people.ok()) fatal(to_string(people.error()).c_str());
  return std::move(people).value();
}

// Parts of fixtures and goods that stand lower than a person is tall, as upright boxes.
std::vector<Bounds3> things_of(const scene::Scene& scene) {
  std::vector<Bounds3> things;
  const auto add = [&](const Pose& pose, Vec3f half, Vec3f middle) {
    Bounds3 box;
    for (int k = 0; k < 8; ++k) {
      const Vec3f corner =
          middle +
          Vec3f{k & 1 ? half.x : -half.x, k & 2 ? half.y : -half.y, k & 4 ? half.z : -half.z};
      box.include(to_float(pose * to_double(corner)));
    }
    if (box.low.z < 1.9F) things.push_back(box);
  };
  for (const scene::ScenePart& part : scene.parts) {
    const auto& [x, y, z] = part.half_size_m;
    add(scene::world_from_fixture(scene, part.fixture) * scene::fixture_from_part(part),
        {x, y, z},
        {});
  }
  return things;
}

double nearest_thing(const std::vector<Bounds3>& things, Vec2 at) {
  double least = 1e9;
  for (const Bounds3& box : things) {
    const double dx = std::max({box.low.x - at.x, at.x - box.high.x, 0.0});
    const double dy = std::max({box.low.y - at.y, at.y - box.high.y, 0.0});
    least = std::min(least, std::hypot(dx, dy));
  }
  return least;
}

TEST(StorePeople, StandInNothingForARound) {
  for (const NamedStore& store : three_stores()) {
    const StorePeople people = people_in(store);
    ASSERT_EQ(people.count(), static_cast<std::size_t>(store.people)) << store.name;
    const std::vector<Bounds3> things = things_of(store.scene);
    for (double t = 0; t < collect::round_s; t += 0.5) {
      for (std::size_t i = 0; i < people.count(); ++i) {
        const Vec2 at = people.place(i, t).position;
        // A basket reaches 0.49 m; the feet of who walks stay on the way.
        EXPECT_GT(nearest_thing(things, at), 0.495) << store.name << " " << i << " at " << t;
      }
    }
  }
}

TEST(StorePeople, NeverComeIntoOneAnother) {
  for (const NamedStore& store : three_stores()) {
    const StorePeople people = people_in(store);
    for (double t = 0; t < 2 * collect::round_s; t += 0.13) {
      for (std::size_t i = 0; i < people.count(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
          const Vec2 a = people.place(i, t).position, b = people.place(j, t).position;
          EXPECT_GE(std::hypot(a.x - b.x, a.y - b.y), people.room_m(i, t) + people.room_m(j, t))
              << store.name << " " << i << " and " << j << " at " << t;
        }
      }
    }
  }
}

TEST(SlowStorePeople, KeepToTheirRoom) {  // body, clothes and what they carry, in every kind of act
  const StorePeople people = people_in(three_stores()[1]);
  for (std::size_t i = 0; i < 7; ++i) {
    for (const double t : {3.0, 31.7, 84.9}) {
      const assets::PlacedPerson person = people.person(i, t);
      double reach = 0;
      for (const assets::PersonPart& part :
           assets::person_parts(person.look, person.pose, assets::PersonDetail::far)) {
        for (const Vec3f& p : part.mesh.positions)
          reach = std::max(reach, std::hypot(static_cast<double>(p.x), static_cast<double>(p.y)));
      }
      EXPECT_LT(reach, people.room_m(i, t)) << i << " at " << t;
    }
  }
}

TEST(StorePeople, WalkWithoutAJumpAndNoFasterThanPeopleDo) {
  constexpr double dt = 0.02;
  double fastest = 0;
  for (const NamedStore& store : three_stores()) {
    const StorePeople people = people_in(store);
    for (std::size_t i = 0; i < people.count(); ++i) {
      for (double t = 0; t < collect::round_s + 1; t += dt) {
        const assets::WayPlace a = people.place(i, t), b = people.place(i, t + dt);
        const double moved = std::hypot(a.position.x - b.position.x, a.position.y - b.position.y);
        fastest = std::max(fastest, moved / dt);
        EXPECT_LT(std::abs(std::remainder(a.heading_rad - b.heading_rad, 2 * std::numbers::pi)),
                  0.2)
            << i;
      }
    }
  }
  EXPECT_LE(fastest, collect::max_walk_m_s * 1.02);
  EXPECT_GT(fastest, collect::min_walk_m_s);  // somebody walks
}

// A path may touch a corner where it begins or ends: that point comes twice.
TEST(FloorWay, APointThatComesTwiceIsNoStep) {
  navigation::FloorPath path;
  path.points = {{0, 0}, {0, 0}, {1000, 0}, {1000, 500}, {1000, 500}};
  const collect::FloorWay way(path);
  EXPECT_DOUBLE_EQ(way.length_m(), 1.5);
  for (double s = 0; s <= 1.5; s += 0.1) {
    const assets::WayPlace at = way.at(s);
    EXPECT_TRUE(std::isfinite(at.position.x + at.position.y + at.heading_rad)) << s;
  }
  EXPECT_NEAR(way.at(1.5).position.y, 0.5, 1e-9);
}

TEST(StorePeople, BeginTheirRoundsAnew) {
  const StorePeople people = people_in(three_stores()[0]);
  for (std::size_t i = 0; i < people.count(); ++i) {
    for (const double t : {0.0, 17.3, 61.0}) {
      const assets::WayPlace a = people.place(i, t), b = people.place(i, t + 3 * collect::round_s);
      EXPECT_NEAR(a.position.x, b.position.x, 1e-9);
      EXPECT_NEAR(a.position.y, b.position.y, 1e-9);
    }
  }
}

TEST(StorePeople, MoreOfThemChangeNobody) {
  const NamedStore& store = three_stores()[0];
  const StorePeople few = StorePeople::make(store.scene, 4, Seed(5)).value();
  const StorePeople many = StorePeople::make(store.scene, 9, Seed(5)).value();
  for (std::size_t i = 0; i < few.count(); ++i) {
    EXPECT_EQ(few.round(i).look.stature_m, many.round(i).look.stature_m);
    const Vec2 a = few.place(i, 44).position, b = many.place(i, 44).position;
    EXPECT_EQ(a.x, b.x);
    EXPECT_EQ(a.y, b.y);
  }
}

TEST(StorePeople, AreTheSameForAnyNumberOfThreads) {
  const NamedStore& store = three_stores()[1];
  const auto places = [&](int threads) {
    const ThreadLimit limit(threads);
    const StorePeople people = people_in(store);
    std::vector<double> numbers;
    for (std::size_t i = 0; i < people.count(); ++i) {
      numbers.push_back(people.place(i, 12.5).position.x);
      numbers.push_back(people.place(i, 12.5).heading_rad);
    }
    return numbers;
  };
  EXPECT_EQ(places(1), places(4));
}

TEST(StorePeople, SomeAreStaff) {
  const StorePeople people = people_in(three_stores()[0]);
  int staff = 0;
  for (std::size_t i = 0; i < people.count(); ++i)
    staff += people.round(i).look.role == assets::PersonRole::staff ? 1 : 0;
  EXPECT_EQ(staff, 2);  // of twelve
}

TEST(StorePeople, AsManyAsTheFloorHolds) {
  const NamedStore& shop = three_stores()[2];
  const auto crowd = StorePeople::make(shop.scene, collect::max_people, Seed(5));
  ASSERT_FALSE(crowd.ok());
  EXPECT_EQ(crowd.error().code, "people.no_room");
  EXPECT_EQ(StorePeople::make(shop.scene, -1, Seed(5)).error().code, "usage.bad_flag");
  EXPECT_EQ(StorePeople::make(shop.scene, 0, Seed(5)).value().count(), 0U);
}

}  // namespace
}  // namespace marketgen
