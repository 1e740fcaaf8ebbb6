// The fields of a person's parts (implicit_mesh.h), each with its bounds and how fine its cells
// are.
#pragma once
#include <string>
#include <vector>

#include "assets/people/implicit_mesh.h"
#include "assets/people/person_frame.h"
#include "assets/people/soft_shapes.h"

namespace marketgen::assets {

struct PartField {
  std::string name;
  Field field;     // person frame
  Bounds3 bounds;  // with room all round
  float cell_m;    // for eyes a metre away
  Vec3f color;
  float roughness = 0.8F;
  float scatter_m = 0;
};

// Skin, hair, brows, eyes and lips.
std::vector<PartField> head_fields(const PersonLook& look, const PersonFrame& frame);
// Hands and what of arms and legs is bare.
std::vector<PartField> limb_fields(const PersonLook& look,
                                   const PersonPose& pose,
                                   const PersonFrame& frame);
// Clothes and shoes, and what is worn over them.
std::vector<PartField> clothes_fields(const PersonLook& look, const PersonFrame& frame);
// What the hands carry.
std::vector<PartField> carried_fields(const PersonLook& look,
                                      const PersonPose& pose,
                                      const PersonFrame& frame);

// Naked shapes that clothes are cut after, each `over` metres outside the skin.
class TrunkField {
 public:
  TrunkField(const PersonLook& look, const PersonFrame& frame, float over);
  float operator()(Vec3f p) const;

 private:
  std::vector<Girth> girths_;
  std::array<Vec3f, 2> neck_, shoulder_, bust_;
  float unit_, neck_radius_, shoulder_radius_;
  float bust_radius_;  // 0: none
};
float arm_field(Vec3f p, const PersonFrame& frame, std::size_t arm, float over);
float leg_field(Vec3f p, const PersonFrame& frame, std::size_t leg, float over);

// Around points, `margin` metres wider.
Bounds3 bounds_round(std::initializer_list<Vec3f> points, float margin);

}  // namespace marketgen::assets
