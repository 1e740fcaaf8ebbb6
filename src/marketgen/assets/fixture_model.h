// Fixtures assembled from minimal units: boards, back panels, bases, side panels, uprights, rails,
// doors, bodies.
//
// Fixture frame: origin at the middle of the footprint on the floor, Z up, front towards -Y. A
// double-sided fixture has its second side towards +Y. Metres.
//
// Shelf frame (of one stocked surface): origin at the middle of the front edge on top of the board,
// X to the right for a shopper looking at it, Y inward, Z up from the board. Goods that hang
// (ShelfUse::hang) have no board: Z = 0 is the bottom of their free volume, and their hooks are
// just above Z = clearance_m.
#pragma once
#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "assets/product_model.h"
#include "base/fields.h"
#include "base/result.h"
#include "catalog/catalog.h"
#include "geometry/mesh.h"
#include "geometry/pose.h"

namespace marketgen {

// The kinds of minimal unit: what a part is, for queries, exports and collision.
enum class UnitKind {
  board,
  back_panel,
  base,
  side_panel,
  upright,
  price_rail,
  fence,
  header,
  worktop,
  body,
  door,
  door_frame,
  light,
  belt,
  scanner,
  screen,
  terminal,
  tray,
  basket,
  wheel,
  handle,
  cushion,
  pole,
  sign,
  hook,
  drawer,
  lid,
  button,
  knob,
  lever
};
constexpr std::array<std::string_view, 30> names_of(UnitKind) {
  return {"board",  "back_panel", "base",    "side_panel", "upright",  "price_rail",
          "fence",  "header",     "worktop", "body",       "door",     "door_frame",
          "light",  "belt",       "scanner", "screen",     "terminal", "tray",
          "basket", "wheel",      "handle",  "cushion",    "pole",     "sign",
          "hook",   "drawer",     "lid",     "button",     "knob",     "lever"};
}

enum class PartShape { box, cylinder };  // cylinder: axis Z before tilt
constexpr std::array<std::string_view, 2> names_of(PartShape) {
  return {"box", "cylinder"};
}

// What can move on a fixture, and how.
enum class JointKind {
  hinge,  // turns about the joint frame's Z axis; radians
  slide,  // moves along it; metres
  belt    // its parts stand still and their upper surface runs along it; metres per second
};
constexpr std::array<std::string_view, 3> names_of(JointKind) {
  return {"hinge", "slide", "belt"};
}

struct JointState {
  std::string name;  // "closed", "open", "ajar", "pressed"
  double position = 0;

  static constexpr auto fields =
      field_list(field("name", &JointState::name, "what people call it", identifier()),
                 field("position", &JointState::position, "radians, metres or metres per second"));
};

// One degree of freedom. Position 0 is how the parts are modelled (closed, at rest).
struct FixtureJoint {
  std::string name;  // unique within the fixture: "door-1", "drawer", "lever"
  JointKind kind = JointKind::hinge;
  int parent = -1;          // joint that carries this one, or -1: the fixture's body
  Pose fixture_from_joint;  // at position 0; axis Z
  double lower = 0, upper = 0;
  double friction = 0;   // dry friction, N m or N
  double damping = 0;    // N m s/rad or N s/m
  double stiffness = 0;  // spring towards `spring_rest`, N m/rad or N/m: what makes it close itself
  double spring_rest = 0;
  double hold_open = 0;  // position from which it stays open by itself; 0: nowhere
  // What a magnetic gasket holds it shut with at position 0, N m, and the position at which that
  // has gone; 0: it has none.
  double gasket = 0, gasket_reach = 0;
  double mass_kg = 1;              // of everything that moves with it
  std::vector<JointState> states;  // named positions within the limits, "closed" first
};

struct FixturePart {
  UnitKind unit = UnitKind::board;
  PartShape shape = PartShape::box;
  Pose fixture_from_part;  // to the part's centre, every joint at position 0
  Vec3f half_size;         // cylinder: radius, radius, half length
  Surface surface;         // texture is a material id or empty
  int joint = -1;          // row in FixtureModel::joints that moves it, or -1: fixed
};

// What a shelf is for: goods stand in facings, lie in a heap, or hang from pegs.
enum class ShelfUse { stand, heap, hang };
constexpr std::array<std::string_view, 3> names_of(ShelfUse) {
  return {"stand", "heap", "hang"};
}

struct ShelfSurface {
  int level = 0;  // 0 = lowest
  int side = 0;   // 1 = the back of a double-sided fixture
  ShelfUse use = ShelfUse::stand;
  Pose fixture_from_shelf;
  double width_m = 0, depth_m = 0;  // usable
  double clearance_m = 0;           // free height above the board over the whole usable area
  bool price_rail = true;           // its front edge takes price labels
};

// Where things meet a shelf, in its frame. Every shelf with a price rail has its rail's face at Y =
// price_rail_face_m, between the two heights; goods start goods_front_m behind the board's front
// edge, so that nothing leans on a label.
constexpr double goods_front_m = 0.010;
constexpr double price_rail_face_m = -0.006;
constexpr double price_rail_top_m = 0.002, price_rail_bottom_m = -0.038;

// Parameters of one module. To change any of them after generation, make the model again: equal
// shapes give equal models.
struct FixtureShape {
  std::string generator;  // one of assets/fixture_generators.inc
  int width_mm = 1250, depth_mm = 500, height_mm = 1800;
  int levels = 5, base_mm = 150, spacing_mm = 350;
  int sides = 1;
  bool start = true,
       end = true;  // closes the run on its left, on its right: side panels stand there
  std::string material = "metal-white";  // catalogue material of the body
  std::string color = "#f2f2f0";
  std::string accent = "#2e7d32";  // header bands, signs
  // Shelves. Generators without such shelves pay no heed to them.
  std::vector<int> spacings_mm{};  // from each level to the next, lowest first; then spacing_mm
  int board_mm = 25;               // thickness, 12 to 60
  double shelf_tilt_deg = 0;       // shelves over the base slope to the shopper, 0 to 25
  int fence_mm = 0;                // bar along the front edges, this high over the board; 0: none
  int header_mm = -1;              // band along the top, this high; -1: the generator's usual
};

struct FixtureModel {
  std::vector<FixturePart> parts;     // none overlaps another by more than 0.5 mm
  std::vector<ShelfSurface> shelves;  // by side, then level
  std::vector<FixtureJoint> joints;   // parents before children
};

// Everything lies within the module's width x depth x height. Errors: catalog.unknown_kind,
// assets.bad_row.
Result<FixtureModel> make_fixture_model(const FixtureShape& shape, const Catalog& catalog);

struct FixtureGeneratorInfo {
  std::string_view name, description;
};
std::vector<FixtureGeneratorInfo> fixture_generators();

// The visible mesh of one part in the fixture frame (boxes with a 2 mm bevel where they are thick
// enough), metric UVs.
void add_part_mesh(Mesh& mesh, const FixturePart& part, std::uint16_t surface);

}  // namespace marketgen
