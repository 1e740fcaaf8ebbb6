// market-patch/1: changes of a plan, from a closed list of operations.
//
// The one form in which a plan is changed, whoever asks for it: `marketgen edit`, words, repair
// moves, a language model. A patch says what to change and leaves everything else as it is;
// patches.inc lists the operations. In JSON a patch is an object with one field, the operation:
//
//   {"schema": "market-patch/1", "patches": [{"set_ratio": {"node": "back", "ratio": 0.4}},
//                                            {"set_fixture": {"zone": "dairy", "levels": 6}}]}
//
// Nodes keep their ids, so that several patches in a row may name them.
#pragma once
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/fields.h"
#include "base/result.h"
#include "catalog/catalog.h"
#include "plan/plan.h"

namespace marketgen::plan {

// A field that changes the field of that name in `Owner`: its limits and meaning are the owner's.
// Left out, it changes nothing.
template <class Owner, class Change, class Member>
constexpr Field<Change, Member> changes(std::string_view name, Member Change::*member) {
  Field<Change, Member> made{name, member, {}, {}};
  Owner::fields([&](const auto& owned) {
    if (owned.name != name) return;
    made.doc = owned.doc;
    made.rules = owned.rules;
  });
  made.rules.required = false;
  return made;
}

// Names of fields to be taken back to what is usual.
using UsualFields = std::optional<std::vector<std::string>>;
constexpr std::string_view usual_doc = "fields that shall be as usual again, by name";

struct SetRatio {
  std::string node;
  double ratio = 0.5;
  static constexpr auto fields =
      field_list(field("node", &SetRatio::node, "an inner node", required(), reference()),
                 field("ratio",
                       &SetRatio::ratio,
                       "first child's share after the gap is taken off",
                       range(0.08, 0.92),
                       required()));
};

struct SetAxis {
  std::string node;
  Axis split = Axis::x;
  static constexpr auto fields = field_list(
      field("node", &SetAxis::node, "an inner node", required(), reference()),
      field("split", &SetAxis::split, "y: first child south, x: first child west", required()));
};

struct SetGap {
  std::string node;
  int gap_mm = 0;
  static constexpr auto fields = field_list(
      field("node", &SetGap::node, "an inner node", required(), reference()),
      field("gap_mm", &SetGap::gap_mm, "aisle between the children", range(0, 8000), required()));
};

struct SwapLeaves {
  std::string a, b;
  static constexpr auto fields =
      field_list(field("a", &SwapLeaves::a, "a zone", required(), reference()),
                 field("b", &SwapLeaves::b, "another", required(), reference()));
};

// Where a zone is put: it takes a share of the floor of `beside`, on that side of it.
struct MoveLeaf {
  std::string zone, beside;
  Wall side = Wall::north;
  std::optional<double> share;
  std::optional<int> gap_mm;
  static constexpr auto fields =
      field_list(field("zone", &MoveLeaf::zone, "the zone that moves", required(), reference()),
                 field("beside", &MoveLeaf::beside, "a zone or a node", required(), reference()),
                 field("side", &MoveLeaf::side, "where it lies from there", required()),
                 field("share",
                       &MoveLeaf::share,
                       "of that floor; left out: as much floor as it had, at most 0.6",
                       range(0.08, 0.92)),
                 field("gap_mm",
                       &MoveLeaf::gap_mm,
                       "aisle between the two; left out: as at its old place",
                       range(0, 8000)));
};

struct SplitLeaf {
  std::string zone, part;
  Wall side = Wall::east;
  double share = 0.5;
  std::optional<int> gap_mm;
  static constexpr auto fields = field_list(
      field("zone", &SplitLeaf::zone, "the zone to cut", required(), reference()),
      field("part", &SplitLeaf::part, "id of the new zone", identifier()),
      field("side", &SplitLeaf::side, "where the new zone lies", required()),
      field("share", &SplitLeaf::share, "the new zone's, of the floor", range(0.08, 0.92)),
      field("gap_mm",
            &SplitLeaf::gap_mm,
            "aisle between the two; left out: the profile's main aisle",
            range(0, 8000)));
};

struct Merge {
  std::string zone, into;
  static constexpr auto fields = field_list(
      field("zone", &Merge::zone, "the zone that goes", required(), reference()),
      field("into", &Merge::into, "the one that gets its floor", required(), reference()));
};

struct AddZone {
  Zone zone;
  std::string beside;
  Wall side = Wall::east;
  double share = 0.3;
  std::optional<int> gap_mm;
  static constexpr auto fields = field_list(
      field("zone", &AddZone::zone, "the new zone", required()),
      field("beside", &AddZone::beside, "a zone or a node", required(), reference()),
      field("side", &AddZone::side, "where the new zone lies from there", required()),
      field("share", &AddZone::share, "the new zone's, of that floor", range(0.08, 0.92)),
      field("gap_mm",
            &AddZone::gap_mm,
            "aisle between the two; left out: the profile's main aisle",
            range(0, 8000)));
};

struct DropZone {
  std::string zone;
  static constexpr auto fields =
      field_list(field("zone", &DropZone::zone, "the zone that goes", required(), reference()));
};

struct SetFixture {
  std::string zone;
  std::optional<std::string> kind;
  std::optional<bool> double_sided;
  std::optional<Endcaps> endcaps;
  std::optional<RunAxis> axis;
  std::optional<int> module_mm, depth_mm, height_mm, levels, spacing_mm, run_max_mm, aisle_mm,
      count;
  std::optional<std::string> color, material;
  UsualFields usual;
  static constexpr auto fields =
      field_list(field("zone", &SetFixture::zone, "whose fixtures", required(), reference()),
                 changes<FixtureSpec>("kind", &SetFixture::kind),
                 changes<FixtureSpec>("double_sided", &SetFixture::double_sided),
                 changes<FixtureSpec>("endcaps", &SetFixture::endcaps),
                 changes<FixtureSpec>("axis", &SetFixture::axis),
                 changes<FixtureSpec>("module_mm", &SetFixture::module_mm),
                 changes<FixtureSpec>("depth_mm", &SetFixture::depth_mm),
                 changes<FixtureSpec>("height_mm", &SetFixture::height_mm),
                 changes<FixtureSpec>("levels", &SetFixture::levels),
                 changes<FixtureSpec>("spacing_mm", &SetFixture::spacing_mm),
                 changes<FixtureSpec>("run_max_mm", &SetFixture::run_max_mm),
                 changes<FixtureSpec>("aisle_mm", &SetFixture::aisle_mm),
                 changes<FixtureSpec>("count", &SetFixture::count),
                 changes<FixtureSpec>("color", &SetFixture::color),
                 changes<FixtureSpec>("material", &SetFixture::material),
                 field("usual", &SetFixture::usual, usual_doc, at_most_items(14)));
};

struct SetStock {
  std::string zone;
  std::optional<std::vector<std::string>> categories, exclude, must_stock;
  std::optional<double> fill;
  std::optional<IntRange> facings;
  std::optional<BlockPattern> block;
  std::optional<double> depth_fill, jitter, out_of_stock, misplaced;
  std::optional<PriceTagSpec> price_tags;
  UsualFields usual;
  static constexpr auto fields =
      field_list(field("zone", &SetStock::zone, "whose goods", required(), reference()),
                 changes<StockSpec>("categories", &SetStock::categories),
                 changes<StockSpec>("exclude", &SetStock::exclude),
                 changes<StockSpec>("must_stock", &SetStock::must_stock),
                 changes<StockSpec>("fill", &SetStock::fill),
                 changes<StockSpec>("facings", &SetStock::facings),
                 changes<StockSpec>("block", &SetStock::block),
                 changes<StockSpec>("depth_fill", &SetStock::depth_fill),
                 changes<StockSpec>("jitter", &SetStock::jitter),
                 changes<StockSpec>("out_of_stock", &SetStock::out_of_stock),
                 changes<StockSpec>("misplaced", &SetStock::misplaced),
                 changes<StockSpec>("price_tags", &SetStock::price_tags),
                 field("usual", &SetStock::usual, usual_doc, at_most_items(11)));
};

struct MoveOpening {
  std::string opening;
  std::optional<Wall> wall;
  std::optional<double> center;
  std::optional<int> width_mm;
  static constexpr auto fields = field_list(
      field("opening", &MoveOpening::opening, "a door or window", required(), reference()),
      changes<Opening>("wall", &MoveOpening::wall),
      changes<Opening>("center", &MoveOpening::center),
      changes<Opening>("width_mm", &MoveOpening::width_mm));
};

struct AddOpening {
  Opening opening;
  static constexpr auto fields =
      field_list(field("opening", &AddOpening::opening, "the new door or window", required()));
};

struct SetLook {
  std::optional<std::string> floor, wall, ceiling, fixture, accent;
  std::optional<int> light_kelvin, light_lux;
  std::optional<catalog::LampFitting> lamps;
  std::optional<double> daylight;
  std::optional<bool> neon;
  UsualFields usual;
  static constexpr auto fields =
      field_list(changes<Look>("floor", &SetLook::floor),
                 changes<Look>("wall", &SetLook::wall),
                 changes<Look>("ceiling", &SetLook::ceiling),
                 changes<Look>("fixture", &SetLook::fixture),
                 changes<Look>("accent", &SetLook::accent),
                 changes<Look>("light_kelvin", &SetLook::light_kelvin),
                 changes<Look>("light_lux", &SetLook::light_lux),
                 changes<Look>("lamps", &SetLook::lamps),
                 changes<Look>("daylight", &SetLook::daylight),
                 changes<Look>("neon", &SetLook::neon),
                 field("usual", &SetLook::usual, usual_doc, at_most_items(10)));
};

// Openings move by move_opening.
struct SetShell {
  std::optional<int> width_mm, depth_mm, ceiling_mm;
  std::optional<PolygonMm> outline_mm;
  std::optional<std::vector<Column>> columns;
  UsualFields usual;
  static constexpr auto fields =
      field_list(changes<Shell>("width_mm", &SetShell::width_mm),
                 changes<Shell>("depth_mm", &SetShell::depth_mm),
                 changes<Shell>("ceiling_mm", &SetShell::ceiling_mm),
                 changes<Shell>("outline_mm", &SetShell::outline_mm),
                 changes<Shell>("columns", &SetShell::columns),
                 field("usual", &SetShell::usual, usual_doc, at_most_items(5)));
};

// Left out: no time again.
struct SetTime {
  std::optional<std::string> time;
  static constexpr auto fields = field_list(changes<Plan>("time", &SetTime::time));
};

struct SetRelation {
  RelationKind kind = RelationKind::near;
  std::string a, b;
  std::optional<std::string> c;
  Strength strength = Strength::prefer;
  bool drop = false;
  static constexpr auto fields =
      field_list(field("kind", &SetRelation::kind, "the relation", required()),
                 field("a", &SetRelation::a, "what is placed", required(), reference()),
                 field("b", &SetRelation::b, "what it relates to", required(), reference()),
                 changes<Relation>("c", &SetRelation::c),
                 changes<Relation>("strength", &SetRelation::strength),
                 field("drop", &SetRelation::drop, "takes the relation back"));
};

struct SetOverride {
  std::string fixture, field_name;
  std::optional<std::string> value;
  static constexpr auto fields = field_list(
      field("fixture", &SetOverride::fixture, "its id", required(), reference()),
      field("field",
            &SetOverride::field_name,
            "levels, height_mm, color, material or kind; x_mm or y_mm: its middle, with its run",
            required()),
      field("value", &SetOverride::value, "the value as text; left out: its own again"));
};

// The goods of one shelf.
struct ShelfChange {
  std::string fixture;
  ShelfSide side = ShelfSide::front;
  int shelf = 1;
  std::optional<std::vector<ShelfBlock>> blocks;
  static constexpr auto fields = field_list(
      field("fixture", &ShelfChange::fixture, "fixture id in the layout", required(), reference()),
      changes<StockedShelf>("side", &ShelfChange::side),
      field("shelf", &ShelfChange::shelf, "from the floor up", range(1, 100), required()),
      field("blocks",
            &ShelfChange::blocks,
            "from left to right; none: the shelf stays empty; left out: what its zone "
            "would put there",
            at_most_items(200)));
};

struct StockShelves {
  std::vector<ShelfChange> shelves;
  static constexpr auto fields = field_list(field("shelves",
                                                  &StockShelves::shelves,
                                                  "each with all that it holds",
                                                  required(),
                                                  at_most_items(max_planogram_shelves)));
};

// A block of one product, by where it stands.
struct BlockPlace {
  std::string fixture;
  ShelfSide side = ShelfSide::front;
  int shelf = 1, position = 1;
  std::optional<std::string> sku;
  std::optional<int> facings;
  static constexpr auto fields = field_list(
      field("fixture", &BlockPlace::fixture, "fixture id in the layout", required(), reference()),
      changes<StockedShelf>("side", &BlockPlace::side),
      field("shelf", &BlockPlace::shelf, "from the floor up", range(1, 100), required()),
      field("position", &BlockPlace::position, "from the left", range(1, 200), required()),
      field("sku", &BlockPlace::sku, "the product that stands there, to be sure", reference()),
      field("facings",
            &BlockPlace::facings,
            "packs side by side where it comes to stand; left out: as many as before",
            range(1, 200)));
};

struct SwapBlocks {
  BlockPlace a, b;
  static constexpr auto fields = field_list(field("a", &SwapBlocks::a, "a block", required()),
                                            field("b", &SwapBlocks::b, "another", required()));
};

// Exactly one operation.
struct Patch {
#define PLAN_PATCH(name, Type, what) std::optional<Type> name;
#include "plan/patches.inc"
#undef PLAN_PATCH

  static constexpr auto fields = [](auto&& visit) {
#define PLAN_PATCH(name, Type, what) visit(field(#name, &Patch::name, what));
#include "plan/patches.inc"
#undef PLAN_PATCH
  };
};

constexpr std::size_t max_patches = 200;

struct PatchSet {
  std::string schema = "market-patch/1";
  std::vector<Patch> patches;  // carried out one after the other
  static constexpr auto fields =
      field_list(field("schema", &PatchSet::schema, "schema tag", constant("market-patch/1")),
                 field("patches",
                       &PatchSet::patches,
                       "one operation each, carried out in this order",
                       required(),
                       at_most_items(max_patches)));
};

// A plan after a patch.
struct Patched {
  Plan plan;
  std::vector<std::string> paths;  // JSON pointers into it: what was changed
};

// The name of the patch's operation, as in JSON; empty when it has none.
std::string_view operation_of(const Patch& patch);

// The plan with that change. Whether the outcome is a valid plan is not looked at: for callers that
// validate themselves (repair). `where` is the patch's place in errors: "/patches/0". Errors:
// plan.unknown_reference for zones, nodes and openings that the plan does not have,
// plan.bad_value for what cannot be done, json.* for values outside their limits.
Result<Patched> patched(const Plan& plan,
                        const Patch& patch,
                        const catalog::Catalog& catalog,
                        const std::string& where);

// All patches, one after the other, each outcome validated. `by` is written into the provenance of
// what they changed; `source` names the file in errors ("shelves.json:/patches/0/set_ratio/node").
// Errors also: plan.bad_value when two patches set the same value differently.
Result<Plan> apply_patches(const Plan& plan,
                           const PatchSet& set,
                           const std::string& source,
                           Source by,
                           const catalog::Catalog& catalog);

// Reads a patch set; every patch has one operation.
Result<PatchSet> read_patches(std::string_view text, const std::string& source);

}  // namespace marketgen::plan
