#include "export/coco_read.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <set>

#include "export/exporter.h"
#include "io/file.h"
#include "io/json.h"

namespace marketgen::exporters {
namespace {

using Json = nlohmann::json;

constexpr std::uint64_t max_coco_bytes = std::uint64_t{8} << 30;

ReadCocoImage image_in(const Json& row) {
  ReadCocoImage image;
  row.at("id").get_to(image.id);
  row.at("width").get_to(image.width), row.at("height").get_to(image.height);
  row.at("file_name").get_to(image.file_name), row.at("depth_file").get_to(image.depth_file);
  row.at("camera_matrix").get_to(image.k);
  row.at("world_from_camera").get_to(image.world_from_camera);
  return image;
}

ReadCocoPlace place_in(const Json& row) {
  ReadCocoPlace place;
  row.at("fixture").get_to(place.fixture), row.at("side").get_to(place.side);
  row.at("bay").get_to(place.bay), row.at("shelf").get_to(place.shelf);
  row.at("position").get_to(place.position);
  return place;
}

ReadCocoAnnotation annotation_in(const Json& row) {
  ReadCocoAnnotation read;
  row.at("id").get_to(read.id), row.at("image_id").get_to(read.image);
  row.at("category_id").get_to(read.category), row.at("area").get_to(read.area);
  row.at("bbox").get_to(read.box), row.at("occlusion").get_to(read.occlusion);
  row.at("segmentation").at("counts").get_to(read.counts);
  row.at("sku").get_to(read.sku);
  if (row.at("iscrowd") != 0) throw Json::other_error::create(501, "iscrowd is not 0", nullptr);
  read.instance = row.value("instance", ""), read.planogram_sku = row.value("planogram_sku", "");
  read.misplaced = row.value("misplaced", false), read.promotion = row.value("promotion", false);
  read.price = row.value("price", 0.0), read.fault = row.value("fault", "");
  if (row.contains("place")) read.place = place_in(row.at("place"));
  if (row.contains("column")) read.column = row.at("column").get<int>();
  if (row.contains("text")) row.at("text").get_to(read.text);
  return read;
}

Result<void> add_categories(ReadCoco& coco, const Json& document, const std::string& where) {
  for (const Json& row : document.at("categories")) {
    const int id = row.at("id");
    if (!coco.categories.emplace(id, std::pair(row.at("name"), row.at("supercategory"))).second)
      return mismatch(where, fmt::format("it has category {} twice", id));
  }
  return {};
}

Result<void> add_images(ReadCoco& coco, const Json& document, const std::string& where) {
  for (const Json& row : document.at("images")) {
    ReadCocoImage image = image_in(row);
    MARKETGEN_TRY(image.camera, io::read_json<render::CameraFile>(row.at("camera").dump(), where));
    if (!coco.annotations.try_emplace(image.id).second)
      return mismatch(where, fmt::format("it has picture {} twice", image.id));
    coco.images.push_back(std::move(image));
  }
  return {};
}

Result<void> add_annotations(ReadCoco& coco, const Json& document, const std::string& where) {
  std::set<int> ids;
  for (const Json& row : document.at("annotations")) {
    ReadCocoAnnotation read = annotation_in(row);
    if (!ids.insert(read.id).second)
      return mismatch(where, fmt::format("it has annotation {} twice", read.id));
    const auto of = coco.annotations.find(read.image);
    if (of == coco.annotations.end() || !coco.categories.contains(read.category))
      return mismatch(where,
                      fmt::format("annotation {} is of picture {} and category {}, which are not "
                                  "both there",
                                  read.id,
                                  read.image,
                                  read.category));
    of->second.push_back(std::move(read));
  }
  return {};
}

// One number of five bits a character, lowest first; the last gives the sign.
std::optional<std::int64_t> next_number(const std::string& counts, std::size_t& at) {
  std::int64_t value = 0;
  for (int shift = 0; shift < 60 && at < counts.size(); shift += 5) {
    const int bits = counts[at++] - 48;
    if (bits < 0 || bits > 63) return std::nullopt;
    value |= static_cast<std::int64_t>(bits & 31) << shift;
    if ((bits & 32) != 0) continue;
    if ((bits & 16) != 0) value -= std::int64_t{1} << (shift + 5);
    return value;
  }
  return std::nullopt;
}

}  // namespace

Vec3 ReadCocoImage::point_at(int x, int y, double depth_m) const {
  const Vec3 seen{(x - k[0][2]) / k[0][0] * depth_m, (y - k[1][2]) / k[1][1] * depth_m, depth_m};
  const auto row = [&](std::size_t r) {
    const auto& m = world_from_camera[r];
    return m[0] * seen.x + m[1] * seen.y + m[2] * seen.z + m[3];
  };
  return {row(0), row(1), row(2)};
}

Result<ReadCoco> read_coco(const std::filesystem::path& file) {
  const std::string where = file.string();
  MARKETGEN_TRY(const std::string bytes, io::read_file(file, max_coco_bytes));
  ReadCoco coco;
  try {
    const Json document = Json::parse(bytes);
    document.at("info").at("scene_hash").get_to(coco.scene_hash);
    MARKETGEN_CHECK(add_categories(coco, document, where));
    MARKETGEN_CHECK(add_images(coco, document, where));
    MARKETGEN_CHECK(add_annotations(coco, document, where));
  } catch (const Json::exception& fault) {
    return mismatch(where, std::string("it is no COCO data set of ours: ") + fault.what());
  }
  return coco;
}

std::optional<std::vector<std::uint32_t>> mask_pixels(const std::string& counts,
                                                      std::uint32_t pixels) {
  std::vector<std::int64_t> runs;
  for (std::size_t at = 0; at < counts.size();) {
    const auto number = next_number(counts, at);
    if (!number) return std::nullopt;
    runs.push_back(*number + (runs.size() > 2 ? runs[runs.size() - 2] : 0));
    if (runs.back() < 0 || runs.back() > pixels) return std::nullopt;
  }
  std::vector<std::uint32_t> inside;
  std::uint64_t at = 0;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const std::uint64_t end = at + static_cast<std::uint64_t>(runs[i]);
    if (end > pixels) return std::nullopt;
    for (; i % 2 == 1 && at < end; ++at)
      inside.push_back(static_cast<std::uint32_t>(at));
    at = end;
  }
  if (at != pixels) return std::nullopt;
  return inside;
}

}  // namespace marketgen::exporters
