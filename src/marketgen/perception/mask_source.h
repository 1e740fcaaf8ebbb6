// Which pixels of a picture belong together: the first module of the manipulation system.
//
// The one here knows only shapes. Another (a segmentation network, a server) takes its place behind
// the same interface.
#pragma once
#include <cstdint>
#include <vector>

#include "agent/workplace.h"
#include "perception/view_cloud.h"

namespace marketgen::perception {

struct Mask {
  std::vector<std::uint32_t> pixels;  // ascending
};

// As sources have them: the largest mask first.
void sort_by_size(std::vector<Mask>& masks);

class MaskSource {
 public:
  virtual ~MaskSource() = default;
  // Of the pixels that are `wanted` (one entry a pixel), the largest mask first.
  virtual std::vector<Mask> masks(const ViewCloud& cloud,
                                  const std::vector<std::uint8_t>& wanted) const = 0;
};

// Grows regions over smooth and convex surface: they end at steps of depth and at concave edges,
// which is where things touch one another (Stein et al., "Object partitioning using local
// convexity", CVPR 2014).
class GeometricMasks : public MaskSource {
 public:
  std::vector<Mask> masks(const ViewCloud& cloud,
                          const std::vector<std::uint8_t>& wanted) const override;
};

// Pixels that show goods: in the basket but not its floor, ledges and walls (which may stand a
// little aside of `base_from_basket`).
std::vector<std::uint8_t> goods_in_basket(const ViewCloud& cloud,
                                          const agent::Workplace& place,
                                          const Pose& base_from_basket);
// Pixels that show what stands over an area of the counter.
std::vector<std::uint8_t> goods_over(const ViewCloud& cloud, const agent::WorkArea& area);

}  // namespace marketgen::perception
