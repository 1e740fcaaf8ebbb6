// The stocked store: every fixture, part, shelf, facing block, price label and single product, in
// flat tables.
//
// Rows refer to one another by index. Positions are metres in the store frame. A Scene is immutable
// once built; everything that moves later (products a robot carries, doors) is kept apart and
// refers to it.
#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "assets/fixtures/fixture_model.h"
#include "base/fields.h"
#include "base/result.h"
#include "base/seed.h"
#include "catalog/catalog.h"
#include "geometry/pose.h"
#include "layout/layout.h"

namespace marketgen::scene {

// What a scene file may hold; a store is at most 200 m wide.
constexpr FieldRules in_the_store = range(-1000, 1000), store_size = range(0, 1000);
constexpr FieldRules unit_rotation = range(-1.001, 1.001);
constexpr FieldRules joint_reach = range(-10'000, 10'000), joint_force = range(0, 1e6);

// One module in its place: layout.fixtures[i] belongs to fixtures[i].
struct SceneFixture {
  std::uint32_t first_part = 0, part_count = 0;    // in parts
  std::uint32_t first_shelf = 0, shelf_count = 0;  // in shelves
  std::array<float, 3> position_m{};               // world_from_fixture
  std::int32_t quarter_turns = 0;                  // yaw / 90
  std::uint32_t first_joint = 0, joint_count = 0;  // in joints

  static constexpr auto fields = field_list(
      field("first_part", &SceneFixture::first_part, "first row in parts"),
      field("part_count", &SceneFixture::part_count, "rows in parts"),
      field("first_shelf", &SceneFixture::first_shelf, "first row in shelves"),
      field("shelf_count", &SceneFixture::shelf_count, "rows in shelves"),
      field("position_m", &SceneFixture::position_m, "origin in the store frame", in_the_store),
      field("quarter_turns", &SceneFixture::quarter_turns, "yaw divided by 90 degrees"),
      field("first_joint", &SceneFixture::first_joint, "first row in joints"),
      field("joint_count", &SceneFixture::joint_count, "rows in joints"));
};

// One degree of freedom, in its fixture's frame (see FixtureJoint). Parents stand before children.
struct SceneJoint {
  std::uint32_t fixture = 0;
  std::string name;  // unique within the fixture
  assets::JointKind kind = assets::JointKind::hinge;
  std::int32_t parent = -1;           // row in joints, or -1: the fixture's body carries it
  std::array<float, 3> position_m{};  // fixture_from_joint at position 0; it moves about or along Z
  std::array<float, 4> rotation_wxyz{1, 0, 0, 0};
  float lower = 0, upper = 0;
  float friction = 0, damping = 0;
  float stiffness = 0, spring_rest = 0, hold_open = 0;
  float mass_kg = 1;
  std::vector<assets::JointState> states;
  float gasket = 0, gasket_reach = 0;

  static constexpr auto fields = field_list(
      field("fixture", &SceneJoint::fixture, "row in fixtures"),
      field("name", &SceneJoint::name, "unique within the fixture", identifier()),
      field("kind", &SceneJoint::kind, "how it moves"),
      field("parent", &SceneJoint::parent, "row in joints that carries it, -1 for the fixture"),
      field("position_m",
            &SceneJoint::position_m,
            "a point of the axis, in the fixture frame",
            in_the_store),
      field("rotation_wxyz",
            &SceneJoint::rotation_wxyz,
            "turns Z onto the axis, in the fixture frame",
            unit_rotation),
      field("lower", &SceneJoint::lower, "least position: radians, metres or m/s", joint_reach),
      field("upper", &SceneJoint::upper, "greatest position", joint_reach),
      field("friction", &SceneJoint::friction, "dry friction, N m or N", joint_force),
      field("damping", &SceneJoint::damping, "N m s/rad or N s/m", joint_force),
      field("stiffness", &SceneJoint::stiffness, "spring, N m/rad or N/m", joint_force),
      field("spring_rest", &SceneJoint::spring_rest, "where the spring is slack", joint_reach),
      field("hold_open",
            &SceneJoint::hold_open,
            "position from which it stays open by itself, 0 for nowhere",
            joint_reach),
      field("mass_kg",
            &SceneJoint::mass_kg,
            "of the parts on it, without the joints that it carries",
            range(0, 10'000)),
      field("states", &SceneJoint::states, "named positions, the one at rest first"),
      field("gasket",
            &SceneJoint::gasket,
            "what a magnetic gasket holds it shut with at position 0, N m",
            joint_force),
      field("gasket_reach",
            &SceneJoint::gasket_reach,
            "position at which the gasket's pull has gone",
            range(0, 1)));
};

// One minimal unit, in its fixture's frame.
struct ScenePart {
  std::uint32_t fixture = 0;
  assets::UnitKind unit = assets::UnitKind::board;
  assets::PartShape shape = assets::PartShape::box;
  assets::SurfaceKind kind = assets::SurfaceKind::opaque;
  std::array<float, 3> position_m{};  // fixture_from_part
  std::array<float, 4> rotation_wxyz{1, 0, 0, 0};
  std::array<float, 3> half_size_m{};
  std::array<float, 3> color{};  // linear RGB
  float roughness = 0.5F, metallic = 0;
  std::int32_t material = -1;  // row in materials, or -1 for the plain colour
  std::int32_t joint = -1;     // row in joints that moves it, or -1: fixed

  static constexpr auto fields = field_list(
      field("fixture", &ScenePart::fixture, "row in fixtures"),
      field("unit", &ScenePart::unit, "kind of minimal unit"),
      field("shape", &ScenePart::shape, "box or cylinder"),
      field("kind", &ScenePart::kind, "how light meets it"),
      field("position_m", &ScenePart::position_m, "centre in the fixture frame", in_the_store),
      field("rotation_wxyz", &ScenePart::rotation_wxyz, "in the fixture frame", unit_rotation),
      field("half_size_m", &ScenePart::half_size_m, "half extents", store_size),
      field("color", &ScenePart::color, "linear RGB"),
      field("roughness", &ScenePart::roughness, "0 mirror, 1 chalk"),
      field("metallic", &ScenePart::metallic, "0 dielectric, 1 metal"),
      field("material", &ScenePart::material, "row in materials, -1 for plain colour"),
      field("joint", &ScenePart::joint, "row in joints that moves it, -1 for fixed"));
};

// One stocked surface, in its fixture's frame (see ShelfSurface).
struct SceneShelf {
  std::uint32_t fixture = 0;
  std::int32_t level = 0, side = 0;
  assets::ShelfUse use = assets::ShelfUse::stand;
  std::array<float, 3> position_m{};  // fixture_from_shelf
  std::array<float, 4> rotation_wxyz{1, 0, 0, 0};
  float width_m = 0, depth_m = 0, clearance_m = 0;
  std::int32_t price_rail = 1;

  static constexpr auto fields = field_list(
      field("fixture", &SceneShelf::fixture, "row in fixtures"),
      field("level", &SceneShelf::level, "0 = lowest"),
      field("side", &SceneShelf::side, "1 = back of a double-sided fixture"),
      field("use", &SceneShelf::use, "how goods are kept"),
      field("position_m",
            &SceneShelf::position_m,
            "middle of the front edge, in the fixture frame",
            in_the_store),
      field("rotation_wxyz", &SceneShelf::rotation_wxyz, "in the fixture frame", unit_rotation),
      field("width_m", &SceneShelf::width_m, "usable width", store_size),
      field("depth_m", &SceneShelf::depth_m, "usable depth", store_size),
      field("clearance_m", &SceneShelf::clearance_m, "free height", store_size),
      field("price_rail", &SceneShelf::price_rail, "1 when the front edge takes price labels"));
};

// A block of one SKU on a shelf: `facings` columns wide, `rows_deep` deep, `stack` high. The
// planogram's unit.
struct Facing {
  std::uint32_t shelf = 0;  // row in shelves
  std::uint32_t sku = 0;    // row in catalog
  float x_m = 0;            // left edge from the shelf's left end
  float width_m = 0;        // block width, gaps between its packs included
  std::uint16_t facings = 1, rows_deep = 1, stack = 1;
  std::uint16_t position = 0;  // order on the shelf from the left
  std::uint32_t first_product = 0,
                product_count = 0;  // rows in products; 0 products = out of stock

  static constexpr auto fields = field_list(
      field("shelf", &Facing::shelf, "row in shelves"),
      field("sku", &Facing::sku, "row in catalog"),
      field("x_m", &Facing::x_m, "left edge from the shelf's left end", in_the_store),
      field("width_m", &Facing::width_m, "block width", store_size),
      field("facings", &Facing::facings, "packs side by side"),
      field("rows_deep", &Facing::rows_deep, "packs one behind another"),
      field("stack", &Facing::stack, "packs on one another"),
      field("position", &Facing::position, "order from the left"),
      field("first_product", &Facing::first_product, "first row in products"),
      field("product_count", &Facing::product_count, "rows in products; 0 = out of stock"));
};

// One item. world_from_product = (position, rotation); the product frame is that of
// assets/product_model.h.
struct SceneProduct {
  std::uint32_t sku = 0;     // row in catalog
  std::uint32_t facing = 0;  // row in facings
  std::array<float, 3> position_m{};
  std::array<float, 4> rotation_wxyz{1, 0, 0, 0};
  std::uint32_t flags = 0;  // 1 = misplaced, 2 = front row

  static constexpr auto fields = field_list(
      field("sku", &SceneProduct::sku, "row in catalog"),
      field("facing", &SceneProduct::facing, "row in facings"),
      field("position_m",
            &SceneProduct::position_m,
            "bottom centre in the store frame",
            in_the_store),
      field("rotation_wxyz", &SceneProduct::rotation_wxyz, "in the store frame", unit_rotation),
      field("flags", &SceneProduct::flags, "1 = misplaced, 2 = front row, 4 = out of line"));
};
constexpr std::uint32_t product_misplaced = 1;
constexpr std::uint32_t product_front_row = 2;
constexpr std::uint32_t product_out_of_line = 4;  // shoppers left it so (scene/handled_goods.h)

// A price label on a shelf edge: one per facing block.
struct PriceLabel {
  std::uint32_t shelf = 0, sku = 0, facing = 0;
  float x_m = 0;  // centre along the shelf, from its left end
  float width_m = 0.07F, height_m = 0.038F;
  std::uint32_t promotion = 0;  // 1 = yellow
  std::uint32_t price_cents = 0;

  static constexpr auto fields =
      field_list(field("shelf", &PriceLabel::shelf, "row in shelves"),
                 field("sku", &PriceLabel::sku, "row in catalog"),
                 field("facing", &PriceLabel::facing, "row in facings"),
                 field("x_m", &PriceLabel::x_m, "centre from the shelf's left end", in_the_store),
                 field("width_m", &PriceLabel::width_m, "label width", store_size),
                 field("height_m", &PriceLabel::height_m, "label height", store_size),
                 field("promotion", &PriceLabel::promotion, "1 = promotion"),
                 field("price_cents", &PriceLabel::price_cents, "price"));
};

struct Scene {
  std::string schema = "market-scene/1";
  std::uint64_t seed = 0;
  layout::Layout layout;  // shell, look, zones, fixtures (same order as below), aisles
  std::vector<SceneFixture> fixtures;
  std::vector<ScenePart> parts;
  std::vector<SceneShelf> shelves;
  std::vector<Facing> facings;
  std::vector<SceneProduct> products;
  std::vector<PriceLabel> price_labels;
  std::vector<catalog::Product> catalog;        // the slice in use, sorted by sku
  std::vector<catalog::MaterialRow> materials;  // the slice in use
  std::vector<SceneJoint> joints;               // by fixture, parents before children

  static constexpr auto fields =
      field_list(field("schema", &Scene::schema, "schema tag", constant("market-scene/1")),
                 field("seed", &Scene::seed, "seed it was made with"),
                 field("layout", &Scene::layout, "the room and its fixtures"),
                 field("fixtures", &Scene::fixtures, "modules in place"),
                 field("parts", &Scene::parts, "minimal units"),
                 field("shelves", &Scene::shelves, "stocked surfaces"),
                 field("facings", &Scene::facings, "planogram"),
                 field("products", &Scene::products, "single items"),
                 field("price_labels", &Scene::price_labels, "labels on shelf edges"),
                 field("catalog", &Scene::catalog, "products in use"),
                 field("materials", &Scene::materials, "materials in use"),
                 field("joints", &Scene::joints, "what moves"));
};

// The stream of a store's seed that scenes are drawn from.
constexpr std::string_view scene_stream = "scene";

// What the scene needs of the plan: stock per zone, overrides, planogram, placements.
// Deterministic for any thread count. Errors: catalog.*, assets.*, plan.*, planogram.*.
Result<Scene> build_scene(const layout::Layout& layout,
                          const plan::Plan& plan,
                          const catalog::Catalog& catalog,
                          Seed seed);

Pose world_from_fixture(const Scene& scene, std::uint32_t fixture);
Pose world_from_shelf(const Scene& scene, std::uint32_t shelf);
Pose world_from_product(const SceneProduct& product);
// Puts it there.
void place(SceneProduct& product, const Pose& world_from_product);
Pose fixture_from_part(const ScenePart& part);
// "dairy/run-2/module-3/level-4/facing-7/item-12": stable id of a product.
std::string product_id(const Scene& scene, std::uint32_t product);

// 32 hex digits over SKU, fixture geometry and item poses (rounded to 0.01 mm and 1e-4 of a
// quaternion): equal scenes, equal hash.
std::string scene_hash(const Scene& scene);
// The same over materials, colours, light and label styles.
std::string look_hash(const Scene& scene);

struct SceneCounts {
  std::uint64_t products = 0, skus = 0, fixtures = 0, facings = 0;
  static constexpr auto fields =
      field_list(field("products", &SceneCounts::products, "single items"),
                 field("skus", &SceneCounts::skus, "different products on offer"),
                 field("fixtures", &SceneCounts::fixtures, "fixture modules"),
                 field("facings", &SceneCounts::facings, "packs in the front row"));
};
SceneCounts count(const Scene& scene);

}  // namespace marketgen::scene
