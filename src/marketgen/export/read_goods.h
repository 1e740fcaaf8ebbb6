// What a reader finds of goods, and how far solids reach.
#pragma once
#include <map>
#include <string>
#include <vector>

#include "export/exporter.h"

namespace marketgen::exporters {

// Different values for one SKU are kept apart: each is compared with the scene.
class GoodsReader {
 public:
  void add(const ExportedGoods& goods);
  std::vector<ExportedGoods> take();

 private:
  std::map<std::string, std::vector<ExportedGoods>> by_sku_;
};

// The axis-aligned box around it.
void include_solid(Bounds3& bounds, const assets::ContactShape& shape);

}  // namespace marketgen::exporters
