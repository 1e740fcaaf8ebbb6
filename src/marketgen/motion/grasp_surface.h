// The outside of a pack as a grasp meets it: rays against its convex contact pieces, and flat pads
// and cups pressed on them. Product frame, metres.
#pragma once
#include <array>
#include <limits>
#include <optional>
#include <vector>

#include "assets/product_model.h"
#include "geometry/pose.h"

namespace marketgen::motion {

struct SurfaceHit {
  double distance_m = 0;  // along the ray
  Vec3 normal;            // unit, outwards
};

// Where a flat pad, moved along a direction, first rests on the pack.
struct PadContact {
  double height_m = 0;  // of the pad's face over the plane through the line's start, against the
                        // direction of travel
  Vec3 center;          // middle of what the pad touches
  Vec3 normal;          // unit, mean over what it touches
  double share = 0;     // of the pad's face that touches, 0..1
  double spread_x_m = 0,
         spread_z_m = 0;  // root mean square distances of what it touches from `center`
};

// How a cup's lip would lie.
struct CupContact {
  Vec3 center, normal;      // on the surface; unit, outwards, mean over the lip
  double unevenness_m = 0;  // greatest minus least height under the lip; infinite past an edge
};

class GraspSurface {
 public:
  explicit GraspSurface(const std::vector<assets::ContactPiece>& pieces);

  const Bounds3& bounds() const { return bounds_; }

  // The first point of the outside that the ray meets. `direction` is a unit vector.
  std::optional<SurfaceHit> first_hit(Vec3 origin, Vec3 direction) const;

  // A pad with half sizes `half_x` along unit vector `x` and `half_z` along `z`, moving along
  // `travel` (x, z, travel orthonormal) through `middle` from outside. Empty when it meets nothing.
  std::optional<PadContact> pad_contact(
      Vec3 middle, Vec3 travel, Vec3 x, Vec3 z, double half_x, double half_z) const;

  // A cup of `radius_m` pressed along `travel` onto the first point that the ray from `origin`
  // meets.
  std::optional<CupContact> cup_contact(Vec3 origin, Vec3 travel, double radius_m) const;

  // How far apart the box and the pack are, at least; negative when they may overlap. Exact where a
  // face of one of them looks at the other, less than the truth where edges do. Who only asks
  // whether it is `enough` need not wait for the rest: what is greater may be told as less, but not
  // as less than that.
  double gap_to_box(const Pose& product_from_box,
                    Vec3 half_size,
                    double enough_m = std::numeric_limits<double>::infinity()) const;

 private:
  // Faces of a hull: inside is where dot(normal, p) <= offset for all.
  struct Face {
    Vec3 normal;
    double offset = 0;
  };
  struct Piece {
    assets::PieceShape shape = assets::PieceShape::box;
    Vec3 center, half;  // half extents along the product's axes
    bool lying = false;
    std::vector<Face> faces;
    std::vector<Vec3> points;  // of a hull
    double radius = 0;         // of a ball round `center` that holds it
  };
  // A box with its axes, product frame.
  struct TurnedBox {
    Vec3 middle, half;
    std::array<Vec3, 3> axes;
    double reach(Vec3 direction) const;  // from its middle
  };

  static std::optional<SurfaceHit> hit(const Piece& piece, Vec3 origin, Vec3 direction);
  static double reach(const Piece& piece, Vec3 direction);
  static double gap(const Piece& piece, const TurnedBox& box, double enough_m);

  std::vector<Piece> pieces_;
  Bounds3 bounds_;
};

}  // namespace marketgen::motion
