// Export: one file per format, each with its own re-reader for the round trip.
#pragma once
#include <array>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/fields.h"
#include "base/progress.h"
#include "base/result.h"
#include "layout/reach.h"
#include "robots/placed_robot.h"
#include "scene/scene.h"

namespace marketgen::exporters {

// x0, y0, x1, y1 in metres: products whose centre lies inside become free bodies (mjcf, usd, sdf).
struct ExportOptions {
  double resolution_m = 0.05;  // nav2: side of a cell; 0.01 to 0.25, rounded to whole millimetres
  // nav2: whose waypoints these are. Its radius is what layouts are made for (layout/reach.h); what
  // begins higher than it is no obstacle.
  double robot_radius_m = layout::robot_width_mm * 0.5e-3;
  double robot_height_m = 2;
  std::optional<std::array<double, 4>> free_region_m;
  bool instanced = false;       // glb: EXT_mesh_gpu_instancing, a node a SKU instead of one an item
  bool still_fixtures = false;  // mjcf, usd, urdf, sdf: no part of a fixture can move
  bool looks = false;           // mjcf: meshes and pictures over the contact primitives
  std::vector<robots::PlacedRobot> robots;  // mjcf
  // coco: stops along the shelves lie this far apart or a little less; the lens stands so far
  // before their foremost edge, and so high over the floor, a picture each.
  double camera_spacing_m = 0.5, camera_distance_m = 1.0;
  std::vector<double> camera_heights_m{0.6, 1.5};
  std::array<int, 2> picture_px{1280, 720};  // coco: width, height
  Progress* progress = nullptr;              // coco: told of the pictures; null: silent
  std::string beside = "assets";  // folder of what lies beside the file; export_scene() names it
  // Writes one file of what lies beside at once, for what memory does not hold; set by
  // export_scene().
  std::function<Result<void>(const std::string& name, std::string_view bytes)> put_beside;
};

// What a file holds, read back with another code path than the one that wrote it.
struct ExportSummary {
  std::uint64_t fixtures = 0, products = 0, skus = 0, meshes = 0, free_bodies = 0, joints = 0,
                looks = 0, robots = 0, waypoints = 0, blocks = 0, units = 0, pictures = 0,
                annotations = 0, gaps = 0, price_tags = 0, misplaced = 0, wrong_price_tags = 0,
                missing_price_tags = 0;
  double free_m2 = 0, keepout_m2 = 0;
  std::array<double, 3> bounds_low_m{}, bounds_high_m{};
  double worst_position_error_m = 0;  // of any product against the scene, after `check`
  std::string in_words;               // the same, for a person; no field

  static constexpr auto fields = field_list(
      field("fixtures", &ExportSummary::fixtures, "fixture modules"),
      field("products", &ExportSummary::products, "single items"),
      field("skus", &ExportSummary::skus, "different products"),
      field("meshes", &ExportSummary::meshes, "meshes or geoms"),
      field("free_bodies", &ExportSummary::free_bodies, "bodies that can move"),
      field("joints", &ExportSummary::joints, "joints of fixtures"),
      field("looks", &ExportSummary::looks, "products with a mesh and a picture (mjcf)"),
      field("robots", &ExportSummary::robots, "robots that were put in"),
      field("waypoints", &ExportSummary::waypoints, "places to drive to (nav2)"),
      field("free_m2", &ExportSummary::free_m2, "floor that nothing stands on (nav2)"),
      field(
          "keepout_m2", &ExportSummary::keepout_m2, "of it, floor that robots keep out of (nav2)"),
      field("blocks", &ExportSummary::blocks, "blocks of a product (planogram)"),
      field("units", &ExportSummary::units, "items that stand in them (planogram)"),
      field("pictures", &ExportSummary::pictures, "pictures of shelves (coco)"),
      field("annotations", &ExportSummary::annotations, "what they show, together (coco)"),
      field("gaps", &ExportSummary::gaps, "of these, empty facings (coco)"),
      field("price_tags", &ExportSummary::price_tags, "of these, price tags (coco)"),
      field("wrong_price_tags",
            &ExportSummary::wrong_price_tags,
            "of these tags, with the price or the product of another (coco)"),
      field("missing_price_tags",
            &ExportSummary::missing_price_tags,
            "of the annotations, places without a tag (coco)"),
      field("misplaced", &ExportSummary::misplaced, "of these, misplaced items (coco)"),
      field("bounds_low_m", &ExportSummary::bounds_low_m, "lowest corner"),
      field("bounds_high_m", &ExportSummary::bounds_high_m, "highest corner"),
      field("worst_position_error_m",
            &ExportSummary::worst_position_error_m,
            "largest distance of a product from its place in the scene"));
};

struct ExportFormat {
  std::string_view name, description, extension;
  bool whole = true;  // it holds every item of the store, and not an extract
};
std::vector<ExportFormat> export_formats();  // rows of export_formats.inc

// Writes `scene` to the file `out`; what lies beside it goes to the folder "<stem of out>_assets".
// All of it is put in place at the end, or nothing. Files of an earlier export there are written
// anew or left. Errors: export.unknown_format with the nearest name, io.*, and for nav2, coco
// and urdf usage.bad_flag.
Result<void> export_scene(const scene::Scene& scene,
                          std::string_view format,
                          const std::filesystem::path& out,
                          const ExportOptions& options = {});
// Reads `file` back and compares; of a whole store counts, bounds, and every product's place within
// 0.1 mm. `options` are those it was written with. Error: export.mismatch.
Result<ExportSummary> check_export(const scene::Scene& scene,
                                   std::string_view format,
                                   const std::filesystem::path& file,
                                   const ExportOptions& options = {});

}  // namespace marketgen::exporters
