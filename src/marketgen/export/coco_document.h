// A COCO data set of shelf pictures, row by row: the fields of COCO's "object detection" format,
// and what shelf audits need beside them.
//
// Boxes and masks are those of what shows. Numbers of bays, shelves, positions and columns count
// from 1, as in the planogram export. Source of the format: https://cocodataset.org/#format-data.
#pragma once
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/fields.h"
#include "render/annotations.h"
#include "render/cameras/camera_file.h"
#include "render/mask_runs.h"

namespace marketgen::exporters {

// Pictures lie in these folders beside the document.
constexpr std::string_view coco_color_folder = "color", coco_depth_folder = "depth";

// Categories that are no SKU, and what they belong to.
constexpr std::string_view coco_gap = "gap", coco_price_tag = "price_tag",
                           coco_missing_tag = "missing_price_tag", coco_shelf = "shelf";

// Behind the SKUs, in this order.
constexpr std::array coco_shelf_categories{coco_gap, coco_price_tag, coco_missing_tag};

// Of a module: 1 is its back.
inline std::string coco_side(int side) {
  return side == 0 ? "front" : "back";
}

struct CocoInfo {
  std::string description, version, store, scene_hash;
  double depth_unit_m = 1e-3;
  int stops_without_room = 0;

  static constexpr auto fields = field_list(
      field("description", &CocoInfo::description, "what this is"),
      field("version", &CocoInfo::version, "of the program that wrote it"),
      field("store", &CocoInfo::store, "the store's name"),
      field("scene_hash", &CocoInfo::scene_hash, "of the store"),
      field("depth_unit_m", &CocoInfo::depth_unit_m, "of the values of depth pictures"),
      field("stops_without_room", &CocoInfo::stops_without_room, "where the robot cannot stand"));
};

struct CocoCategory {
  int id = 0;
  std::string name, supercategory;
  std::optional<std::string> product, brand, gtin;

  static constexpr auto fields = field_list(
      field("id", &CocoCategory::id, "number"),
      field("name", &CocoCategory::name, "SKU, gap, price_tag or missing_price_tag"),
      field("supercategory", &CocoCategory::supercategory, "the product's category, or shelf"),
      field("product", &CocoCategory::product, "name of the product"),
      field("brand", &CocoCategory::brand, "its brand"),
      field("gtin", &CocoCategory::gtin, "GTIN-13; none for what is sold by weight"));
};

struct CocoImage {
  int id = 0;
  std::string file_name, depth_file;
  int width = 0, height = 0;
  std::string zone, run, side;
  double camera_height_m = 0, distance_m = 0;
  std::vector<std::string> fixtures;
  render::CameraFile camera;
  std::array<std::array<double, 3>, 3> camera_matrix{};
  render::Matrix44 world_from_camera{};

  static constexpr auto fields = field_list(
      field("id", &CocoImage::id, "number"),
      field("file_name", &CocoImage::file_name, "colour, beside the document"),
      field("depth_file", &CocoImage::depth_file, "depth along the optical axis, 0: nothing"),
      field("width", &CocoImage::width, "pixels"),
      field("height", &CocoImage::height, "pixels"),
      field("zone", &CocoImage::zone, "that the run belongs to"),
      field("run", &CocoImage::run, "line of fixtures that the camera looks at"),
      field("side", &CocoImage::side, "front or back of its modules"),
      field("camera_height_m", &CocoImage::camera_height_m, "over the floor"),
      field("distance_m", &CocoImage::distance_m, "from the foremost edge of the shelves"),
      field("fixtures", &CocoImage::fixtures, "whose goods, gaps and tags it shows"),
      field("camera", &CocoImage::camera, "also a file for render --camera-file"),
      field("camera_matrix", &CocoImage::camera_matrix, "OpenCV's, rows"),
      field("world_from_camera",
            &CocoImage::world_from_camera,
            "pose, rows; camera frame x right, y down, z ahead"));
};

// What an annotation says of its place in the planogram; nothing for items that stand in no block.
struct CocoPlace {
  std::string fixture, side;
  int bay = 1, shelf = 1, position = 1;

  static constexpr auto fields = field_list(
      field("fixture", &CocoPlace::fixture, "module"),
      field("side", &CocoPlace::side, "front or back"),
      field("bay", &CocoPlace::bay, "along this side of the run, from the left"),
      field("shelf", &CocoPlace::shelf, "from the floor up"),
      field("position", &CocoPlace::position, "of the block on the shelf, from the left"));
};

struct CocoAnnotation {
  int id = 0, image_id = 0, category_id = 0;
  std::array<int, 4> bbox{};
  int area = 0, iscrowd = 0;
  render::MaskRuns segmentation;
  double occlusion = 0;
  std::string sku;
  std::optional<CocoPlace> place;
  std::optional<std::string> instance;
  std::optional<double> depth_m;
  std::optional<bool> misplaced;
  std::optional<std::string> planogram_sku;
  std::optional<int> column;
  std::optional<std::vector<std::string>> text;
  std::optional<double> price;
  std::optional<bool> promotion;
  std::optional<std::string> fault;

  static constexpr auto fields = field_list(
      field("id", &CocoAnnotation::id, "number"),
      field("image_id", &CocoAnnotation::image_id, "of its picture"),
      field("category_id", &CocoAnnotation::category_id, "of its category"),
      field("bbox", &CocoAnnotation::bbox, "left, top, width, height in pixels"),
      field("area", &CocoAnnotation::area, "pixels that show it"),
      field("iscrowd", &CocoAnnotation::iscrowd, "always 0"),
      field("segmentation", &CocoAnnotation::segmentation, "its pixels"),
      field("occlusion", &CocoAnnotation::occlusion, "1 - area / pixels that would show it alone"),
      field("sku",
            &CocoAnnotation::sku,
            "of the item; that belongs in the gap or at the missing tag; that the tag names"),
      field("place", &CocoAnnotation::place, "in the planogram; none of items in no block"),
      field("instance", &CocoAnnotation::instance, "the item's id"),
      field("depth_m", &CocoAnnotation::depth_m, "mean over an item's pixels"),
      field("misplaced", &CocoAnnotation::misplaced, "the planogram has another SKU there"),
      field("planogram_sku",
            &CocoAnnotation::planogram_sku,
            "of a misplaced item, and of the tag of a wrong product: that SKU"),
      field("column", &CocoAnnotation::column, "of a gap in its block, from the left; none: all"),
      field("text", &CocoAnnotation::text, "lines on the tag"),
      field("price", &CocoAnnotation::price, "on the tag, in the store's money"),
      field("promotion", &CocoAnnotation::promotion, "the tag is an offer's"),
      field("fault", &CocoAnnotation::fault, "of a tag: wrong_price or wrong_product"));
};

}  // namespace marketgen::exporters
