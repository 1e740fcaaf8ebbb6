// What a COCO annotation should say, from the store's items and planogram alone.
#pragma once
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "export/coco_read.h"
#include "scene/planogram_rows.h"
#include "scene/scene.h"

namespace marketgen::exporters {

enum class CocoKind { item, gap, price_tag, missing_tag };

class CocoTruth {
 public:
  explicit CocoTruth(const scene::Scene& scene);  // which must outlive it

  // Row in scene.products of an item's id; nothing when the store has none of it.
  std::optional<std::uint32_t> product(const std::string& instance) const;
  // The categories are the store's SKUs with their categories, gap, price_tag and
  // missing_price_tag.
  Result<void> check_categories(const ReadCoco& coco, const std::string& where) const;
  // Every word of an annotation but its pixels. Error: export.mismatch at `where`.
  Result<void> check(CocoKind kind, const ReadCocoAnnotation& read, const std::string& where) const;
  // Whether the point lies in the item's box, within a few millimetres.
  bool lies_in(std::uint32_t product, Vec3 store_point) const;

 private:
  const scene::PlanogramRow* row_at(const std::optional<ReadCocoPlace>& place) const;
  Result<void> check_item(const ReadCocoAnnotation& read, const std::string& where) const;
  Result<void> check_gap(const ReadCocoAnnotation& read, const std::string& where) const;
  Result<void> check_price_tag(const ReadCocoAnnotation& read, const std::string& where) const;
  Result<void> check_missing_tag(const ReadCocoAnnotation& read, const std::string& where) const;

  const scene::Scene& scene_;
  std::vector<scene::PlanogramRow> planogram_;        // by facing
  std::map<ReadCocoPlace, std::uint32_t> facings_;    // by place
  std::map<std::string, std::uint32_t> products_;     // by id
  std::multimap<std::uint32_t, std::uint32_t> tags_;  // rows of scene.price_labels, by facing
};

}  // namespace marketgen::exporters
