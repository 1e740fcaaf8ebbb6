#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include "base/text.h"
#include "export/exporter.h"
#include "export/fixture_links.h"
#include "export/read_goods.h"
#include "physics/goods/contact_shape.h"
#include "physics/goods/standing_goods.h"
#include "physics/world/shell_pieces.h"
#include "scene/articulation.h"

namespace marketgen::exporters {
namespace {

constexpr double position_tolerance_m = 1e-4;  // the promise of check_export: 0.1 mm
constexpr double turn_tolerance_rad = 0.01 * std::numbers::pi / 180;
constexpr double bounds_tolerance_m =
    2e-3;  // fixtures reach past the walls in no store, so this is all about walls

std::string counted(std::uint64_t count, std::string_view what) {
  return fmt::format("{} {}", with_thousands(static_cast<std::int64_t>(count)), what);
}

Bounds3 bounds_of(const scene::Scene& scene) {
  Bounds3 bounds;
  for (const physics::ShellPiece& piece : physics::shell_pieces(scene.layout.shell)) {
    include_solid(bounds, {assets::CollisionShape::box, piece.pose, piece.half_size});
  }
  for (const scene::ScenePart& part : scene.parts) {
    include_solid(bounds,
                  scene::world_from_fixture(scene, part.fixture) * physics::contact_shape_of(part));
  }
  return bounds;
}

// The first id of `wanted` that `found` lacks; empty when it has all.
std::string first_missing(const std::set<std::string>& wanted, const std::set<std::string>& found) {
  const auto missing =
      std::ranges::find_if(wanted, [&](const std::string& id) { return !found.contains(id); });
  return missing == wanted.end() ? "" : *missing;
}

Result<void> compare_fixtures(const scene::Scene& scene,
                              const std::set<std::string>& found,
                              const std::string& where) {
  std::set<std::string> wanted;
  for (std::size_t i = 0; i < scene.fixtures.size(); ++i) {
    if (scene.fixtures[i].part_count > 0) wanted.insert(scene.layout.fixtures[i].id);
  }
  if (const std::string id = first_missing(wanted, found); !id.empty())
    return mismatch(where, "fixture \"" + id + "\" is missing");
  if (const std::string id = first_missing(found, wanted); !id.empty())
    return mismatch(where, "the scene has no fixture \"" + id + "\"");
  return {};
}

// By its sine: turn_between() takes an arc cosine, which single precision spoils below 0.03
// degrees.
double turn_between_rad(const Quaternion& a, const Quaternion& b) {
  const Quaternion apart = inverse(a) * b;
  return 2 * std::atan2(length(Vec3{apart.x, apart.y, apart.z}), std::abs(apart.w));
}

Result<void> compare_turn(const scene::SceneProduct& product,
                          const ExportedItem& found,
                          const std::string& where) {
  if (!found.rotation) return {};
  const double turn =
      turn_between_rad(scene::world_from_product(product).rotation, *found.rotation);
  if (turn <= turn_tolerance_rad) return {};
  return mismatch(where,
                  fmt::format("product \"{}\" is turned by {:.3f} degrees from its place",
                              found.id,
                              turn * 180 / std::numbers::pi));
}

// What differs between the two, or nothing.
std::string difference(const assets::ContactShape& wanted, const assets::ContactShape& found) {
  if (wanted.shape != found.shape) return "shape";
  if (!(length(wanted.size - found.size) <= position_tolerance_m)) return "size";
  if (!(length(wanted.pose.position - found.pose.position) <= position_tolerance_m)) return "place";
  return turn_between_rad(wanted.pose.rotation, found.pose.rotation) <= turn_tolerance_rad ? ""
                                                                                           : "turn";
}

Result<void> compare_parts(const scene::Scene& scene,
                           const ExportContents& contents,
                           const std::string& where) {
  if (!contents.parts) return {};
  if (contents.parts->size() != scene.parts.size())
    return mismatch(where,
                    fmt::format("{} of fixtures, the scene has {}",
                                counted(contents.parts->size(), "parts"),
                                scene.parts.size()));
  for (std::uint32_t row = 0; row < scene.parts.size(); ++row) {
    const std::uint32_t fixture = scene.parts[row].fixture;
    const std::string name = part_id(scene, row);
    const auto found = contents.parts->find(name);
    if (found == contents.parts->end())
      return mismatch(where, fmt::format("part \"{}\" is missing", name));
    const assets::ContactShape wanted =
        scene::world_from_fixture(scene, fixture) * physics::contact_shape_of(scene.parts[row]);
    if (const std::string what = difference(wanted, found->second); !what.empty())
      return mismatch(where, fmt::format("part \"{}\" has another {}", name, what));
  }
  return {};
}

// Of every SKU of which the file has items.
Result<void> compare_goods(const scene::Scene& scene,
                           const ExportContents& contents,
                           const std::string& where) {
  if (!contents.goods) return {};
  constexpr double relative = 1e-5;  // files hold single precision
  std::map<std::string_view, const catalog::Product*> by_sku;
  for (const catalog::Product& product : scene.catalog)
    by_sku.emplace(product.sku, &product);
  for (const ExportedGoods& goods : *contents.goods) {
    const auto product = by_sku.find(goods.sku);
    if (product == by_sku.end()) return mismatch(where, "the scene has no \"" + goods.sku + "\"");
    MARKETGEN_TRY(const physics::StandingGoods wanted, physics::standing_goods(*product->second));
    if (!(std::abs(goods.mass_kg - wanted.mass_kg) <= relative * wanted.mass_kg))
      return mismatch(where, "\"" + goods.sku + "\" has another mass");
    if (!(std::abs(goods.friction - wanted.contact.sliding) <= relative))
      return mismatch(where, "\"" + goods.sku + "\" has another friction");
    const std::string what = goods.solid ? difference(wanted.shape, *goods.solid) : "";
    if (!what.empty())
      return mismatch(where, fmt::format("the solid of \"{}\" has another {}", goods.sku, what));
  }
  return {};
}

// Largest distance of a product from its place. Every product of the scene must occur just once, as
// the right SKU.
Result<double> compare_products(const scene::Scene& scene,
                                const std::vector<ExportedItem>& found,
                                const std::string& where) {
  if (found.size() != scene.products.size()) {
    return mismatch(where,
                    "the file holds " + counted(found.size(), "products") + ", the scene " +
                        counted(scene.products.size(), "products"));
  }
  std::map<std::string_view, const ExportedItem*> by_id;
  for (const ExportedItem& item : found) {
    if (!by_id.emplace(item.id, &item).second)
      return mismatch(where, "product \"" + item.id + "\" occurs twice");
  }
  double worst = 0;
  for (std::uint32_t row = 0; row < scene.products.size(); ++row) {
    const std::string id = scene::product_id(scene, row);
    const auto item = by_id.find(id);
    if (item == by_id.end()) return mismatch(where, "product \"" + id + "\" is missing");
    const std::string& sku = scene.catalog[scene.products[row].sku].sku;
    if (item->second->sku != sku)
      return mismatch(
          where,
          fmt::format("product \"{}\" is \"{}\" in place of \"{}\"", id, item->second->sku, sku));
    const double distance =
        length(item->second->position - scene::world_from_product(scene.products[row]).position);
    if (!(distance <= position_tolerance_m))
      return mismatch(
          where, fmt::format("product \"{}\" is {:.2f} mm from its place", id, distance * 1e3));
    MARKETGEN_CHECK(compare_turn(scene.products[row], *item->second, where));
    worst = std::max(worst, distance);
  }
  return worst;
}

Result<void> compare_bounds(const Bounds3& wanted, const Bounds3& found, const std::string& where) {
  const auto axes = [](Vec3f v) { return std::array{v.x, v.y, v.z}; };
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double low = axes(found.low)[axis], high = axes(found.high)[axis];
    const double wanted_low = axes(wanted.low)[axis], wanted_high = axes(wanted.high)[axis];
    if (std::abs(low - wanted_low) <= bounds_tolerance_m &&
        std::abs(high - wanted_high) <= bounds_tolerance_m)
      continue;
    return mismatch(
        where,
        fmt::format("it reaches from {:.3f} to {:.3f} m along {}, the scene from {:.3f} to {:.3f}",
                    low,
                    high,
                    "xyz"[axis],
                    wanted_low,
                    wanted_high));
  }
  return {};
}

Result<void> compare_free_bodies(const scene::Scene& scene,
                                 const ExportOptions& options,
                                 const ExportContents& contents,
                                 const std::string& where) {
  if (!contents.free_bodies) return {};
  const auto wanted =
      static_cast<std::uint64_t>(std::ranges::count(products_in_free_region(scene, options), true));
  if (*contents.free_bodies == wanted) return {};
  return mismatch(
      where,
      fmt::format(
          "{} can move, {} were asked for", counted(*contents.free_bodies, "products"), wanted));
}

ExportedJoint wanted_joint(const scene::Scene& scene, const scene::SceneJoint& joint) {
  const Pose world =
      scene::world_from_fixture(scene, joint.fixture) * scene::fixture_from_joint(joint);
  return {scene::joint_id(scene, joint),
          joint.kind,
          world.position,
          rotate(world.rotation, {0, 0, 1}),
          double(joint.lower),
          double(joint.upper),
          double(joint.friction),
          double(joint.damping),
          double(joint.stiffness),
          double(joint.spring_rest),
          hold_open_factor(joint),
          double(joint.mass_kg),
          double(joint.gasket),
          double(joint.gasket_reach)};
}

// What differs between the two, or nothing.
std::string difference(const ExportedJoint& wanted, const ExportedJoint& found) {
  constexpr double relative = 1e-5;  // files hold single precision
  const auto differ = [](double a, double b) {
    return !(std::abs(a - b) <= relative * std::max(1.0, std::abs(a)));
  };
  if (wanted.kind != found.kind) return "kind";
  if (!(length(wanted.at - found.at) <= position_tolerance_m)) return "place";
  if (!(length(wanted.axis - found.axis) <= 1e-4)) return "axis";
  const auto endless = [](const ExportedJoint& j) {
    return j.kind == assets::JointKind::hinge && j.upper - j.lower > endless_hinge_rad;
  };
  if (endless(wanted) != endless(found)) return "limits";
  if (!endless(wanted) && (differ(wanted.lower, found.lower) || differ(wanted.upper, found.upper)))
    return "limits";
  if (differ(wanted.mass_kg, found.mass_kg)) return "mass";
  if (wanted.kind == assets::JointKind::belt) return "";
  if (differ(wanted.friction, found.friction)) return "friction";
  if (differ(wanted.damping, found.damping)) return "damping";
  if (differ(wanted.stiffness, found.stiffness) || differ(wanted.spring_rest, found.spring_rest) ||
      differ(wanted.hold_open_factor, found.hold_open_factor))
    return "spring";
  if (differ(wanted.gasket, found.gasket) || differ(wanted.gasket_reach, found.gasket_reach))
    return "gasket";
  return "";
}

Result<void> compare_joints(const scene::Scene& scene,
                            const ExportOptions& options,
                            const ExportContents& contents,
                            const std::string& where) {
  if (!contents.joints) return {};
  const std::size_t wanted = options.still_fixtures ? 0 : scene.joints.size();
  if (contents.joints->size() != wanted) {
    return mismatch(where,
                    "the file holds " + counted(contents.joints->size(), "joints") +
                        ", the scene " + counted(wanted, "joints"));
  }
  if (wanted == 0) return {};
  std::map<std::string_view, const ExportedJoint*> by_name;
  for (const ExportedJoint& joint : *contents.joints)
    by_name.emplace(joint.name, &joint);
  for (const scene::SceneJoint& row : scene.joints) {
    const ExportedJoint joint = wanted_joint(scene, row);
    const auto found = by_name.find(joint.name);
    if (found == by_name.end()) return mismatch(where, "joint \"" + joint.name + "\" is missing");
    if (const std::string what = difference(joint, *found->second); !what.empty())
      return mismatch(where, "joint \"" + joint.name + "\" has another " + what);
  }
  return {};
}

Result<void> compare_looks_and_robots(const ExportOptions& options,
                                      const ExportContents& contents,
                                      const std::string& where) {
  const std::size_t looks = options.looks ? contents.products.size() : 0;
  if (contents.looks && *contents.looks != looks)
    return mismatch(
        where,
        fmt::format(
            "{} have a mesh, {} were to have one", counted(*contents.looks, "products"), looks));
  if (contents.robots == options.robots.size()) return {};
  return mismatch(where,
                  fmt::format("the file holds {}, {} were put in",
                              counted(contents.robots, "robots"),
                              options.robots.size()));
}

}  // namespace

Error mismatch(const std::string& where, std::string message) {
  return {"export.mismatch", where, std::move(message) + "; export the store again"};
}

Result<ExportSummary> compare_with_scene(const scene::Scene& scene,
                                         const ExportOptions& options,
                                         const ExportContents& contents,
                                         const std::string& where) {
  MARKETGEN_CHECK(compare_fixtures(scene, contents.fixtures, where));
  MARKETGEN_TRY(const double worst, compare_products(scene, contents.products, where));
  MARKETGEN_CHECK(compare_goods(scene, contents, where));
  MARKETGEN_CHECK(compare_parts(scene, contents, where));
  MARKETGEN_CHECK(compare_bounds(bounds_of(scene), contents.bounds, where));
  MARKETGEN_CHECK(compare_free_bodies(scene, options, contents, where));
  MARKETGEN_CHECK(compare_joints(scene, options, contents, where));
  MARKETGEN_CHECK(compare_looks_and_robots(options, contents, where));
  std::set<std::string_view> skus;
  for (const ExportedItem& item : contents.products)
    skus.insert(item.sku);
  ExportSummary summary;
  summary.fixtures = contents.fixtures.size();
  summary.products = contents.products.size();
  summary.skus = skus.size();
  summary.meshes = contents.meshes;
  summary.free_bodies = contents.free_bodies.value_or(0);
  summary.joints = contents.joints ? contents.joints->size() : 0;
  summary.looks = contents.looks.value_or(0);
  summary.robots = contents.robots;
  const Bounds3& bounds = contents.bounds;
  summary.bounds_low_m = {bounds.low.x, bounds.low.y, bounds.low.z};
  summary.bounds_high_m = {bounds.high.x, bounds.high.y, bounds.high.z};
  summary.worst_position_error_m = worst;
  summary.in_words = fmt::format(
      "{} products, {} fixtures, {} free bodies, {} joints; worst position error {:.3f} mm",
      summary.products,
      summary.fixtures,
      summary.free_bodies,
      summary.joints,
      1000 * summary.worst_position_error_m);
  return summary;
}

}  // namespace marketgen::exporters
