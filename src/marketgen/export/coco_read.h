// A COCO data set as any reader of JSON finds it, for its check.
#pragma once
#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "geometry/vector.h"
#include "render/cameras/camera_file.h"

namespace marketgen::exporters {

struct ReadCocoImage {
  int id = 0, width = 0, height = 0;
  std::string file_name, depth_file;
  render::CameraFile camera;
  std::array<std::array<double, 3>, 3> k{};
  std::array<std::array<double, 4>, 4> world_from_camera{};

  // The point of the store that the centre of a pixel shows, `depth_m` along the optical axis.
  Vec3 point_at(int x, int y, double depth_m) const;
};

struct ReadCocoPlace {
  std::string fixture, side;
  int bay = 0, shelf = 0, position = 0;
  friend auto operator<=>(const ReadCocoPlace&, const ReadCocoPlace&) = default;
};

struct ReadCocoAnnotation {
  int id = 0, image = 0, category = 0, area = 0;
  std::array<int, 4> box{};  // left, top, width, height
  double occlusion = 0, price = 0;
  std::string counts, sku, instance, planogram_sku, fault;
  std::optional<ReadCocoPlace> place;
  std::optional<int> column;
  bool misplaced = false, promotion = false;
  std::vector<std::string> text;
};

struct ReadCoco {
  std::string scene_hash;
  std::map<int, std::pair<std::string, std::string>> categories;  // name and what it belongs to
  std::vector<ReadCocoImage> images;
  std::map<int, std::vector<ReadCocoAnnotation>> annotations;  // by image
};

// Errors: export.mismatch for what is no COCO data set, ids that are there twice, and annotations
// of pictures and categories that are not there; input.*, io.*.
Result<ReadCoco> read_coco(const std::filesystem::path& file);

// Pixels of a mask, by x * height + y, from COCO's compressed run lengths, as pycocotools counts
// them. Nothing when the text is none or its runs do not add up to `pixels`.
std::optional<std::vector<std::uint32_t>> mask_pixels(const std::string& counts,
                                                      std::uint32_t pixels);

}  // namespace marketgen::exporters
