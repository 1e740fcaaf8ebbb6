// Mass, centre of mass and inertia of what an export lets move.
#pragma once
#include <array>
#include <vector>

#include "assets/contact_shape.h"
#include "physics/goods/goods_body.h"
#include "scene/scene.h"

namespace marketgen::exporters {

struct BodyInertia {
  double mass_kg = 0;
  Vec3 center;                            // of mass, in the owner's frame
  std::array<double, 6> moments_kg_m2{};  // about it, owner's axes: xx yy zz xy xz yz
};

// Of a solid of even density.
BodyInertia even_inertia(const assets::ContactShape& shape, double mass_kg);
// Of several as one; their masses are more than 0.
BodyInertia sum_of(const std::vector<BodyInertia>& bodies);

// In the product frame. A ball is one ellipsoid of even density.
BodyInertia inertia_of(const physics::GoodsBody& goods);
// Of what a joint moves, each part of even density (scene/articulation.h), in the joint's frame.
// `parts`: rows of Scene::parts.
BodyInertia inertia_of(const scene::Scene& scene,
                       const scene::SceneJoint& joint,
                       const std::vector<std::uint32_t>& parts);

}  // namespace marketgen::exporters
