// What a hand remembers of where it came upon something.
#include "policy/felt_contacts.h"

#include <gtest/gtest.h>

namespace marketgen {
namespace {

Pose down_at(Vec3 at, double turned_rad) {
  return {at, rotation_about({0, 0, 1}, turned_rad) * rotation_about({1, 0, 0}, 3.14159)};
}

TEST(FeltContacts, KnowGraspsThatAreNearlyTheSame) {
  const perception::ProductLook look, other;
  policy::FeltContacts felt;
  const Pose grasp = down_at({0.5, 0.1, 0.1}, 0.4);
  EXPECT_FALSE(felt.has_grasp(grasp));
  felt.note_grasp(grasp, look);
  EXPECT_TRUE(felt.has_grasp(grasp));
  EXPECT_TRUE(felt.has_grasp(down_at({0.5, 0.105, 0.1}, 0.5)));
  EXPECT_FALSE(felt.has_grasp(down_at({0.5, 0.12, 0.1}, 0.4))) << "2 cm beside";
  EXPECT_FALSE(felt.has_grasp(down_at({0.5, 0.1, 0.1}, 1.2))) << "turned by 46 degrees";
  felt.note_grasp(grasp, look);
  EXPECT_EQ(felt.count(look), 2);
  EXPECT_EQ(felt.count(other), 0);
}

TEST(FeltContacts, KnowPlacesAndForgetAll) {
  const perception::ProductLook look;
  policy::FeltContacts felt;
  felt.note_place({0.4, -0.4, 0.1});
  felt.note_grasp({}, look);
  EXPECT_TRUE(felt.has_place({0.43, -0.4, 0.1}));
  EXPECT_FALSE(felt.has_place({0.46, -0.4, 0.1}));
  felt.forget();
  EXPECT_FALSE(felt.has_place({0.4, -0.4, 0.1}));
  EXPECT_FALSE(felt.has_grasp({}));
  EXPECT_EQ(felt.count(look), 0);
}

}  // namespace
}  // namespace marketgen
