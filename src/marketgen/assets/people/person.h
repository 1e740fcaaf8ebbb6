// People as they stand in a store: what one looks like, how one holds oneself, and the meshes of
// both. Bodies are made of soft shapes from published body measures; nobody in particular is shown.
//
// Person frame: origin on the floor below the pelvis, X ahead, Y to the person's left, Z up.
// Metres.
//
// Sources of measures:
//   statures: ANSUR II (Gordon et al. 2014, NATICK/TR-15/007): men 1756 mm (sigma 69), women 1628
//   mm (sigma 64); segment lengths as shares of stature: Drillis and Contini 1966, in Winter,
//   "Biomechanics and Motor Control of Human Movement" (4th edition, figure 4.1); loss with age:
//   Sorkin, Muller and Andres 1999, about 3 cm (men) and 5 cm (women) by 70; head, neck, hand and
//   foot breadths: ANSUR II.
#pragma once
#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "base/seed.h"
#include "geometry/mesh.h"
#include "geometry/pose.h"

namespace marketgen::assets {

inline constexpr double min_stature_m = 1.50, max_stature_m = 1.95;

enum class PersonRole { shopper, staff };
constexpr std::array<std::string_view, 2> names_of(PersonRole) {
  return {"shopper", "staff"};
}
enum class BodyForm { man, woman };  // whose measures
enum class HairCut { bald, cropped, short_hair, bob, long_hair, bun };
enum class TopWear { t_shirt, shirt, jacket, coat };
enum class LegWear { trousers, skirt };

// Colours are linear RGB.
struct PersonLook {
  PersonRole role = PersonRole::shopper;
  BodyForm form = BodyForm::man;
  int age = 40;
  double stature_m = 1.75;  // without shoes; min_stature_m to max_stature_m
  double girth = 1;         // of trunk and limbs; 1: the mean, 0.88 to 1.25
  double face_width = 1, nose = 1, jaw = 1, brow = 1;  // shares of the mean, 0.8 to 1.25
  HairCut hair = HairCut::short_hair;
  bool beard = false;
  TopWear top = TopWear::shirt;
  LegWear legs = LegWear::trousers;
  bool apron = false;
  Vec3f skin, hair_color, top_color, leg_color, shoe_color, apron_color, basket_color;
};

// Anybody: measures, skin, hair and clothes drawn from `seed`. Staff wear a white or grey shirt and
// an apron in `house_color` (linear RGB).
PersonLook draw_person(PersonRole role, Vec3f house_color, Seed seed);

// Where a shoe stands: the point of its sole under the ball of the foot.
struct FootPlace {
  Vec3 ball;             // person frame
  double yaw_rad = 0;    // toes to the left
  double pitch_rad = 0;  // heel up, turned about the ball; less than 0: toes up
  double toe_rad = 0;    // how far the toes are bent up from the sole
};
enum class ArmUse {
  hang,    // and swings
  basket,  // a shopping basket hangs from the hand
  rest,    // the hand before the belly
  carry    // both hands before the chest, round a box when both arms do
};
struct PersonPose {
  std::array<FootPlace, 2> feet;            // left, right
  std::array<double, 2> arm_forward_rad{};  // of the upper arm from hanging down
  std::array<ArmUse, 2> arms{};
  double head_left_rad = 0, head_down_rad = 0;
  double lean_rad = 0;  // of the trunk, ahead
};
// At ease on both feet.
PersonPose standing_pose(const PersonLook& look);

// How far a foot's places lie from one another.
struct FootMeasures {
  double ankle_behind_ball_m, heel_behind_ball_m, toes_before_ball_m;
  double ankle_height_m;
  double hip_height_m;  // of a person who stands upright
};
FootMeasures foot_measures(const PersonLook& look);

// One closed mesh of one colour.
struct PersonPart {
  std::string name;  // "head", "top"
  Mesh mesh;         // person frame; one surface, 0
  Vec3f color;       // linear RGB
  float roughness = 0.8F;
  float scatter_m = 0;  // how far light wanders below the surface
};

// near: for eyes a metre away; far: a quarter of the triangles; coarse: a twentieth, for pictures
// of a robot's camera while people walk.
enum class PersonDetail { near, far, coarse };

// The whole person, about 200,000 triangles (near) in about a second of one core. Deterministic.
std::vector<PersonPart> person_parts(const PersonLook& look,
                                     const PersonPose& pose,
                                     PersonDetail detail = PersonDetail::near);

// Somebody in a place, as pictures and worlds take it.
struct PlacedPerson {
  PersonLook look;
  PersonPose pose;
  Pose world_from_person;  // upright; store frame
};

}  // namespace marketgen::assets
