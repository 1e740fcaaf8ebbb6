// The two halves of a format, declared from export_formats.inc: bytes from a scene, and what a
// reader finds in them.
#pragma once
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "assets/contact_shape.h"
#include "base/result.h"
#include "export/export.h"
#include "geometry/mesh.h"

namespace marketgen::exporters {

// A file that lies beside the exported one, in a folder of its own.
struct BesideFile {
  std::string name, bytes;
};
struct ExportFiles {
  std::string main;
  std::vector<BesideFile> beside;
};

struct ExportedItem {
  std::string id, sku;
  Vec3 position;                            // of the product frame's origin, in the store frame
  std::optional<Quaternion> rotation = {};  // world_from_product; absent: the reader has none
};

// What a file says of the items of one SKU.
struct ExportedGoods {
  std::string sku;
  double mass_kg = 0, friction = 0;
  std::optional<assets::ContactShape> solid = {};  // product frame; absent: not one solid
};

// Everything at position 0, in the store frame.
struct ExportedJoint {
  std::string name;  // "<fixture id>/<joint>"
  assets::JointKind kind = assets::JointKind::hinge;
  Vec3 at, axis;
  double lower = 0, upper = 0, friction = 0, damping = 0;
  double stiffness = 0, spring_rest = 0, hold_open_factor = 0;  // of export/fixture_links.h
  double mass_kg = 0;
  double gasket = 0, gasket_reach = 0;  // of export/mjcf_fixtures.h
};

// What a file holds, in the store frame whatever the format's own axes are.
struct ExportContents {
  std::set<std::string> fixtures;
  std::vector<ExportedItem> products;
  std::uint64_t meshes = 0;
  std::optional<std::uint64_t> free_bodies;          // absent: nothing moves in this format
  std::optional<std::vector<ExportedJoint>> joints;  // absent: this format has none
  std::optional<std::vector<ExportedGoods>> goods;   // absent: this format says no masses
  // Solids of fixtures in the store frame, by "<fixture id>/<part_name()>"; absent: no such names.
  std::optional<std::map<std::string, assets::ContactShape>> parts;
  std::optional<std::uint64_t> looks;  // products whose look is apart from what they touch with
  std::uint64_t robots = 0;
  Bounds3 bounds;  // of everything solid but an endless floor
};

// write_<name>: the whole file, and what lies beside it. check_<name>: reads it back and compares
// it with the scene; `options` are those it was written with. read_<name>: what an independent
// library finds in it; `catalog` is the scene's and may only be used to find where in a product's
// shape the origin of its frame lies. Errors: export.mismatch when it cannot be read, io.*.
#define EXPORT_FORMAT(name, description, extension)                                          \
  Result<ExportFiles> write_##name(const scene::Scene& scene, const ExportOptions& options); \
  Result<ExportContents> read_##name(const std::filesystem::path& file,                      \
                                     const std::vector<catalog::Product>& catalog);
#define EXPORT_EXTRACT(name, description, extension)                                         \
  Result<ExportFiles> write_##name(const scene::Scene& scene, const ExportOptions& options); \
  Result<ExportSummary> check_##name(                                                        \
      const scene::Scene& scene, const std::filesystem::path& file, const ExportOptions& options);
#include "export/export_formats.inc"
#undef EXPORT_FORMAT
#undef EXPORT_EXTRACT

// What a file says otherwise than the scene, as export.mismatch; `message` without its end.
Error mismatch(const std::string& where, std::string message);

// Products whose centre lies in options.free_region_m, by row; none without a region.
std::vector<bool> products_in_free_region(const scene::Scene& scene, const ExportOptions& options);

// Where such a product would fall, engines need a joint at the middle of its upper edge.
bool hangs_on_peg(const scene::Scene& scene, std::uint32_t product);

// Compares what was read with the scene. Error: export.mismatch with the first difference.
Result<ExportSummary> compare_with_scene(const scene::Scene& scene,
                                         const ExportOptions& options,
                                         const ExportContents& contents,
                                         const std::string& where);

}  // namespace marketgen::exporters
