// Where and which way round a product lies, from a mask that may show it.
//
// The one here tries all ways round against the measured surface, then weighs each answer by what
// all pictures say: surface that is seen where it should be, surface that should be seen and is
// not, and colours (hypothesis and verification; Aldoma et al., "A global hypotheses verification
// method for 3D object recognition", ECCV 2012). Base frame, metres.
#pragma once
#include <vector>

#include "perception/mask_source.h"
#include "perception/product_look.h"

namespace marketgen::perception {

// How well a product, lying so, explains the pictures.
struct PoseEvidence {
  double fit = 0;          // of the surface that should be seen, the share that is
  double seen = 0;         // of the surface turned to a camera, the share that nothing hides
  double covered = 0;      // of the mask, the share that the product explains
  double color_error = 1;  // root mean square, sRGB as 0..1, brightness of each side set free
  double area_m2 = 0;      // of the surface that is seen, all pictures together
  double score = 0;        // 0..1, of all of them
  // 0..1: as the score, however little of it is seen. Of one product's finds the lower ones may be
  // of something else.
  double likeness() const;
};

struct FittedPose {
  Pose base_from_product;
  PoseEvidence evidence;
};

// A part of the measured surface: of a mask, thinned.
struct SurfacePatch {
  std::vector<Vec3f> points, normals, colors;
  Vec3f middle;
  Vec3f to_eye;  // unit, from its middle
  float diagonal_m = 0;
};
SurfacePatch patch_of(const ViewCloud& cloud, const Mask& mask, std::size_t max_points);
// Whether a product of that size may show such a surface.
bool is_of_size(const SurfacePatch& patch, const ProductLook& look);
// Of its bounds, in the base's frame.
Vec3 middle_of(const ProductLook& look, const Pose& base_from_product);
// Of its lowest point.
double lowest_z_m(const ProductLook& look, const Pose& base_from_product);

class PoseSource {
 public:
  virtual ~PoseSource() = default;
  // The best, or one with score 0.
  virtual FittedPose pose(const ProductLook& look,
                          const SurfacePatch& patch,
                          const std::vector<ViewCloud>& views) const = 0;
};

class SweptPoses : public PoseSource {
 public:
  FittedPose pose(const ProductLook& look,
                  const SurfacePatch& patch,
                  const std::vector<ViewCloud>& views) const override;
};

// What the pictures say of a pose. About `max_surfels` pieces of the product are looked at. Of the
// mask what is within `covered_m` of the product is explained, at twice as far nothing.
PoseEvidence evidence_of(const ProductLook& look,
                         const Pose& base_from_product,
                         const SurfacePatch& patch,
                         const std::vector<ViewCloud>& views,
                         std::size_t max_surfels,
                         float covered_m = 0.006F);

}  // namespace marketgen::perception
