// One grasp tried in physics: a tool without an arm comes, closes, lifts, shakes and puts down, and
// what became of the product is read from the simulation.
//
// The tool's base moves exactly as told (the arm is taken for stiff); its fingers are bodies that
// slide, driven by a force and coupled as the row couples them. A cup is not a force that pulls at
// any distance: it seals where rays find the face even enough, holds by three points of its lip,
// and lets go as soon as one of them, or friction, would have to hold more than its share.
//
// Products are what physics/goods makes of them where the trial is: on a shelf the bodies of
// Worlds, in a basket those of checkouts. They are rigid, but for a target that is given as a soft
// pack: its pieces are cut where it bends. World frame: the target's product frame as it stands at
// first; in a basket, the basket's. SI units. Deterministic; thread-safe.
#pragma once
#include <array>
#include <string_view>

#include "base/result.h"
#include "base/seed.h"
#include "physics/goods/goods_body.h"
#include "physics/settle/bulk_settle.h"
#include "physics/soft/soft_pack.h"
#include "robots/grasp_tool.h"

namespace marketgen::grasping {

// free: alone on a table. stocked: in the front row of a full shelf, 2 to 8 mm from either
// neighbour, 3 mm from the one behind, 30 to 50 mm under the next board; the columns reach to the
// back panel and the row to dividers six facings away. spaced: the same with gaps of 30 mm between
// facings. basket: among its likes in an open container in which they have settled.
enum class GraspSetting { free, stocked, spaced, basket };
constexpr std::array<std::string_view, 4> names_of(GraspSetting) {
  return {"free", "stocked", "spaced", "basket"};
}

// A container with packs of one product that lie in it, the target first.
struct BasketOfLikes {
  physics::OpenContainer container;
  std::vector<Pose> container_from_product;
};

// Least height between a pack on the shelf and the board above.
constexpr double min_headroom_m = 0.030;
constexpr double spaced_gap_m = 0.030;

enum class GraspEnd {
  held,       // lifted, shaken, and put down where there is a table to put it
  unstable,   // the product does not stand by itself, or does not lie still
  collided,   // the tool pressed on shelf, table or basket
  missed,     // the pads did not both touch it, or the cup did not seal
  dropped,    // it came out of the tool
  slipped,    // held, but it moved under the pads by more than the limit
  fell_over,  // held, but it did not stay where it was put
  pressed,    // held, but a neighbour was pressed by more than the limit
  toppled     // held, but a neighbour fell over or off the shelf
};
constexpr std::array<std::string_view, 9> names_of(GraspEnd) {
  return {"held",
          "unstable",
          "collided",
          "missed",
          "dropped",
          "slipped",
          "fell_over",
          "pressed",
          "toppled"};
}

// ---- Limits of a success. ----
constexpr double max_slip_m = 0.001;
constexpr double max_neighbour_n = 50;  // mean over 10 ms

// What the product is in a trial of the setting.
constexpr physics::GoodsUse use_of(GraspSetting setting) {
  if (setting == GraspSetting::free) return physics::GoodsUse::single;
  return setting == GraspSetting::basket ? physics::GoodsUse::bulk : physics::GoodsUse::stocked;
}

struct GraspTrial {
  const physics::GoodsBody& goods;  // of use_of(setting)
  const robots::GraspTool& tool;
  robots::Grasp grasp;
  double pad_friction = 0.5;  // of pads or lip on the product
  GraspSetting setting = GraspSetting::free;
  Seed seed{1};  // of gaps, headroom and the error with which the tool comes
  const BasketOfLikes* basket = nullptr;  // of the setting `basket`
  const physics::SoftPack* soft =
      nullptr;  // how the target bends, for a gripper; null: it is rigid
};

struct GraspOutcome {
  GraspEnd end = GraspEnd::held;
  // Of the product under the pads' middles and corners, or under the cup, from when the tool has
  // closed to the end of the shaking: the greatest. Of a soft pack, of the part on which the pads
  // press hardest when they have closed.
  double slip_m = 0;
  double turned_rad = 0;   // of the product (of that part) in the tool meanwhile
  double neighbour_n = 0;  // greatest push on a neighbour
  double squeeze_n = 0;    // on the weaker pad, at the end of the shaking
};

// The tool's error: up to so much along each axis and about Z, uniform.
constexpr double tool_error_m = 0.001, tool_error_rad = 0.01745;

// Whether a product stands by itself: let go leaning by 1 degree to the front, the back or a side,
// it comes to rest upright. Loose produce counts as standing. `soft`: as in GraspTrial. Errors: as
// try_grasp.
Result<bool> stands_alone(const physics::GoodsBody& goods,
                          const robots::GraspTool& tool,
                          const physics::SoftPack* soft = nullptr);

// Errors: catalog.bad_row for a product without mass or size; motion.bad_configuration for a grasp
// that the tool cannot make (wider than its opening, stronger than its force, not finite) and for
// the setting `basket` without a basket or target; physics.bad_command for a container without
// room; physics.failed. A soft pack for a cup is motion.bad_configuration as well.
Result<GraspOutcome> try_grasp(const GraspTrial& trial);

}  // namespace marketgen::grasping
