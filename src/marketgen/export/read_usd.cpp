#include "export/exporter.h"
#include "io/file.h"
#include "io/json.h"
#include "io/program.h"

// Reads a USD export with OpenUSD itself (PyPI's usd-core), in a worker of its own.
namespace marketgen::exporters {
namespace {

constexpr double max_seconds = 300;

struct UsdRequest {
  std::string file;
  static constexpr auto fields = field_list(field("file", &UsdRequest::file, "root layer"));
};

struct UsdItem {
  std::string id, sku;
  std::array<double, 3> position{};
  std::array<double, 4> rotation{};
  static constexpr auto fields = field_list(field("id", &UsdItem::id, "of the item"),
                                            field("sku", &UsdItem::sku, "of its asset"),
                                            field("position", &UsdItem::position, "store frame"),
                                            field("rotation", &UsdItem::rotation, "w, x, y, z"));
};

struct UsdSku {
  std::string sku;
  double mass_kg = 0, friction = 0;
  static constexpr auto fields = field_list(field("sku", &UsdSku::sku, "of the asset"),
                                            field("mass_kg", &UsdSku::mass_kg, "of an item"),
                                            field("friction", &UsdSku::friction, "sliding"));
};

struct UsdJoint {
  std::string name;
  assets::JointKind kind = assets::JointKind::hinge;
  std::array<double, 3> at{}, axis{};
  double lower = 0, upper = 0, friction = 0, damping = 0, stiffness = 0, spring_rest = 0;
  double hold_open_factor = 0, mass_kg = 0, gasket = 0, gasket_reach = 0;
  static constexpr auto fields =
      field_list(field("name", &UsdJoint::name, "fixture and joint"),
                 field("kind", &UsdJoint::kind, "how it moves"),
                 field("at", &UsdJoint::at, "store frame, at position 0"),
                 field("axis", &UsdJoint::axis, "store frame"),
                 field("lower", &UsdJoint::lower, "least position"),
                 field("upper", &UsdJoint::upper, "greatest position"),
                 field("friction", &UsdJoint::friction, "dry friction"),
                 field("damping", &UsdJoint::damping, "of its drive"),
                 field("stiffness", &UsdJoint::stiffness, "of its drive"),
                 field("spring_rest", &UsdJoint::spring_rest, "target of its drive"),
                 field("hold_open_factor", &UsdJoint::hold_open_factor, "see hold_open_factor"),
                 field("mass_kg", &UsdJoint::mass_kg, "of what it moves"),
                 field("gasket", &UsdJoint::gasket, "torque on the shut door"),
                 field("gasket_reach", &UsdJoint::gasket_reach, "where it has gone"));
};

struct UsdAnswer {
  std::vector<std::string> fixtures, faults;
  std::vector<UsdItem> products;
  std::vector<UsdSku> goods;
  std::vector<UsdJoint> joints;
  std::uint64_t free_bodies = 0, meshes = 0;
  std::array<double, 3> low{}, high{};
  static constexpr auto fields =
      field_list(field("fixtures", &UsdAnswer::fixtures, "ids"),
                 field("faults", &UsdAnswer::faults, "what OpenUSD cannot find or put together"),
                 field("products", &UsdAnswer::products, "items"),
                 field("goods", &UsdAnswer::goods, "SKUs"),
                 field("joints", &UsdAnswer::joints, "of fixtures"),
                 field("free_bodies", &UsdAnswer::free_bodies, "items that can move"),
                 field("meshes", &UsdAnswer::meshes, "meshes"),
                 field("low", &UsdAnswer::low, "lowest corner"),
                 field("high", &UsdAnswer::high, "highest corner"));
};

Vec3 vector_of(const std::array<double, 3>& v) {
  return {v[0], v[1], v[2]};
}

ExportContents contents_of(UsdAnswer& answer) {
  ExportContents contents;
  contents.fixtures.insert(answer.fixtures.begin(), answer.fixtures.end());
  contents.meshes = answer.meshes;
  contents.free_bodies = answer.free_bodies;
  contents.bounds = {to_float(vector_of(answer.low)), to_float(vector_of(answer.high))};
  for (UsdItem& item : answer.products) {
    const auto& [w, x, y, z] = item.rotation;
    contents.products.push_back({std::move(item.id),
                                 std::move(item.sku),
                                 vector_of(item.position),
                                 Quaternion{w, x, y, z}});
  }
  contents.goods.emplace();
  for (UsdSku& sku : answer.goods)
    contents.goods->push_back({std::move(sku.sku), sku.mass_kg, sku.friction});
  contents.joints.emplace();
  for (UsdJoint& j : answer.joints)
    contents.joints->push_back({std::move(j.name),
                                j.kind,
                                vector_of(j.at),
                                vector_of(j.axis),
                                j.lower,
                                j.upper,
                                j.friction,
                                j.damping,
                                j.stiffness,
                                j.spring_rest,
                                j.hold_open_factor,
                                j.mass_kg,
                                j.gasket,
                                j.gasket_reach});
  return contents;
}

}  // namespace

Result<ExportContents> read_usd(const std::filesystem::path& file,
                                const std::vector<catalog::Product>& /*catalog*/) {
  MARKETGEN_CHECK(io::read_file(file));  // OpenUSD's words for one that is not there help nobody
  MARKETGEN_CHECK(io::worker_part("usd-core"));
  const UsdRequest request{std::filesystem::absolute(file).string()};
  const Result<std::string> text =
      io::run_worker("read_usd", io::write_json_line(request), max_seconds);
  if (!text.ok()) {
    if (text.error().code != "program.failed") return text.error();
    return Error{"export.mismatch",
                 file.string(),
                 "OpenUSD cannot read it: " + text.error().message + "; export the store again"};
  }
  MARKETGEN_TRY(UsdAnswer answer, io::read_json<UsdAnswer>(*text, "worker"));
  if (!answer.faults.empty()) return mismatch(file.string(), answer.faults.front());
  return contents_of(answer);
}

}  // namespace marketgen::exporters
