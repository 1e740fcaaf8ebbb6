// How far a store stands as a planogram says: facing by facing, and the price tags.
//
// The share of planned facings that are met. A facing is the width of one pack within its block, on
// its shelf, from front to back. It is met when something stands there and all of its front stack,
// the packs at the foremost place and those on them, is of the planned SKU. Loose goods have no
// columns: their block is met with all its facings when a piece of the SKU lies in it. Items that a
// plan pins to an exact place stand on no shelf here.
#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/fields.h"
#include "scene/planogram_file.h"
#include "scene/scene.h"

namespace marketgen::audit {

// met + missing + wrong_product + misplaced = planned.
struct FacingCounts {
  std::uint64_t planned = 0, met = 0, missing = 0, wrong_product = 0, misplaced = 0;
  static constexpr auto fields = field_list(
      field("planned", &FacingCounts::planned, "facings of the planogram"),
      field("met", &FacingCounts::met, "of them, where the planned product stands in front"),
      field("missing", &FacingCounts::missing, "of them, where nothing stands"),
      field("wrong_product",
            &FacingCounts::wrong_product,
            "of them, where a product stands in front that the planogram has nowhere"),
      field("misplaced",
            &FacingCounts::misplaced,
            "of them, where a product stands in front that the planogram has elsewhere"));
};

// Of the blocks on shelves with a price rail. The counts behind `planned` add up to it.
struct TagCounts {
  std::uint64_t planned = 0, right = 0, missing = 0, wrong_price = 0, wrong_product = 0,
                doubled = 0;
  static constexpr auto fields =
      field_list(field("planned", &TagCounts::planned, "blocks that must have a tag"),
                 field("right", &TagCounts::right, "the one tag before it is its product's"),
                 field("missing", &TagCounts::missing, "no tag hangs before it"),
                 field("wrong_price", &TagCounts::wrong_price, "its product's, of another price"),
                 field("wrong_product", &TagCounts::wrong_product, "another product's"),
                 field("doubled", &TagCounts::doubled, "another tag hangs beside the right one"));
};

struct ShelfCompliance {
  std::string fixture;
  plan::ShelfSide side = plan::ShelfSide::front;
  int shelf = 1;
  double score = 1;
  FacingCounts facings;
  std::uint64_t extra = 0;
  static constexpr auto fields =
      field_list(field("fixture", &ShelfCompliance::fixture, "fixture id"),
                 field("side", &ShelfCompliance::side, "of the fixture"),
                 field("shelf", &ShelfCompliance::shelf, "from the floor up"),
                 field("score", &ShelfCompliance::score, "met / planned; 1 where none is planned"),
                 field("facings", &ShelfCompliance::facings, "planned facings of the shelf"),
                 field("extra", &ShelfCompliance::extra, "packs that stand where none is planned"));
};

struct CategoryCompliance {
  std::string category;
  double score = 1;
  FacingCounts facings;
  static constexpr auto fields =
      field_list(field("category", &CategoryCompliance::category, "of the planned product"),
                 field("score", &CategoryCompliance::score, "met / planned"),
                 field("facings", &CategoryCompliance::facings, "its planned facings"));
};

enum class FacingFault { missing, wrong_product, misplaced };
constexpr std::array<std::string_view, 3> names_of(FacingFault) {
  return {"missing", "wrong_product", "misplaced"};
}

// A planned facing that is not met.
struct UnmetFacing {
  int line = 0;
  std::string fixture;
  plan::ShelfSide side = plan::ShelfSide::front;
  int shelf = 1, position = 1, column = 1;
  std::string sku;
  FacingFault fault = FacingFault::missing;
  std::string stands;
  static constexpr auto fields =
      field_list(field("line", &UnmetFacing::line, "of the planogram's file"),
                 field("fixture", &UnmetFacing::fixture, "fixture id"),
                 field("side", &UnmetFacing::side, "of the fixture"),
                 field("shelf", &UnmetFacing::shelf, "from the floor up"),
                 field("position", &UnmetFacing::position, "of its block on the shelf"),
                 field("column",
                       &UnmetFacing::column,
                       "which facing of the block, from the left; 1 stands for all of loose goods"),
                 field("sku", &UnmetFacing::sku, "planned"),
                 field("fault", &UnmetFacing::fault, "what is wrong"),
                 field("stands", &UnmetFacing::stands, "SKU that stands there; none: empty"));
};

// What `check --planogram` measures.
struct Compliance {
  std::string schema = "market-compliance/1";
  double score = 1, tag_score = 1;
  FacingCounts facings;
  std::uint64_t extra = 0;
  TagCounts tags;
  std::vector<ShelfCompliance> shelves;
  std::vector<CategoryCompliance> categories;
  std::vector<UnmetFacing> unmet;
  static constexpr auto fields = field_list(
      field("schema", &Compliance::schema, "schema tag", constant("market-compliance/1")),
      field("score", &Compliance::score, "facings met / planned; 1 where none is planned"),
      field("tag_score", &Compliance::tag_score, "tags right / planned; 1 where none is planned"),
      field("facings", &Compliance::facings, "planned facings of all shelves that are named"),
      field("extra", &Compliance::extra, "packs on these shelves where none is planned"),
      field("tags", &Compliance::tags, "price tags before the planned blocks"),
      field("shelves", &Compliance::shelves, "each shelf that the planogram names"),
      field("categories", &Compliance::categories, "by the planned products' category"),
      field("unmet", &Compliance::unmet, "facings that are not met"));
};

// `planogram` was read for this scene, with nothing refused.
Compliance compliance_of(const scene::Scene& scene,
                         const scene::PlanogramFile& planogram,
                         const catalog::Catalog& catalog);

}  // namespace marketgen::audit
