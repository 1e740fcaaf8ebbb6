#include "assets/shapes/contact_pieces.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "assets/shapes/mesh_part.h"
#include "geometry/convex_hull.h"

namespace marketgen::assets {
namespace {

// Shares of the volume.
constexpr double min_gain = 0.004;    // a cut that wins less is not worth a piece
constexpr double well_filled = 0.35;  // of the tolerance: no further cut is sought below it
constexpr double max_blown_up =
    1.06;  // of a hull: its corners then stand out by 1.5 % of its half size
constexpr double of_one_piece = 0.8;  // of the tolerance: what a primitive may miss

constexpr std::size_t max_hull_points = 64;  // what MuJoCo's documentation advises for contact

// Shares of a size.
constexpr float nearly_round = 0.04F;  // by which the axes of a cylinder's section may differ
constexpr float standing_out = 0.04F;  // by which a part may reach out of its primitive

constexpr float level_m = 1e-3F;           // parts that begin within it stand on one level
constexpr std::size_t low_foot_steps = 2;  // of feet_of: a twelfth of the height

double excess_of(const MeshPart& part) {
  return excess(part.hull_volume, part.volume);
}

// ---- Shapes ----

ContactPiece primitive_in(const Bounds3& bounds, PieceShape shape) {
  return {.shape = shape, .center = bounds.center(), .half_size = bounds.size() * 0.5F};
}

bool similar(float a, float b) {
  return std::abs(a - b) <= nearly_round * std::max(a, b);
}

// How far a point reaches out, 1 on the surface of the primitive's round part.
float reach_in(const ContactPiece& piece, Vec3f p) {
  const Vec3f d = p - piece.center;
  const Vec3f h = piece.half_size;
  if (piece.shape == PieceShape::cylinder) {
    return piece.lying ? std::hypot(d.y, d.z) / h.x : std::hypot(d.x, d.y) / h.x;
  }
  if (piece.shape == PieceShape::ellipsoid)
    return std::sqrt(dot(d * d, Vec3f{1 / (h.x * h.x), 1 / (h.y * h.y), 1 / (h.z * h.z)}));
  return 0;
}

std::vector<ContactPiece> primitives_for(const Bounds3& bounds, bool may_roll) {
  const Vec3f half = bounds.size() * 0.5F;
  std::vector<ContactPiece> all{primitive_in(bounds, PieceShape::box)};
  if (similar(half.x, half.y)) {
    ContactPiece& upright = all.emplace_back(primitive_in(bounds, PieceShape::cylinder));
    upright.half_size.x = upright.half_size.y = std::min(half.x, half.y);
  }
  if (similar(half.y, half.z)) {
    ContactPiece& lying = all.emplace_back(primitive_in(bounds, PieceShape::cylinder));
    const float radius = std::min(half.y, half.z);
    lying.half_size = {radius, radius, half.x};
    lying.lying = true;
  }
  if (may_roll) all.push_back(primitive_in(bounds, PieceShape::ellipsoid));
  return all;
}

ContactPiece hull_of(const MeshPart& part) {
  ContactPiece piece = primitive_in(part.bounds, PieceShape::hull);
  for (const std::uint32_t i : hull_points(part.hull_points, max_hull_points))
    piece.points.push_back(part.hull_points[i]);
  return piece;
}

// What a piece has to fill.
struct Filling {
  Bounds3 bounds;
  const std::vector<Vec3f>& hull_points;
  double volume;
};
Filling filling_of(const MeshPart& part) {
  return {part.bounds, part.hull_points, part.volume};
}

// The primitive that fills it best, if one does within the tolerance.
std::optional<ContactPiece> primitive_for(const Filling& filling, double tolerance, bool may_roll) {
  std::optional<ContactPiece> best;
  const float reach = 1 + standing_out + static_cast<float>(tolerance / 2);
  double least = tolerance * filling.volume;
  for (const ContactPiece& primitive : primitives_for(filling.bounds, may_roll)) {
    const double error = std::abs(volume_of(primitive) - filling.volume);
    const bool holds = std::all_of(filling.hull_points.begin(),
                                   filling.hull_points.end(),
                                   [&](Vec3f p) { return reach_in(primitive, p) <= reach; });
    if (error > least || !holds) continue;
    least = error;
    best = primitive;
  }
  return best;
}

// ---- Cutting ----

// Parts with the best cut of each.
class Cutting {
 public:
  Cutting(MeshPart whole, const Solid& solid) : solid_(solid), total_(whole.volume) {
    add(std::move(whole));
  }

  double excess_left() const {
    double sum = 0;
    for (const MeshPart& part : parts_)
      sum += excess_of(part);
    return sum;
  }

  // Cuts the part whose cut wins most; false when none wins enough.
  bool cut_once() {
    std::size_t best = 0;
    for (std::size_t i = 1; i < parts_.size(); ++i) {
      if (gain(i) > gain(best)) best = i;
    }
    if (gain(best) < min_gain * total_) return false;
    replace(best, split(parts_[best], solid_, cuts_[best]));
    return true;
  }

  // Rings win nothing by one cut: into four quarters at once, when that wins more a piece.
  void quarter_if_better() {
    const int middle = solid_.columns() / 2;
    const PartCut across{CutAxis::x, middle}, deep{CutAxis::y, middle};
    const std::array<MeshPart, 2> halves = split(parts_[0], solid_, across);
    std::vector<MeshPart> quarters;
    double left = 0;
    for (const MeshPart& half : halves) {
      for (MeshPart& quarter : split(half, solid_, deep)) {
        left += excess_of(quarter);
        quarters.push_back(std::move(quarter));
      }
    }
    if ((excess_of(parts_[0]) - left) / 3 <= std::max(gain(0), min_gain * total_)) return;
    parts_.clear();
    cuts_.clear();
    for (MeshPart& quarter : quarters)
      add(std::move(quarter));
  }

  const std::vector<MeshPart>& parts() const { return parts_; }

 private:
  double gain(std::size_t i) const { return excess_of(parts_[i]) - cuts_[i].excess; }

  void add(MeshPart part) {
    // What holds next to nothing (a film's edge) is no piece, and nothing to cut.
    if (part.hull_volume <= 0 || part.volume < 1e-4 * total_) return;
    cuts_.push_back(best_cut(part, solid_));
    parts_.push_back(std::move(part));
  }

  void replace(std::size_t i, std::array<MeshPart, 2> sides) {
    parts_.erase(parts_.begin() + static_cast<std::ptrdiff_t>(i));
    cuts_.erase(cuts_.begin() + static_cast<std::ptrdiff_t>(i));
    for (MeshPart& side : sides)
      add(std::move(side));
  }

  const Solid& solid_;
  double total_;
  std::vector<MeshPart> parts_;
  std::vector<PartCut> cuts_;
};

// Into at most so many parts, until what the hulls have too much is `enough`.
std::vector<MeshPart> cut_apart(MeshPart whole, const Solid& solid, int most, double enough) {
  if (excess_of(whole) <= enough) return {std::move(whole)};
  Cutting cutting(std::move(whole), solid);
  if (most >= 4) cutting.quarter_if_better();
  while (static_cast<int>(cutting.parts().size()) < most && cutting.excess_left() > enough &&
         cutting.cut_once()) {
  }
  return cutting.parts();
}

// ---- Standing ----

bool has_flat_foot(const ContactPiece& piece) {
  return piece.shape == PieceShape::box || (piece.shape == PieceShape::cylinder && !piece.lying);
}

// A box or cylinder of the part's height and volume.
ContactPiece block_for(const Bounds3& bounds, double volume) {
  ContactPiece block = primitive_in(bounds, PieceShape::box);
  if (similar(block.half_size.x, block.half_size.y)) block.shape = PieceShape::cylinder;
  const auto share = static_cast<float>(std::sqrt(std::min(1.0, volume / volume_of(block))));
  block.half_size.x *= share;
  block.half_size.y *= share;
  if (block.shape == PieceShape::cylinder)
    block.half_size.x = block.half_size.y = std::min(block.half_size.x, block.half_size.y);
  return block;
}

// The tallest foot of a part that a primitive fills; failing that a low one. MuJoCo holds a box or
// cylinder on a shelf with several contacts, a hull with one.
struct Foot {
  ContactPiece piece;
  float height;
};
Foot foot_of(const MeshPart& part, const Solid& solid, double tolerance) {
  const std::vector<PartFoot> feet = feet_of(part, solid);
  for (std::size_t i = feet.size(); i-- > 0;) {
    const std::optional<ContactPiece> primitive =
        primitive_for({feet[i].bounds, feet[i].hull_points, feet[i].volume}, tolerance, false);
    if (primitive && has_flat_foot(*primitive)) return {*primitive, feet[i].height};
  }
  const PartFoot& low = feet[low_foot_steps - 1];
  return {block_for(low.bounds, low.volume), low.height};
}

// ---- Volume ----

// Scales a hull about a point.
void stretch(ContactPiece& piece, Vec3f middle, Vec3f scale) {
  for (Vec3f& p : piece.points)
    p = middle + (p - middle) * scale;
  piece.center = middle + (piece.center - middle) * scale;
  piece.half_size = piece.half_size * scale;
}

// In its footprint: it keeps its height.
void widen(ContactPiece& piece, double share) {
  const auto factor = static_cast<float>(std::sqrt(share));
  stretch(piece, piece.center, {factor, factor, 1});
}

// Across its two lesser sizes; what stands on the ground goes on doing so.
void draw_in(ContactPiece& piece, double share, float ground) {
  const auto factor = static_cast<float>(std::sqrt(share));
  const Vec3f h = piece.half_size;
  Vec3f scale{factor, factor, factor};
  (h.x >= h.y && h.x >= h.z ? scale.x : h.y >= h.z ? scale.y : scale.z) = 1;
  Vec3f middle = piece.center;
  const float low = middle.z - h.z;
  if (low < ground + level_m) middle.z = low;
  stretch(piece, middle, scale);
}

// Few points round off a hull: it gets back what it lacks. From every hull that has too much goes
// the same share of it, so that the total comes right.
void correct_volume(std::vector<ContactPiece>& pieces,
                    const std::vector<double>& volumes,
                    const PieceLimits& limits,
                    float ground) {
  double wanted = 0, total = 0, too_much = 0;
  std::vector<double> over(pieces.size(), 0);
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    double volume = volume_of(pieces[i]);
    if (pieces[i].shape == PieceShape::hull && volume < volumes[i]) {
      const double share = std::min(volumes[i] / volume, max_blown_up);
      widen(pieces[i], share);
      volume *= share;
    }
    wanted += volumes[i];
    total += volume;
    if (pieces[i].shape == PieceShape::hull) over[i] = excess(volume, volumes[i]);
    too_much += over[i];
  }
  const double most = (1 + well_filled * limits.tolerance) * wanted;
  if (total <= most || too_much <= 0) return;
  const double taken = std::min(1.0, (total - most) / too_much);
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    if (over[i] > 0) draw_in(pieces[i], 1 - taken * over[i] / (volumes[i] + over[i]), ground);
  }
}

}  // namespace

double volume_of(const ContactPiece& piece) {
  const Vec3f h = piece.half_size;
  const double box = 8.0 * h.x * h.y * h.z;
  switch (piece.shape) {
    case PieceShape::box:
      return box;
    case PieceShape::cylinder:
      return box * std::numbers::pi / 4;
    case PieceShape::ellipsoid:
      return box * std::numbers::pi / 6;
    case PieceShape::hull:
      return convex_hull(piece.points).volume;
  }
  return 0;
}

std::vector<ContactPiece> contact_pieces(const Mesh& mesh,
                                         const Solid& solid,
                                         const PieceLimits& limits) {
  MeshPart rest = whole_part(mesh, solid);
  const double tolerance = of_one_piece * limits.tolerance;
  const double enough = well_filled * limits.tolerance * rest.volume;
  const auto whole = primitive_for(filling_of(rest), tolerance, !limits.stands);
  if (whole && (!limits.stands || has_flat_foot(*whole))) return {*whole};

  std::vector<ContactPiece> pieces;
  std::vector<double> volumes;
  const auto add = [&](ContactPiece piece, double volume) {
    pieces.push_back(std::move(piece));
    volumes.push_back(volume);
  };
  if (limits.stands) {
    const Foot foot = foot_of(rest, solid, tolerance);
    auto [below, above] = split(rest, solid, {.axis = CutAxis::z, .height = foot.height});
    add(foot.piece, below.volume);
    rest = std::move(above);
  }
  const int most = limits.max_pieces - static_cast<int>(pieces.size());
  std::vector<MeshPart> parts = cut_apart(std::move(rest), solid, most, enough);
  std::stable_sort(parts.begin(), parts.end(), [](const MeshPart& a, const MeshPart& b) {
    return a.bounds.low.z < b.bounds.low.z;
  });
  for (const MeshPart& part : parts) {
    const auto primitive = primitive_for(filling_of(part), tolerance, pieces.empty());
    add(primitive ? *primitive : hull_of(part), part.volume);
  }
  correct_volume(pieces, volumes, limits, solid.bounds().low.z);
  return pieces;
}

}  // namespace marketgen::assets
