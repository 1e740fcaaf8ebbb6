#include "export/body_inertia.h"

#include <Eigen/Dense>

#include "physics/goods/contact_shape.h"
#include "scene/articulation.h"

namespace marketgen::exporters {
namespace {

// Along the shape's own axes, for 1 kg.
Eigen::Vector3d unit_moments(const assets::ContactShape& shape) {
  const Vec3& s = shape.size;
  if (shape.shape == assets::CollisionShape::cylinder) {
    const double across = s.x * s.x / 4 + s.y * s.y / 3;
    return {across, across, s.x * s.x / 2};
  }
  const double share = shape.shape == assets::CollisionShape::box ? 1.0 / 3 : 1.0 / 5;
  const double x = s.x * s.x, y = s.y * s.y, z = s.z * s.z;
  return {share * (y + z), share * (x + z), share * (x + y)};
}

Eigen::Matrix3d tensor_of(const std::array<double, 6>& m) {
  Eigen::Matrix3d tensor;
  tensor << m[0], m[3], m[4], m[3], m[1], m[5], m[4], m[5], m[2];
  return tensor;
}

std::array<double, 6> moments_of(const Eigen::Matrix3d& t) {
  return {t(0, 0), t(1, 1), t(2, 2), t(0, 1), t(0, 2), t(1, 2)};
}

}  // namespace

BodyInertia even_inertia(const assets::ContactShape& shape, double mass_kg) {
  const Quaternion& q = shape.pose.rotation;
  const Eigen::Matrix3d axes = Eigen::Quaterniond(q.w, q.x, q.y, q.z).normalized().matrix();
  const Eigen::Matrix3d tensor =
      mass_kg * axes * unit_moments(shape).asDiagonal() * axes.transpose();
  return {mass_kg, shape.pose.position, moments_of(tensor)};
}

BodyInertia sum_of(const std::vector<BodyInertia>& bodies) {
  BodyInertia sum;
  for (const BodyInertia& body : bodies) {
    sum.mass_kg += body.mass_kg;
    sum.center = sum.center + body.center * body.mass_kg;
  }
  sum.center = sum.center * (1 / sum.mass_kg);
  Eigen::Matrix3d tensor = Eigen::Matrix3d::Zero();
  for (const BodyInertia& body : bodies) {
    const Vec3 off = body.center - sum.center;
    const Eigen::Vector3d d(off.x, off.y, off.z);
    const Eigen::Matrix3d moved = d.squaredNorm() * Eigen::Matrix3d::Identity() - d * d.transpose();
    tensor += tensor_of(body.moments_kg_m2) + body.mass_kg * moved;
  }
  sum.moments_kg_m2 = moments_of(tensor);
  return sum;
}

BodyInertia inertia_of(const physics::GoodsBody& goods) {
  if (goods.form == physics::GoodsForm::ball)
    return even_inertia(assets::contact_shape_of(goods.body.pieces.front()), goods.product.mass_kg);
  const std::array<float, 6>& m = goods.body.inertia_kg_m2;
  return {goods.product.mass_kg,
          to_double(goods.body.center_of_mass),
          {m[0], m[1], m[2], m[3], m[4], m[5]}};
}

BodyInertia inertia_of(const scene::Scene& scene,
                       const scene::SceneJoint& joint,
                       const std::vector<std::uint32_t>& parts) {
  const std::vector<double> masses = scene::masses_of(scene, joint, parts);
  const Pose joint_from_fixture = inverse(scene::fixture_from_joint(joint));
  std::vector<BodyInertia> bodies;
  for (std::size_t i = 0; i < parts.size(); ++i)
    bodies.push_back(even_inertia(
        joint_from_fixture * physics::contact_shape_of(scene.parts[parts[i]]), masses[i]));
  return sum_of(bodies);
}

}  // namespace marketgen::exporters
