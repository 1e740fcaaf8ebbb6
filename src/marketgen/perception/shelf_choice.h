// Which of the spots on a shelf show the product that is looked for, and how exactly it stands.
//
// Base frame, metres.
#pragma once
#include <vector>

#include "perception/shelf_spots.h"
#include "perception/target_choice.h"

namespace marketgen::perception {

struct FoundOnShelf {
  ShelfSpot spot;
  FittedPose pose;
};

class ShelfChoice {
 public:
  virtual ~ShelfChoice() = default;
  // Best first, none overlapping another. What a rival explains better is left out.
  virtual std::vector<FoundOnShelf> find(const WantedProduct& wanted,
                                         const std::vector<ViewCloud>& views,
                                         const std::vector<BoardAhead>& boards,
                                         const std::vector<ShelfSpot>& spots) const = 0;
  // The pose near one that was found before, as the pictures show it now; score 0 when they do not,
  // or when they show a rival.
  virtual FittedPose again(const WantedProduct& wanted,
                           const std::vector<ViewCloud>& views,
                           const Pose& base_from_product) const = 0;
};

// The spots that look most like the product, best first, so far apart that each may be another
// pack. None that looks nothing like it.
std::vector<ShelfSpot> likely_spots(const ProductLook& look,
                                    const std::vector<ViewCloud>& views,
                                    const std::vector<BoardAhead>& boards,
                                    const std::vector<ShelfSpot>& spots,
                                    std::size_t max_spots);
// How far apart along a board: nearer ones show one pack.
double apart_on_shelf(const ProductLook& look);

// Stands the product, upright and front ahead, on every spot, looks whether pictures agree in
// depth and colour, and moves the best ones until they agree most (pose_source.h).
class UprightMatching : public ShelfChoice {
 public:
  std::vector<FoundOnShelf> find(const WantedProduct& wanted,
                                 const std::vector<ViewCloud>& views,
                                 const std::vector<BoardAhead>& boards,
                                 const std::vector<ShelfSpot>& spots) const override;
  FittedPose again(const WantedProduct& wanted,
                   const std::vector<ViewCloud>& views,
                   const Pose& base_from_product) const override;
};

}  // namespace marketgen::perception
