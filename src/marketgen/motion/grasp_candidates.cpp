#include "motion/grasp_candidates.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "base/gravity.h"
#include "geometry/rotation_axes.h"
#include "motion/grasp_room.h"
#include "motion/grasp_seeds.h"
#include "motion/grasp_surface.h"

namespace marketgen::motion {
namespace {

constexpr double outside_m = 2;           // from where pads look at the pack: no pack is as long
constexpr double patch_radius_m = 0.005;  // of a point contact, as MuJoCo's torsional friction
constexpr double line_half_m = 0.001;     // least half width of what soft pads touch
constexpr std::array back_off_m = {0.0, 0.010, 0.020};  // against the approach, for the palm's sake
constexpr double apart_m = 0.015, apart_cosine = 0.9;   // what counts as another candidate
// A cup may come to lie so far from where it was sent.
constexpr double lip_margin_m = 0.002;
constexpr double part_reach_m = 0.004;  // how far under or over the lip a part may be felt
// A cup that only just holds lets go at the first jerk.
constexpr double suction_safety = 1.3;
constexpr double from_front_cosine = 0.5;                  // 60 degrees
constexpr double from_above_cosine = 0.42261826174069944;  // 65 degrees
// Packs that a full grip would crush are held with twice what holds them, at least with so much.
constexpr double gentle_force_n = 20, gentle_safety = 2;

// Weights of a gripper's score: how far the force it needs is from what the tool has, how much of
// the pads touches, how well opposed they are, how much room there is.
constexpr double hold_weight = 0.4, share_weight = 0.25, cone_weight = 0.15, room_weight = 0.2;
constexpr double roomy_m = 0.02;
// Taken off for reaching into neighbours by as much as the thickness of a finger, or by as much as
// the tool may reach into packs that lie round about.
constexpr double neighbour_weight = 0.5, finger_thick_m = 0.03;

struct Refused {
  GraspRefusal refusal = GraspRefusal::none;
  double figure =
      0;  // width, moment share or unevenness: the least over the seeds that came so far
};

// A grasp, or why it is none.
struct Tried {
  std::optional<GraspCandidate> candidate = {};
  Refused refused = {};
};
Tried refuse(GraspRefusal why, double figure = 0) {
  return {std::nullopt, {why, figure}};
}

class Search {
 public:
  Search(const catalog::Product& product,
         const assets::ProductBody& body,
         const robots::GraspTool& tool,
         const GraspQuery& query)
      : product_(product),
        body_(body),
        tool_(tool),
        query_(query),
        up_(rotate(inverse(query.world_from_product.rotation), {0, 0, 1})),
        surface_(body.pieces),
        room_(product, tool, query, surface_) {}

  GraspCandidates find() {
    if (tool_.kind == robots::ToolKind::gripper) {
      for (const PinchSeed& seed : places_to_pinch())
        if (wanted(seed.approach)) note(pinch(seed));
    } else {
      for (const SuctionSeed& seed : places_to_suck())
        if (wanted(seed.travel)) note(suck(seed));
    }
    std::ranges::stable_sort(found_, std::ranges::greater{}, &GraspCandidate::score);
    GraspCandidates answer;
    for (const GraspCandidate& candidate : found_) {
      if (answer.found.size() < query_.most && is_new(candidate, answer.found))
        answer.found.push_back(candidate);
    }
    if (answer.found.empty()) {
      const bool unreached = worst_.refusal == GraspRefusal::none;
      answer.refusal = unreached ? GraspRefusal::no_room : worst_.refusal;
      answer.reason = sentence();
    }
    return answer;
  }

  std::vector<CheckedPinch> check(const std::vector<PinchProposal>& proposals) const {
    std::vector<CheckedPinch> checked;
    for (std::size_t i = 0; i < proposals.size(); ++i) {
      const auto& [center, approach, closing] = proposals[i];
      if (!wanted(approach)) continue;
      const Tried tried = pinch({strategy_from_above(approach, up_), center, approach, closing});
      if (tried.candidate) checked.push_back({i, *tried.candidate});
    }
    return checked;
  }

 private:
  std::vector<PinchSeed> places_to_pinch() const {
    return query_.from_above ? pinch_seeds_from_above(body_, surface_, up_)
                             : pinch_seeds(body_, surface_, tool_);
  }
  std::vector<SuctionSeed> places_to_suck() const {
    return query_.from_above ? suction_seeds_from_above(body_, surface_, up_)
                             : suction_seeds(body_, surface_);
  }

  bool wanted(Vec3 approach) const {
    if (query_.from_above && -dot(approach, up_) < from_above_cosine) return false;
    return !query_.from_front || approach.y >= from_front_cosine;
  }

  void note(Tried tried) {
    if (tried.candidate) {
      found_.push_back(std::move(*tried.candidate));
    } else if (tried.refused.refusal > worst_.refusal) {
      worst_ = tried.refused;
    } else if (tried.refused.refusal == worst_.refusal) {
      worst_.figure = std::min(worst_.figure, tried.refused.figure);
    }
  }

  static bool is_new(const GraspCandidate& candidate, const std::vector<GraspCandidate>& others) {
    return std::ranges::none_of(others, [&](const GraspCandidate& other) {
      const Pose &a = candidate.grasp.product_from_tool, &b = other.grasp.product_from_tool;
      const auto turned = [&](Vec3 axis) {
        return dot(rotate(a.rotation, axis), rotate(b.rotation, axis));
      };
      return length(a.position - b.position) < apart_m && turned({0, 0, 1}) > apart_cosine &&
             std::abs(turned({0, 1, 0})) > apart_cosine;
    });
  }

  // ---- Grippers ----

  Tried pinch(const PinchSeed& seed) const {
    Tried last;
    for (const double back : back_off_m) {
      PinchSeed moved = seed;
      moved.center = seed.center - seed.approach * back;
      last = pinch_at(moved);
      if (last.candidate || last.refused.refusal != GraspRefusal::no_room) break;
    }
    return last;
  }

  Tried pinch_at(const PinchSeed& seed) const {
    const Vec3 c = seed.closing, a = seed.approach, x = cross(c, a);
    const double start = seed.inside ? tool_.opening_m / 2 : outside_m;
    const double max_width = tool_.opening_m - 2 * query_.finger_gap_m;
    const auto line_end = [&](Vec3 way) {
      return surface_.first_hit(seed.center + way * start, -way);
    };
    const auto left_end = line_end(c), right_end = line_end(-c);
    if (!left_end || !right_end) return refuse(GraspRefusal::none);
    const double least = 2 * start - left_end->distance_m - right_end->distance_m;
    if (least > max_width) return refuse(GraspRefusal::too_wide, least);

    const auto pad = [&](Vec3 way) {
      return surface_.pad_contact(
          seed.center + way * start, -way, x, a, tool_.pad_x_m, tool_.pad_z_m);
    };
    const auto left = pad(c), right = pad(-c);
    if (!left || !right) return refuse(GraspRefusal::none);
    const double width = 2 * start + left->height_m + right->height_m;
    if (width > max_width) return refuse(GraspRefusal::too_wide, width);
    if (!(width > 0) || !opposed(*left, *right, c)) return refuse(GraspRefusal::not_opposed);

    return pinched({seed, *left, *right, width});
  }

  // Pads that touch the pack on opposite sides.
  struct Pinch {
    const PinchSeed& seed;
    const PadContact &left, &right;
    double width_m;
  };

  // The grasp, if it holds the pack and the tool has room for it.
  Tried pinched(const Pinch& pinch) const {
    const auto& [seed, left, right, width] = pinch;
    const Vec3 c = seed.closing, a = seed.approach;
    const Vec3 middle = seed.center + c * ((left.height_m - right.height_m) / 2);
    const double slides = sliding_need_n(left, right, c);
    const double turns = turning_need_n(middle, c, cross(c, a), left, right);
    const double need = std::max(slides, turns);
    if (need > tool_.force_n)
      return refuse(slides > turns ? GraspRefusal::not_opposed : GraspRefusal::turns,
                    need / tool_.force_n);
    GraspCandidate made{.tool = tool_.kind, .strategy = seed.strategy, .width_m = width};
    made.swing_n = swing_need_n(middle, c, left, right);
    made.grasp.product_from_tool.rotation = rotation_with_axes(c, a);
    made.grasp.product_from_tool.position =
        middle - rotate(made.grasp.product_from_tool.rotation, tool_.pad_center);
    made.grasp.force_n =
        product_.rigidity == catalog::Rigidity::rigid
            ? tool_.force_n
            : std::min(tool_.force_n, std::max(gentle_force_n, gentle_safety * need));
    if (!make_room(made)) return refuse(GraspRefusal::no_room);
    made.side_room_m = side_room_of(made);
    const double share = std::min(1.0, 4 * std::min(left.share, right.share));
    made.score = hold_weight * (1 - need / tool_.force_n) + share_weight * share +
                 cone_weight * facing(left, right, c) +
                 room_weight * std::min(1.0, made.clearance_m / roomy_m) -
                 neighbour_weight * reach_into_likes(made.grasp);
    return {made, {}};
  }

  // As wide open as the pack asks for, or else as wide as the tool opens (a lid may stand out above
  // what is held). False when neither has room, there and on the way.
  bool make_room(GraspCandidate& made) const {
    for (const double opening :
         {std::min(tool_.opening_m, made.width_m + 2 * query_.finger_gap_m), tool_.opening_m}) {
      made.grasp.opening_m = opening;
      if (!room_.is_free(made.grasp)) continue;
      made.clearance_m = room_.clearance_of(made.grasp);
      return room_.pads_touch_first(made.grasp, made.width_m);
    }
    return false;
  }

  // 0..1. Beside a standing pack its likes make way to the side; among packs that lie, less may be
  // asked of them.
  double reach_into_likes(const robots::Grasp& grasp) const {
    const double most = query_.likes.empty() ? finger_thick_m : max_like_overlap_m;
    return std::min(1.0, room_.overlap_with_likes(grasp) / most);
  }

  // Least cosine between the contacts' normals and the closing direction.
  static double facing(const PadContact& left, const PadContact& right, Vec3 closing) {
    return std::min(dot(left.normal, closing), -dot(right.normal, closing));
  }

  bool opposed(const PadContact& left, const PadContact& right, Vec3 closing) const {
    const double cone = 1 / std::sqrt(1 + query_.friction * query_.friction);  // cosine of its half
    const Vec3 between = normalized(left.center - right.center);
    return facing(left, right, closing) > cone && dot(between, closing) >= cone;
  }

  // Force that holds the pack while it is moved. Faces that lean by an angle leave of the friction
  // angle only the rest: the pads push the pack out of themselves.
  double sliding_need_n(const PadContact& left, const PadContact& right, Vec3 closing) const {
    const double lean = std::acos(std::min(1.0, facing(left, right, closing)));
    return pinch_force_n(product_.mass_kg, std::tan(std::atan(query_.friction) - lean));
  }

  // Force at which the pads keep the pack from turning: about the closing direction by the friction
  // of what they touch, across it by how far what they touch reaches. Moved across the pads, a pack
  // swings about them as far from them as its middle of mass lies.
  double turning_need_n(
      Vec3 middle, Vec3 closing, Vec3 x, const PadContact& left, const PadContact& right) const {
    const Vec3 arm = to_double(body_.center_of_mass) - middle;
    const Vec3 across = arm - closing * dot(arm, closing);
    const Vec3 level = across - up_ * dot(across, up_);
    const double lever = length(level - closing * dot(level, closing));
    const double turning = (standard_gravity * lever + carry_acceleration_m_s2 * length(across)) /
                           (query_.friction * std::max(patch_radius_m, min_spread(left, right)));
    const Vec3 way = normalized(across);
    const Vec3 z = cross(x, closing);
    const auto half_width = [&](const PadContact& pad) {
      const double rms = std::hypot(dot(way, x) * pad.spread_x_m, dot(way, z) * pad.spread_z_m);
      return std::max(line_half_m, std::numbers::sqrt3 * rms);  // of an even spread
    };
    const double swinging =
        carry_acceleration_m_s2 * length(across) / std::min(half_width(left), half_width(right));
    return turn_safety * product_.mass_kg * std::max(turning, swinging) / 2;
  }

  // The same about the closing direction alone, for the lever at its longest.
  double swing_need_n(Vec3 middle,
                      Vec3 closing,
                      const PadContact& left,
                      const PadContact& right) const {
    const Vec3 arm = to_double(body_.center_of_mass) - middle;
    const double lever = length(arm - closing * dot(arm, closing));
    const double turning = (standard_gravity + carry_acceleration_m_s2) * lever /
                           (query_.friction * std::max(patch_radius_m, min_spread(left, right)));
    return turn_safety * product_.mass_kg * turning / 2;
  }

  static double min_spread(const PadContact& left, const PadContact& right) {
    return std::min(std::hypot(left.spread_x_m, left.spread_z_m),
                    std::hypot(right.spread_x_m, right.spread_z_m));
  }

  // How far the fingers' ends, as long as the pads, reach out beyond the pack's sides.
  double side_room_of(const GraspCandidate& made) const {
    double outermost = 0;
    for (const robots::ToolSolid& solid : robots::opened(tool_, made.grasp.opening_m)) {
      const Pose& pose = solid.tool_from_solid;
      if (pose.position.z + solid.half_size.z < tool_.pad_center.z - tool_.pad_z_m) continue;
      outermost = std::max(outermost, std::abs(pose.position.y) + solid.half_size.y);
    }
    return outermost - made.width_m / 2;
  }

  // ---- Cups ----

  Tried suck(const SuctionSeed& seed) const {
    const double lip_m = tool_.cup_radius_m + lip_margin_m;
    const auto first = surface_.cup_contact(seed.origin, seed.travel, lip_m);
    if (!first) return refuse(GraspRefusal::none);
    // Square on the surface where it lies.
    const Vec3 approach = -first->normal;
    const double start = length(first->center - seed.origin);
    const auto lip = surface_.cup_contact(first->center - approach * start, approach, lip_m);
    if (!lip || dot(approach, seed.travel) < from_front_cosine)
      return refuse(GraspRefusal::no_seal, std::numeric_limits<double>::infinity());
    if (lip->unevenness_m > tool_.seal_depth_m)
      return refuse(GraspRefusal::no_seal, lip->unevenness_m);
    if (over_a_part(lip->center, approach))
      return refuse(GraspRefusal::no_seal, std::numeric_limits<double>::infinity());
    const double load = load_share(lip->center, approach);
    if (load > 1) return refuse(GraspRefusal::too_heavy, load);

    GraspCandidate made{.tool = tool_.kind, .strategy = seed.strategy};
    const Vec3 aside = std::abs(approach.z) < 0.9 ? Vec3{0, 0, 1} : Vec3{1, 0, 0};
    const Vec3 y = normalized(cross(aside, approach));
    made.grasp = {Pose{lip->center, rotation_with_axes(y, approach)}, 0, tool_.force_n};
    made.clearance_m = room_.clearance_of(made.grasp);
    if ((query_.from_above && !wanted(approach)) || !room_.is_free(made.grasp))
      return refuse(GraspRefusal::no_room);
    made.swing_n = peel_need_n(lip->center, approach);
    made.score = 0.7 * (1 - load) + 0.3 * (1 - lip->unevenness_m / tool_.seal_depth_m);
    return {made, {}};
  }

  // Tabs, seams and the like are finer than the contact pieces, but no lip seals across them.
  bool over_a_part(Vec3 at, Vec3 approach) const {
    return std::ranges::any_of(body_.features, [&](const assets::PackFeature& feature) {
      if (feature.kind == assets::FeatureKind::cap || feature.kind == assets::FeatureKind::lid ||
          feature.kind == assets::FeatureKind::rim || feature.kind == assets::FeatureKind::neck)
        return false;
      const Vec3 low = to_double(feature.center - feature.half_size);
      const Vec3 high = to_double(feature.center + feature.half_size);
      const Vec3 nearest{std::clamp(at.x, low.x, high.x),
                         std::clamp(at.y, low.y, high.y),
                         std::clamp(at.z, low.z, high.z)};
      const Vec3 off = nearest - at;
      const double along = dot(off, approach);
      return std::abs(along) < part_reach_m &&
             length(off - approach * along) < tool_.cup_radius_m + lip_margin_m;
    });
  }

  // Pull that keeps the pack on the cup whichever way up they are. Along the cup the load pulls and
  // turns by how far the middle of mass lies off the cup's axis, across it by how far it lies
  // ahead.
  double peel_need_n(Vec3 at, Vec3 approach) const {
    const Vec3 arm = to_double(body_.center_of_mass) - at;
    const double ahead = dot(arm, approach), off = length(arm - approach * ahead);
    const double radius = tool_.cup_radius_m;
    return turn_safety * product_.mass_kg * (standard_gravity + carry_acceleration_m_s2) *
           std::hypot(1 + 2 * off / radius, 2 * ahead / radius);
  }

  // Of what the cup holds, the most over the directions in which it may be moved.
  double load_share(Vec3 at, Vec3 approach) const {
    double most = 0;
    for (const Vec3 way : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}}) {
      for (const double side : {1.0, -1.0}) {
        const Vec3 felt = way * (side * carry_acceleration_m_s2) - up_ * standard_gravity;
        most = std::max(most, load_share(at, approach, felt * (product_.mass_kg * suction_safety)));
      }
    }
    return most;
  }

  // Three places of the lip hold a third of the pull each, against a load that pulls and one that
  // peels the cup off; what presses the lip on holds it by friction.
  double load_share(Vec3 at, Vec3 approach, Vec3 load) const {
    const double pull = dot(load, approach);
    const double shear = length(load - approach * pull);
    const Vec3 moment = cross(to_double(body_.center_of_mass) - at, load);
    const double peel = length(moment - approach * dot(moment, approach));
    const double lifted = (pull + 2 * peel / tool_.cup_radius_m) / tool_.force_n;
    const double pressed = tool_.force_n - pull;
    const double slid = pressed > 0 ? shear / (query_.friction * pressed) : 2;
    return std::max(lifted, slid);
  }

  std::string sentence() const {
    switch (worst_.refusal) {
      case GraspRefusal::too_wide:
        return fmt::format(
            "{:.0f} mm between the pads at the narrowest; {} takes {:.0f} mm, {:.0f} "
            "mm of it to spare on either side",
            worst_.figure * 1e3,
            tool_.id,
            tool_.opening_m * 1e3,
            query_.finger_gap_m * 1e3);
      case GraspRefusal::not_opposed:
        return "nowhere do two faces that a gripper reaches lie opposite one another";
      case GraspRefusal::turns:
        return fmt::format(
            "it would turn between the pads: to hold it takes {:.1f} times the tool's force",
            worst_.figure);
      case GraspRefusal::no_room:
        return fmt::format(
            "{} has no room round the pack {}",
            tool_.id,
            query_.from_above ? "between walls and neighbours" : "over what it stands on");
      case GraspRefusal::no_seal:
        return fmt::format("no face on which a {:.0f} mm cup seals: it bears {:.1f} mm unevenness",
                           tool_.cup_radius_m * 2e3,
                           tool_.seal_depth_m * 1e3);
      case GraspRefusal::too_heavy:
        return fmt::format(
            "{:.2f} kg is {:.1f} times what the cup holds there", product_.mass_kg, worst_.figure);
      default:
        return "no part of it can be reached";
    }
  }

  const catalog::Product& product_;
  const assets::ProductBody& body_;
  const robots::GraspTool& tool_;
  const GraspQuery& query_;
  Vec3 up_;  // of the world, product frame
  GraspSurface surface_;
  GraspRoom room_;
  std::vector<GraspCandidate> found_;
  Refused worst_;
};

bool is_finite_pose(const Pose& pose) {
  const Quaternion& q = pose.rotation;
  return is_finite(pose.position) && std::isfinite(q.w + q.x + q.y + q.z);
}

bool is_finite_place(const GraspQuery& query) {
  return is_finite_pose(query.world_from_product) &&
         std::ranges::all_of(query.likes, is_finite_pose) &&
         std::ranges::all_of(query.walls, [](const GraspObstacle& wall) {
           return is_finite_pose(wall.world_from_box) && is_finite(wall.half_size);
         });
}

Result<void> check_query(const catalog::Product& product, const GraspQuery& query) {
  if (!(product.mass_kg > 0) || !std::isfinite(product.mass_kg))
    return Error{"catalog.bad_row",
                 product.sku,
                 fmt::format("a product to be held needs a mass greater than 0; it has {} kg",
                             product.mass_kg)};
  if (!(query.friction > 0) || !(query.finger_gap_m > 0))
    return Error{"motion.bad_configuration",
                 product.sku,
                 fmt::format("expected friction and finger gap greater than 0, not {} and {} m",
                             query.friction,
                             query.finger_gap_m)};
  if (!is_finite_place(query))
    return Error{
        "motion.bad_configuration", product.sku, "expected pack, walls and likes at finite places"};
  return {};
}

std::optional<GraspCandidates> beyond_strength(const catalog::Product& product,
                                               const robots::GraspTool& tool,
                                               const GraspQuery& query) {
  if (product.mass_kg > tool.payload_kg)
    return GraspCandidates{
        {},
        GraspRefusal::too_heavy,
        fmt::format("{:.2f} kg; {} carries {:.2f} kg", product.mass_kg, tool.id, tool.payload_kg)};
  const double need = pinch_force_n(product.mass_kg, query.friction);
  if (tool.kind == robots::ToolKind::gripper && need > tool.force_n)
    return GraspCandidates{{},
                           GraspRefusal::too_heavy,
                           fmt::format("{:.2f} kg at friction {:.2f} needs {:.0f} N; {} grips with "
                                       "{:.0f} N",
                                       product.mass_kg,
                                       query.friction,
                                       need,
                                       tool.id,
                                       tool.force_n)};
  return std::nullopt;
}

}  // namespace

double pinch_force_n(double mass_kg, double friction) {
  return grip_safety * mass_kg * (standard_gravity + carry_acceleration_m_s2) / (2 * friction);
}

Result<GraspCandidates> grasp_candidates(const catalog::Product& product,
                                         const assets::ProductBody& body,
                                         const robots::GraspTool& tool,
                                         const GraspQuery& query) {
  MARKETGEN_CHECK(check_query(product, query));
  if (auto refused = beyond_strength(product, tool, query)) return std::move(*refused);
  return Search(product, body, tool, query).find();
}

Result<std::vector<CheckedPinch>> check_pinches(const catalog::Product& product,
                                                const assets::ProductBody& body,
                                                const robots::GraspTool& tool,
                                                const GraspQuery& query,
                                                const std::vector<PinchProposal>& proposals) {
  MARKETGEN_CHECK(check_query(product, query));
  if (tool.kind != robots::ToolKind::gripper || beyond_strength(product, tool, query))
    return std::vector<CheckedPinch>{};
  return Search(product, body, tool, query).check(proposals);
}

}  // namespace marketgen::motion
