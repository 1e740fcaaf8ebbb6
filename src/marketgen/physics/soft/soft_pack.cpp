#include "physics/soft/soft_pack.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/gravity.h"
#include "geometry/solid.h"

namespace marketgen::physics {
namespace {

// ---- The flap ----

// Fingers press flat what lies behind the seal: the wedge there has little in it. A Panda's pad is
// as long.
constexpr double flap_reach_m = 0.020, max_of_length = 0.15;
constexpr double longest_seam = 0.35;  // of the pack: a longer one is no flap
constexpr double at_end_m = 0.002;     // as near to the box's end is at it
// Two layers of laminate are 0.3 mm; a finger at 0.1 m/s would come out on the far side of a box as
// thin.
constexpr double thinnest_half_m = 0.0015;
// So that the flap clears what the halves stand on.
constexpr double set_in_m = 0.001;
// Film and what of the contents moves with it. Film alone is 0.5 % of a bag; contact with a body as
// light beside what hangs on it is too yielding to hold.
constexpr double flap_mass_share = 0.03;
// Bending stiffness of sealed laminate, E t^3 / 12 (1 - v^2): two layers of PET 12 um / PE 80 to
// 120 um, t = 0.26 mm in all, E = 0.6 GPa (LDPE 0.2, PET 4 GPa by their share; Ashby, "Materials
// Selection in Mechanical Design").
constexpr double film_stiffness_n_m = 1e-3;
// As the flap is heavier than film, its spring bears at least so many times what it weighs on its
// hinge: level, it hangs down by a quarter of a radian, and upright it stands.
constexpr double flap_stiffness_share = 4;
// A bent flap needs as long to come back to a third: film creeps, and creases.
constexpr double flap_return_s = 0.25;
constexpr double flap_limit_rad = 1.7;  // lies back on the pack

// ---- The halves ----

// Of the product's mesh, for its middle: within a millimetre of what make_product_body() finds with
// sixteen times as many, which takes 50 ms.
constexpr int mass_columns = 40;
// Each half has at least this share, however much lies at one end.
constexpr double min_share = 0.15;
// The spring bears so many times the moment with which the heavier half weighs on the hinge when
// the pack is held level by the other: it then sags by a quarter of a radian, 14 degrees. Less than
// once, and a standing bag would fold under its own weight.
constexpr double core_stiffness_share = 4;
// Of critical damping: loose filling grinds, and a bag that is dropped does not ring.
constexpr double core_damping = 0.7;
constexpr double core_limit_rad = 0.8;

double& along(Vec3& v, int axis) {
  return axis == 0 ? v.x : axis == 1 ? v.y : v.z;
}
double along(const Vec3& v, int axis) {
  return axis == 0 ? v.x : axis == 1 ? v.y : v.z;
}
Vec3 unit_along(int axis, double length = 1) {
  Vec3 v;
  along(v, axis) = length;
  return v;
}

// A seam at the end of the pack, in the pack's frame.
struct EndSeam {
  int axis = 0;     // along which the pack ends
  double side = 1;  // the end in +axis or -axis
  Vec3 center, half;
  int thin = 0, wide = 0;  // the other two axes
};

std::optional<EndSeam> end_seam(const assets::PackFeature& feature,
                                const assets::CollisionPrimitive& box) {
  EndSeam seam;
  seam.center = to_double(feature.center) - to_double(box.center);
  seam.half = to_double(feature.half_size);
  const Vec3 pack = to_double(box.half_size);
  const auto ends = [&](int axis, double side) {
    const double reach = side * along(seam.center, axis) + along(seam.half, axis);
    return std::abs(reach - along(pack, axis)) < at_end_m &&
           along(seam.half, axis) < longest_seam * along(pack, axis);
  };
  // It stands on -Z, and lies against its neighbours in front and behind.
  constexpr std::array<std::pair<int, double>, 3> where{{{2, 1.0}, {0, -1.0}, {0, 1.0}}};
  for (const auto& [axis, side] : where) {
    if (!ends(axis, side)) continue;
    seam.axis = axis, seam.side = side;
    const int one = (axis + 1) % 3, other = (axis + 2) % 3;
    const bool one_thin = along(seam.half, one) < along(seam.half, other);
    seam.thin = one_thin ? one : other, seam.wide = one_thin ? other : one;
    return seam;
  }
  return {};
}

std::optional<EndSeam> seam_of(const assets::ProductModel& model) {
  for (const assets::PackFeature& feature : model.features) {
    if (feature.kind != assets::FeatureKind::seam) continue;
    if (const auto seam = end_seam(feature, model.collision)) return seam;
  }
  return {};
}

// Where along the pack the flap begins, counted from its middle towards the seam.
double flap_root(const EndSeam& seam, double half_length) {
  const double reach = std::min(flap_reach_m, max_of_length * 2 * half_length);
  return half_length - std::max(2 * along(seam.half, seam.axis), reach);
}

// `middle`: where the middle of mass lies, counted from that of the box towards the seam.
std::array<SoftPart, SoftPack::part_count> parts_of(const EndSeam& seam,
                                                    Vec3 half,
                                                    double mass,
                                                    double middle) {
  const double end = along(half, seam.axis), root = flap_root(seam, end);
  const double length = end + root;  // of both halves
  const auto part = [&](double from, double to) {
    SoftPart made{unit_along(seam.axis, seam.side * (from + to) / 2), half};
    along(made.half_size, seam.axis) = (to - from) / 2;
    return made;
  };
  SoftPart base = part(-end, -end + length / 2), top = part(-end + length / 2, root);
  SoftPart flap = part(root, end);
  for (const int across : {seam.thin, seam.wide})
    along(flap.center, across) = along(seam.center, across);
  along(flap.half_size, seam.thin) = std::max(along(seam.half, seam.thin), thinnest_half_m);
  along(flap.half_size, seam.wide) = along(seam.half, seam.wide) - set_in_m;
  flap.mass_kg = flap_mass_share * mass;
  const double rest = mass - flap.mass_kg;
  const double flap_at = (root + end) / 2, base_at = -end + length / 4;
  const double moment = mass * middle - flap.mass_kg * flap_at - rest * base_at;
  top.mass_kg = std::clamp(moment / (length / 2), min_share * mass, rest - min_share * mass);
  base.mass_kg = rest - top.mass_kg;
  return {base, top, flap};
}

// It bends across the thinner of the two ways.
SoftHinge core_hinge(const EndSeam& seam, const SoftPart& base, const SoftPart& top) {
  const int one = (seam.axis + 1) % 3, other = (seam.axis + 2) % 3;
  const int wide = along(top.half_size, one) > along(top.half_size, other) ? one : other;
  const double arm = along(top.half_size, seam.axis);
  const double heavier = std::max(base.mass_kg, top.mass_kg);
  const double stiffness = core_stiffness_share * heavier * standard_gravity * arm;
  const double inertia = heavier * 4 * arm * arm / 3;
  const double root = along(base.half_size, seam.axis);
  return {base.center + unit_along(seam.axis, seam.side * root),
          unit_along(wide),
          stiffness,
          core_damping * 2 * std::sqrt(stiffness * inertia),
          core_limit_rad};
}

SoftHinge flap_hinge(const EndSeam& seam, const SoftPart& flap) {
  const double length = 2 * along(flap.half_size, seam.axis);
  const double width = 2 * along(flap.half_size, seam.wide);
  const double weight = flap.mass_kg * standard_gravity * length / 2;
  const double stiffness =
      std::max(film_stiffness_n_m * width / length, flap_stiffness_share * weight);
  return {flap.center - unit_along(seam.axis, seam.side * length / 2),
          unit_along(seam.wide),
          stiffness,
          stiffness * flap_return_s,
          flap_limit_rad};
}

Result<void> check_row(const catalog::Product& product) {
  const auto& size = product.size_mm;
  const bool sized = size[0] > 0 && size[1] > 0 && size[2] > 0;
  if (product.mass_kg > 0 && std::isfinite(product.mass_kg) && sized) return {};
  return Error{
      "catalog.bad_row",
      product.sku,
      fmt::format("a soft pack needs a mass and a size greater than 0; it has {} kg and {} "
                  "x {} x {} mm",
                  product.mass_kg,
                  size[0],
                  size[1],
                  size[2])};
}

}  // namespace

bool may_be_soft_pack(const catalog::Product& product) {
  return product.rigidity == catalog::Rigidity::soft &&
         (product.material == "film" || product.material == "foil");
}

Result<std::optional<SoftPack>> soft_pack_of(const catalog::Product& product) {
  if (!may_be_soft_pack(product)) return std::optional<SoftPack>();
  MARKETGEN_CHECK(check_row(product));
  MARKETGEN_TRY(const assets::ProductModel model, assets::make_product_model(product));
  const std::optional<EndSeam> seam = seam_of(model);
  if (!seam || model.collision.shape != assets::CollisionShape::box)
    return std::optional<SoftPack>();
  SoftPack pack;
  const Vec3 filled = Solid(model.mesh, mass_columns).mass_properties().centroid;
  const Vec3 off = filled - to_double(model.collision.center);
  pack.parts = parts_of(*seam,
                        to_double(model.collision.half_size),
                        product.mass_kg,
                        seam->side * along(off, seam->axis));
  pack.hinges = {core_hinge(*seam, pack.parts[0], pack.parts[1]), flap_hinge(*seam, pack.parts[2])};
  return std::optional(pack);
}

SoftPack plain_soft_pack() {
  SoftPack pack;
  pack.parts = {{{{0, 0, -0.08}, {0.1, 0.05, 0.07}, 0.5},
                 {{0, 0, 0.06}, {0.1, 0.05, 0.07}, 0.5},
                 {{0, 0, 0.14}, {0.1, 0.001, 0.01}, 0.03}}};
  pack.hinges = {
      {{{0, 0, -0.01}, {1, 0, 0}, 1, 0.1, 0.8}, {{0, 0, 0.13}, {1, 0, 0}, 0.01, 0.01, 1}}};
  return pack;
}

}  // namespace marketgen::physics
