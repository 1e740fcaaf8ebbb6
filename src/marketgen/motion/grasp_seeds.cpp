#include "motion/grasp_seeds.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace marketgen::motion {
namespace {

constexpr int side_yaws = 12, top_yaws = 12;  // every 30 degrees round; every 15 of a half turn
constexpr double far_off_m = 2;               // rays start there; no pack is as long
constexpr double tip_over_support_m = 0.004;
constexpr std::array side_heights = {
    0.5, 0.3, 0.7, 0.85};                              // of the pack's; its middle of mass first
constexpr std::array pitches_deg = {0.0, 25.0, 50.0};  // of the approach, downwards
constexpr std::array top_depths_m = {0.012, 0.022, 0.034, 0.050, 0.075};  // of the pads' middle

// For packs that lie: places along the longest axis, as shares of it from the middle of mass; steps
// of the sweep round a closing direction; what still counts as straight down (20 degrees).
constexpr std::array lying_shares = {0.0, -0.22, 0.22};
constexpr int lying_sweep = 24;
constexpr double straight_down_cosine = 0.93969262078590838;

double radians(double degrees) {
  return degrees * std::numbers::pi / 180;
}

// Approaches round the upright axis, the one from the front first; closing is level.
struct Directions {
  Vec3 approach, closing;
};
Directions level_directions(int yaw, double pitch_deg) {
  const double turn = radians(90 + 360.0 * yaw / side_yaws), pitch = radians(pitch_deg);
  const Vec3 ahead{std::cos(turn), std::sin(turn), 0};
  return {ahead * std::cos(pitch) - Vec3{0, 0, std::sin(pitch)}, {-ahead.y, ahead.x, 0}};
}
Vec3 level_closing(int yaw) {
  const double turn = std::numbers::pi * yaw / top_yaws;
  return {std::cos(turn), std::sin(turn), 0};
}

Vec3 axis_unit(int axis) {
  return axis == 0 ? Vec3{1, 0, 0} : axis == 1 ? Vec3{0, 1, 0} : Vec3{0, 0, 1};
}
double along(Vec3 v, int axis) {
  return axis == 0 ? v.x : axis == 1 ? v.y : v.z;
}

// Lowest place of the pads' middle with the fingers pointing straight down.
double lowest_from_above(const robots::GraspTool& tool) {
  return std::max(tool.pad_z_m, -tool.pad_center.z) + tip_over_support_m;
}

// A unit vector at right angles to a unit vector.
Vec3 square_to(Vec3 v) {
  return normalized(cross(std::abs(v.z) < 0.9 ? Vec3{0, 0, 1} : Vec3{1, 0, 0}, v));
}

bool narrow_part(assets::FeatureKind kind) {
  return kind == assets::FeatureKind::neck || kind == assets::FeatureKind::cap ||
         kind == assets::FeatureKind::lid || kind == assets::FeatureKind::pump ||
         kind == assets::FeatureKind::stem;
}

class Seeds {
 public:
  Seeds(const assets::ProductBody& body, const GraspSurface& surface, const robots::GraspTool& tool)
      : tool_(tool),
        mass_middle_(to_double(body.center_of_mass)),
        low_(to_double(surface.bounds().low)),
        high_(to_double(surface.bounds().high)) {}

  void round_about(GraspStrategy strategy, Vec3 center, double pitch_deg) {
    for (int yaw = 0; yaw < side_yaws; ++yaw) {
      const auto [approach, closing] = level_directions(yaw, pitch_deg);
      seeds_.push_back({strategy, center, approach, closing});
    }
  }

  void from_above(GraspStrategy strategy, Vec3 center) {
    center.z = std::max(center.z, lowest_from_above(tool_));
    for (int yaw = 0; yaw < top_yaws; ++yaw)
      seeds_.push_back({strategy, center, {0, 0, -1}, level_closing(yaw)});
  }

  void sides() {
    const double height = high_.z - low_.z;
    for (const double pitch : pitches_deg) {
      round_about(GraspStrategy::side, mass_middle_, pitch);
      for (const double share : side_heights)
        round_about(
            GraspStrategy::side, {mass_middle_.x, mass_middle_.y, low_.z + share * height}, pitch);
    }
  }

  void tops() {
    double last = high_.z;
    for (const double depth : top_depths_m) {
      const double z = std::max(high_.z - depth, lowest_from_above(tool_));
      if (z >= last) continue;
      last = z;
      from_above(GraspStrategy::top, {mass_middle_.x, mass_middle_.y, z});
    }
  }

  void narrow(const assets::PackFeature& feature) {
    const Vec3 center = to_double(feature.center);
    round_about(GraspStrategy::neck, center, 0);
    round_about(GraspStrategy::neck, center, pitches_deg[1]);
    from_above(GraspStrategy::neck, center);
  }

  // Across the thinner directions of the feature's box, from every side but below.
  void handle(const assets::PackFeature& feature) {
    for (int closing = 0; closing < 3; ++closing) {
      for (int approach = 0; approach < 3; ++approach) {
        if (approach == closing) continue;
        for (const double sign : {1.0, -1.0}) {
          if (approach == 2 && sign > 0) continue;
          seeds_.push_back({GraspStrategy::handle,
                            to_double(feature.center),
                            axis_unit(approach) * sign,
                            axis_unit(closing),
                            true});
        }
      }
    }
  }

  // Across the flat seam, from where it ends: from above, or from an end of a lying pack.
  void seam(const assets::PackFeature& feature) {
    const Vec3 half = to_double(feature.half_size), center = to_double(feature.center);
    const Vec3 out = center - (low_ + high_) * 0.5;
    const int thin = half.y <= half.x ? 1 : 0;
    for (int axis = 0; axis < 3; ++axis) {
      const double size = along(high_ - low_, axis);
      if (axis == thin || std::abs(along(out, axis)) < size / 4) continue;  // not at an end
      if (axis == 2 && out.z < 0) continue;                                 // under the pack
      const Vec3 approach = axis_unit(axis) * (along(out, axis) > 0 ? -1.0 : 1.0);
      seeds_.push_back({GraspStrategy::seam, center, approach, axis_unit(thin)});
      if (axis != 2) from_above(GraspStrategy::seam, center);
    }
  }

  std::vector<PinchSeed> take() { return std::move(seeds_); }

 private:
  const robots::GraspTool& tool_;
  Vec3 mass_middle_, low_, high_;
  std::vector<PinchSeed> seeds_;
};

// Approaches from above to a pack that lies any way round.
class LyingSeeds {
 public:
  LyingSeeds(const assets::ProductBody& body, const GraspSurface& surface, Vec3 up)
      : surface_(surface), up_(up), mass_middle_(to_double(body.center_of_mass)) {
    const Vec3 size = to_double(surface.bounds().high - surface.bounds().low);
    for (int axis = 1; axis < 3; ++axis)
      if (along(size, axis) > along(size, longest_)) longest_ = axis;
    length_m_ = along(size, longest_);
  }

  // Round the middle of mass, and to either side of it along the pack's longest axis.
  void middles() {
    for (const double share : lying_shares) {
      const Vec3 center = mass_middle_ + axis_unit(longest_) * (share * length_m_);
      for (const Vec3 closing : all_closings()) {
        if (share == 0 || std::abs(along(closing, longest_)) < 0.5) sweep(center, closing);
      }
    }
  }

  void narrow(const assets::PackFeature& feature) {
    for (const Vec3 closing : all_closings())
      sweep_at(GraspStrategy::neck, to_double(feature.center), closing, false);
  }

  void handle(const assets::PackFeature& feature) {
    for (int axis = 0; axis < 3; ++axis)
      sweep_at(GraspStrategy::handle, to_double(feature.center), axis_unit(axis), true);
  }

  void seam(const assets::PackFeature& feature) {
    const int thin = feature.half_size.y <= feature.half_size.x ? 1 : 0;
    sweep_at(GraspStrategy::seam, to_double(feature.center), axis_unit(thin), false);
  }

  std::vector<PinchSeed> take() { return std::move(seeds_); }

 private:
  static std::vector<Vec3> all_closings() {
    std::vector<Vec3> closings{{0, 0, 1}};
    for (int yaw = 0; yaw < top_yaws; ++yaw)
      closings.push_back(level_closing(yaw));
    return closings;
  }

  // Calls `use` with each approach from above square to `closing`.
  template <class Use>
  void for_approaches(Vec3 closing, const Use& use) const {
    const Vec3 x = square_to(closing), y = cross(closing, x);
    for (int i = 0; i < lying_sweep; ++i) {
      const double turn = 2 * std::numbers::pi * i / lying_sweep;
      const Vec3 approach = x * std::cos(turn) + y * std::sin(turn);
      if (dot(approach, up_) < 0) use(approach);
    }
  }

  void sweep_at(GraspStrategy strategy, Vec3 center, Vec3 closing, bool inside) {
    for_approaches(closing, [&](Vec3 approach) {
      seeds_.push_back({strategy, center, approach, closing, inside});
    });
  }

  // At the centre and nearer to where the approach meets the pack.
  void sweep(Vec3 center, Vec3 closing) {
    for_approaches(closing, [&](Vec3 approach) {
      const GraspStrategy strategy = strategy_from_above(approach, up_);
      seeds_.push_back({strategy, center, approach, closing});
      const Vec3 start = center - approach * far_off_m;
      const auto hit = surface_.first_hit(start, approach);
      if (!hit) return;
      for (const double depth : top_depths_m) {
        if (hit->distance_m + depth < far_off_m)
          seeds_.push_back(
              {strategy, start + approach * (hit->distance_m + depth), approach, closing});
      }
    });
  }

  const GraspSurface& surface_;
  Vec3 up_, mass_middle_;
  int longest_ = 0;
  double length_m_ = 0;
  std::vector<PinchSeed> seeds_;
};

}  // namespace

GraspStrategy strategy_from_above(Vec3 approach, Vec3 up) {
  return -dot(approach, up) > straight_down_cosine ? GraspStrategy::top : GraspStrategy::side;
}

std::vector<PinchSeed> pinch_seeds(const assets::ProductBody& body,
                                   const GraspSurface& surface,
                                   const robots::GraspTool& tool) {
  Seeds seeds(body, surface, tool);
  for (const assets::PackFeature& feature : body.features) {
    if (narrow_part(feature.kind)) seeds.narrow(feature);
    if (feature.kind == assets::FeatureKind::handle || feature.kind == assets::FeatureKind::trigger)
      seeds.handle(feature);
    if (feature.kind == assets::FeatureKind::seam) seeds.seam(feature);
  }
  seeds.sides();
  seeds.tops();
  return seeds.take();
}

std::vector<PinchSeed> pinch_seeds_from_above(const assets::ProductBody& body,
                                              const GraspSurface& surface,
                                              Vec3 up) {
  LyingSeeds seeds(body, surface, up);
  for (const assets::PackFeature& feature : body.features) {
    if (narrow_part(feature.kind)) seeds.narrow(feature);
    if (feature.kind == assets::FeatureKind::handle || feature.kind == assets::FeatureKind::trigger)
      seeds.handle(feature);
    if (feature.kind == assets::FeatureKind::seam) seeds.seam(feature);
  }
  seeds.middles();
  return seeds.take();
}

std::vector<SuctionSeed> suction_seeds(const assets::ProductBody& body,
                                       const GraspSurface& surface) {
  constexpr std::array across = {0.0, -0.25, 0.25};  // of the face's width, from its middle
  constexpr std::array up = {0.0, 0.12, -0.12, 0.25, -0.25, 0.36};
  const Vec3 low = to_double(surface.bounds().low), high = to_double(surface.bounds().high);
  const Vec3 size = high - low, mass_middle = to_double(body.center_of_mass);
  std::vector<SuctionSeed> seeds;
  for (const double a : across) {
    for (const double b : across)
      seeds.push_back({GraspStrategy::suction_top,
                       {mass_middle.x + a * size.x, mass_middle.y + b * size.y, far_off_m},
                       {0, 0, -1}});
    for (const double b : up) {
      const double z = mass_middle.z + b * size.z;
      seeds.push_back(
          {GraspStrategy::suction_front, {mass_middle.x + a * size.x, -far_off_m, z}, {0, 1, 0}});
      for (const double side : {1.0, -1.0})
        seeds.push_back({GraspStrategy::suction_side,
                         {side * far_off_m, mass_middle.y + a * size.y, z},
                         {-side, 0, 0}});
    }
  }
  return seeds;
}

std::vector<SuctionSeed> suction_seeds_from_above(const assets::ProductBody& body,
                                                  const GraspSurface& surface,
                                                  Vec3 up) {
  constexpr std::array across = {0.0, -0.18, 0.18, -0.36, 0.36};  // of the face, from its middle
  const Vec3 size = to_double(surface.bounds().high - surface.bounds().low);
  const Vec3 mass_middle = to_double(body.center_of_mass);
  std::vector<SuctionSeed> seeds;
  for (int axis = 0; axis < 3; ++axis) {
    const double side = along(up, axis) > 0 ? -1.0 : 1.0;  // down
    const Vec3 travel = axis_unit(axis) * side;
    const bool down = -dot(travel, up) > straight_down_cosine;
    const Vec3 u = axis_unit((axis + 1) % 3), v = axis_unit((axis + 2) % 3);
    for (const double a : across) {
      for (const double b : across) {
        const Vec3 over = mass_middle + u * (a * dot(size, u)) + v * (b * dot(size, v));
        seeds.push_back({down ? GraspStrategy::suction_top : GraspStrategy::suction_side,
                         over - travel * far_off_m,
                         travel});
      }
    }
  }
  return seeds;
}

}  // namespace marketgen::motion
