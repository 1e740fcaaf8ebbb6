// How often products of the paper's four shapes were brought to where they belong, beside what it
// published of its grasp model in simulation and with a real robot (its table 3): market-shapes/1.
//
// A try of ours is a product that an episode asks for, and it succeeds when it lies in its place at
// the end: seen, chosen, reached, grasped, carried and let go, the whole chain. The paper's try is
// one grasp of a product before the robot. So the shares do not compare one to one, and what is
// compared is how they go with the shape: Pearson's correlation, and the mean maximum rank
// violation (MMRV; Li et al., "Evaluating Real-World Robot Manipulation Policies in Simulation",
// 2024, section 3.2), of shapes instead of policies.
#pragma once
#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/fields.h"
#include "base/result.h"
#include "catalog/catalog.h"
#include "evaluation/figure.h"
#include "evaluation/finished_run.h"
#include "evaluation/published.h"
#include "evaluation/text_table.h"

namespace marketgen::evaluation {

enum class PackShape { bottles, cans, boxes, bags };
constexpr std::array<std::string_view, 4> names_of(PackShape) {
  return {"bottles", "cans", "boxes", "bags"};
}
// By what people call the container (catalog/container_nouns.inc); jars, tubs, trays and loose
// goods are none of the four.
std::optional<PackShape> pack_shape(std::string_view archetype);

struct ShapeFigures {
  PackShape shape = PackShape::bottles;
  int tries = 0;
  Figure share = {};
  static constexpr auto fields =
      field_list(field("shape", &ShapeFigures::shape, "of the packs"),
                 field("tries", &ShapeFigures::tries, "products that were asked for"),
                 field("share", &ShapeFigures::share, "in place at the end, 0..1"));
};

// How shares go together over the shapes that both rows have.
struct ShapesAgreement {
  std::string with;  // place of a published row
  int shapes = 0;
  std::optional<double> pearson = {};  // none where one of them is the same for all shapes
  double mmrv = 0;
  static constexpr auto fields =
      field_list(field("with", &ShapesAgreement::with, "the published row"),
                 field("shapes", &ShapesAgreement::shapes, "that both have"),
                 field("pearson", &ShapesAgreement::pearson, "correlation, -1..1"),
                 field("mmrv", &ShapesAgreement::mmrv, "0: the shapes rank alike; 1 at worst"));
};

struct ShapesRow {
  std::string who;                        // policy, or where it was published of
  std::string commit = {};                // of what was measured here
  std::string source = {};                // of what was published
  std::vector<ShapeFigures> shapes = {};  // those that were tried
  std::vector<ShapesAgreement> agreement = {};
  static constexpr auto fields =
      field_list(field("who", &ShapesRow::who, "policy; of published rows where it was tried"),
                 field("commit", &ShapesRow::commit, "of the program that ran it"),
                 field("source", &ShapesRow::source, "key of who published it; empty: these runs"),
                 field("shapes", &ShapesRow::shapes, "that were tried"),
                 field("agreement", &ShapesRow::agreement, "with published rows"));
};

struct ShapesTable {
  std::string schema = "market-shapes/1";
  std::string version, realism;
  std::vector<ShapesRow> rows;
  std::vector<robots::SourceRow> sources;
  static constexpr auto fields =
      field_list(field("schema", &ShapesTable::schema, "schema tag", constant("market-shapes/1")),
                 field("version", &ShapesTable::version, "of the program"),
                 field("realism", &ShapesTable::realism, "of all runs"),
                 field("rows", &ShapesTable::rows, "measured ones, then published"),
                 field("sources", &ShapesTable::sources, "of published rows"));
};

// Pearson's product-moment correlation; none for fewer than two pairs or where one does not vary.
// Precondition: as many of each.
std::optional<double> pearson(std::span<const double> a, std::span<const double> b);
// The mean, over the entries, of how far the truth of two lies apart at most where the measure puts
// them the other way round. Precondition: as many of each.
double mean_max_rank_violation(std::span<const double> truth, std::span<const double> measure);

// Runs of one policy are one row, whatever their tracks. Errors: usage.bad_flag for no runs;
// results.incomplete; results.not_comparable for runs of other versions or realisms.
Result<ShapesTable> shapes_table(const std::vector<FinishedRun>& runs,
                                 const catalog::Catalog& catalog,
                                 const Published& published);

// In percent, with what was run and sources as notes.
TextTable text_of(const ShapesTable& table);

}  // namespace marketgen::evaluation
