// What a page is told of a store at once, without its light: names, numbers, the plan.
#pragma once
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "base/fields.h"
#include "layout/layout.h"
#include "scene/scene.h"
#include "server/cards.h"
#include "store/store.h"

namespace marketgen::server {

struct StoreLine {
  int store = 0;
  std::string name, folder, scene_hash, prompt;
  std::uint64_t seed = 0, products = 0;
  static constexpr auto fields =
      field_list(field("store", &StoreLine::store, "its number in addresses"),
                 field("prompt", &StoreLine::prompt, "what was asked for"),
                 field("seed", &StoreLine::seed, "seed it was made with"),
                 field("name", &StoreLine::name, "its name"),
                 field("folder", &StoreLine::folder, "last part of its folder's path"),
                 field("scene_hash", &StoreLine::scene_hash, "over SKU, geometry and pose"),
                 field("products", &StoreLine::products, "single items"));
};

struct StoreList {
  std::string schema = "market-view/1", program;
  std::vector<StoreLine> stores;
  static constexpr auto fields =
      field_list(field("schema", &StoreList::schema, "schema tag", constant("market-view/1")),
                 field("program", &StoreList::program, "version of the server"),
                 field("stores", &StoreList::stores, "in the order of the command line"));
};

// An opening in the wall: from one end on its sill to the other on its head.
struct ViewOpening {
  plan::OpeningKind kind = plan::OpeningKind::entrance;
  std::array<double, 3> low_m{}, high_m{};
  static constexpr auto fields =
      field_list(field("kind", &ViewOpening::kind, "what passes through"),
                 field("low_m", &ViewOpening::low_m, "one end, on the sill"),
                 field("high_m", &ViewOpening::high_m, "the other, on the head"));
};

struct ViewCamera {
  std::string name;
  std::array<double, 3> from_m{}, at_m{};
  double fov_deg = 60, ortho_height_m = 0;
  static constexpr auto fields = field_list(field("name", &ViewCamera::name, "\"entrance\""),
                                            field("from_m", &ViewCamera::from_m, "eye"),
                                            field("at_m", &ViewCamera::at_m, "point it looks at"),
                                            field("fov_deg", &ViewCamera::fov_deg, "vertical"),
                                            field("ortho_height_m",
                                                  &ViewCamera::ortho_height_m,
                                                  "over 0: from above, without perspective"));
};

struct ViewFixture {
  std::uint32_t row = 0;
  std::string id, kind, generator, zone, run;
  std::array<double, 3> position_m{}, size_m{};
  int yaw_deg = 0, levels = 0;
  static constexpr auto fields =
      field_list(field("row", &ViewFixture::row, "row in the scene"),
                 field("id", &ViewFixture::id, "id"),
                 field("kind", &ViewFixture::kind, "fixture kind"),
                 field("generator", &ViewFixture::generator, "how rows of this kind are built"),
                 field("zone", &ViewFixture::zone, "zone id"),
                 field("run", &ViewFixture::run, "the line it stands in"),
                 field("position_m", &ViewFixture::position_m, "middle of its footprint"),
                 field("yaw_deg", &ViewFixture::yaw_deg, "0 = front faces south"),
                 field("size_m", &ViewFixture::size_m, "width, depth, height"),
                 field("levels", &ViewFixture::levels, "stocked levels"));
};

struct ViewJoint {
  std::uint32_t row = 0, fixture = 0;
  std::string name;
  assets::JointKind kind = assets::JointKind::hinge;
  std::int32_t parent = -1;
  std::array<double, 3> origin_m{}, axis{};
  double lower = 0, upper = 0;
  std::vector<assets::JointState> states;
  static constexpr auto fields =
      field_list(field("row", &ViewJoint::row, "row in the scene"),
                 field("fixture", &ViewJoint::fixture, "row of its fixture"),
                 field("name", &ViewJoint::name, "unique within the fixture"),
                 field("kind", &ViewJoint::kind, "how it moves"),
                 field("parent", &ViewJoint::parent, "row of the joint that carries it, or -1"),
                 field("origin_m", &ViewJoint::origin_m, "a point of the axis, store frame"),
                 field("axis", &ViewJoint::axis, "its direction, store frame"),
                 field("lower", &ViewJoint::lower, "radians, metres or m/s"),
                 field("upper", &ViewJoint::upper, "radians, metres or m/s"),
                 field("states", &ViewJoint::states, "named positions"));
};

struct ViewSku {
  std::string sku, ean, name, name_zh, brand, variant, category;
  double price = 0;
  std::string currency;
  std::array<double, 3> size_m{};
  double mass_kg = 0, pick_rate = 0;
  std::string color;
  std::uint64_t products = 0;
  static constexpr auto fields =
      field_list(field("sku", &ViewSku::sku, "SKU"),
                 field("ean", &ViewSku::ean, "EAN-13; empty for loose produce"),
                 field("name", &ViewSku::name, "name"),
                 field("name_zh", &ViewSku::name_zh, "name in Chinese"),
                 field("brand", &ViewSku::brand, "brand"),
                 field("variant", &ViewSku::variant, "variant"),
                 field("category", &ViewSku::category, "category"),
                 field("price", &ViewSku::price, "in `currency`"),
                 field("currency", &ViewSku::currency, "ISO 4217"),
                 field("size_m", &ViewSku::size_m, "width, depth, height"),
                 field("mass_kg", &ViewSku::mass_kg, "mass"),
                 field("pick_rate",
                       &ViewSku::pick_rate,
                       "share of a tool's grasps that held in the grasp study, of the best tool; "
                       "-1 where none was studied"),
                 field("color", &ViewSku::color, "ground colour of the pack, #rrggbb"),
                 field("products", &ViewSku::products, "how many stand in the store"));
};

struct StoreSummary {
  int store = 0;
  bool may_edit = false, may_drive = false;
  std::string name, folder;
  std::uint64_t seed = 0;
  std::string profile, scene_hash, look_hash, prompt;
  scene::SceneCounts counts;
  store::StoreBounds bounds;
  PolygonMm outline_mm;
  double ceiling_m = 0;
  std::vector<ViewOpening> openings;
  std::vector<ViewCamera> cameras;
  std::vector<layout::LayoutZone> zones;
  std::vector<layout::Aisle> aisles;
  std::vector<layout::Violation> violations;
  std::vector<ViewFixture> fixtures;
  std::vector<ViewJoint> joints;
  std::vector<ViewSku> skus;

  static constexpr auto fields =
      field_list(field("store", &StoreSummary::store, "its number in addresses"),
                 field("may_edit", &StoreSummary::may_edit, "the server takes edits"),
                 field("may_drive", &StoreSummary::may_drive, "robots are driven in it"),
                 field("name", &StoreSummary::name, "its name"),
                 field("folder", &StoreSummary::folder, "last part of its folder's path"),
                 field("seed", &StoreSummary::seed, "seed it was made with"),
                 field("profile", &StoreSummary::profile, "kind of shop"),
                 field("scene_hash", &StoreSummary::scene_hash, "over SKU, geometry and pose"),
                 field("look_hash", &StoreSummary::look_hash, "over materials and light"),
                 field("prompt", &StoreSummary::prompt, "what was asked for"),
                 field("counts", &StoreSummary::counts, "how much there is"),
                 field("bounds", &StoreSummary::bounds, "of the room"),
                 field("outline_mm", &StoreSummary::outline_mm, "of the floor"),
                 field("ceiling_m", &StoreSummary::ceiling_m, "height of the room"),
                 field("openings", &StoreSummary::openings, "doors and windows"),
                 field("cameras", &StoreSummary::cameras, "the standard views"),
                 field("zones", &StoreSummary::zones, "zones"),
                 field("aisles", &StoreSummary::aisles, "free strips between fixtures"),
                 field("violations", &StoreSummary::violations, "broken rules"),
                 field("fixtures", &StoreSummary::fixtures, "one row a module"),
                 field("joints", &StoreSummary::joints, "what moves"),
                 field("skus", &StoreSummary::skus, "rows of the store's catalogue"));
};

std::vector<ViewOpening> openings_of(const scene::Scene& scene);
// By row of the scene.
std::vector<ViewFixture> fixtures_of(const scene::Scene& scene, const catalog::Catalog& catalog);
// Of those rows of the scene's catalogue.
std::vector<ViewSku> skus_of(const scene::Scene& scene,
                             const std::vector<std::uint32_t>& rows,
                             const GraspFacts& grasps,
                             const std::vector<catalog::FrictionRow>& frictions);
StoreLine line_of(int number, const store::Store& store);
// What a page may do with a store.
struct PageRights {
  bool edit = false, drive = false;
};
StoreSummary summary_of(int number,
                        const store::Store& store,
                        const GraspFacts& grasps,
                        const catalog::Catalog& catalog,
                        const PageRights& rights);

}  // namespace marketgen::server
