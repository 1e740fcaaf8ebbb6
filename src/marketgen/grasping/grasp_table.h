// The study of the whole catalogue off stocked shelves, as the program is shipped with it:
// data/grasps.csv, made by tools/refresh_grasps. Who asks for a row's rate need not try its grasps
// in physics, which takes seconds.
//
//   sku,tool,made_of,excluded,reason,tries
//     one row a product and tool. `made_of`: hash of what the rate was studied on: the product's
//     row, the tool's and the friction of rubber on it. `tries`: best candidate first, apart by ;
//     each "strategy end width_mm force_n slip_mm turned_deg neighbour_n"
//
// What the rows cannot say is whether the program still studies as it did:
// tests/unit/grasping/grasp_table_test.cpp tries some of them again.
#pragma once
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/result.h"
#include "catalog/catalog.h"
#include "grasping/grasp_study.h"

namespace marketgen::grasping {

class GraspTable {
 public:
  GraspTable() = default;  // without a row
  // `data` is usually data_folder(). Errors: those of read_file and parse_csv; catalog.bad_row with
  // the line for what is no rate.
  static Result<GraspTable> read(const std::filesystem::path& data);

  // None when there is no row, or when it was made of other rows than these.
  std::optional<GraspRate> find(const catalog::Product& product,
                                const robots::GraspTool& tool,
                                const std::vector<catalog::FrictionRow>& frictions) const;
  std::size_t size() const { return rows_.size(); }

 private:
  struct Row {
    std::string made_of;
    GraspRate rate;
  };
  std::map<std::pair<std::string, std::string>, Row> rows_;  // by SKU and tool
};

// The file of these rates, by SKU and tool. Error catalog.unknown_sku: a rate of a product or tool
// that is not among the given ones.
Result<std::string> grasp_table_text(const std::vector<GraspRate>& rates,
                                     const std::vector<const catalog::Product*>& products,
                                     const std::vector<robots::GraspTool>& tools,
                                     const std::vector<catalog::FrictionRow>& frictions);

}  // namespace marketgen::grasping
