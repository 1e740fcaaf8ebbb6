// Which of the masks is the product that is looked for, and how it lies.
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "perception/pose_source.h"

namespace marketgen::perception {

// Masks of one picture.
struct MaskedView {
  std::size_t view = 0;  // in the views they go with
  std::vector<Mask> masks;
};

// What is looked for, and what it may be mistaken for: other products of much the same shape.
struct WantedProduct {
  const ProductLook* look = nullptr;
  std::vector<const ProductLook*> rivals = {};
  int count = 1;           // as many of it may be found
  std::string words = {};  // the task's own for it; empty: it was told by its SKU
};

struct FoundProduct {
  std::size_t look = 0;            // which of those wanted
  std::size_t view = 0, mask = 0;  // that began it
  FittedPose pose;
};

class TargetChoice {
 public:
  virtual ~TargetChoice() = default;
  // Those of `wanted` that lie there, each at most `count` times, best first. What is not likely is
  // left out: an agent that takes something rather than nothing takes the wrong thing.
  virtual std::vector<FoundProduct> find(const std::vector<WantedProduct>& wanted,
                                         const std::vector<ViewCloud>& views,
                                         const std::vector<MaskedView>& masked) const = 0;
};

// Compares each mask with the catalogue: size, colours, then the pose that explains it best.
class CatalogueMatching : public TargetChoice {
 public:
  // Nothing lies lower than `lowest_m`.
  explicit CatalogueMatching(const PoseSource& poses, double lowest_m = -0.01)
      : poses_(poses), lowest_m_(lowest_m) {}

  std::vector<FoundProduct> find(const std::vector<WantedProduct>& wanted,
                                 const std::vector<ViewCloud>& views,
                                 const std::vector<MaskedView>& masked) const override;

 private:
  // Where the product may lie: one for each mask that it explains well enough.
  std::vector<FoundProduct> places_of(std::size_t number,
                                      const WantedProduct& wanted,
                                      const std::vector<ViewCloud>& views,
                                      const std::vector<MaskedView>& masked) const;
  bool is_likely(const ProductLook& look, const FittedPose& pose) const;
  // Takes away the best places as long as a rival explains them better.
  void drop_mistaken(const WantedProduct& wanted,
                     const std::vector<ViewCloud>& views,
                     const std::vector<MaskedView>& masked,
                     std::vector<FoundProduct>& places) const;

  const PoseSource& poses_;
  double lowest_m_;
};

// Best first, of each product as many as are wanted: where one lies, no other does.
std::vector<FoundProduct> one_at_a_place(const std::vector<WantedProduct>& wanted,
                                         std::vector<FoundProduct> all);

// How alike seen colours and those of a product are, 0..1: what their histograms share.
double color_likeness(const std::vector<Vec3f>& colors, const ProductLook& look);

// Products of nearly the same shape and size as `look`, those of the most alike colours.
std::vector<const ProductLook*> rivals_of(const ProductLook& look,
                                          const std::vector<const ProductLook*>& catalogue);

}  // namespace marketgen::perception
