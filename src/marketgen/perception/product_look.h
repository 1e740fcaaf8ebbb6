// What a product looks like from all sides, as small pieces of coloured surface, made from its
// pictures. Product frame, metres.
#pragma once
#include <array>
#include <cstdint>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "agent/known_products.h"
#include "base/result.h"

namespace marketgen::perception {

struct Surfel {
  Vec3f point, normal;  // unit within 1e-4, outwards
  Vec3f color;          // sRGB as 0..1
  bool clear = false;   // one sees into it there: the colour says little
};

// As a look has it: so exact that nothing is lost when it is kept on disk. What was unpacked packs
// to the same again.
struct PackedSurfel {
  std::array<std::int16_t, 3> point{}, normal{};  // in 1/20 mm; in 1/32767
  std::array<std::uint8_t, 3> color{};
  std::uint8_t clear = 0;
};
Surfel unpacked(const PackedSurfel& packed);

class ProductLook {
 public:
  // Pieces about `spacing_m` apart, farther on a product that would have more than 30,000 (a
  // crate). Errors: perception.no_picture when nothing is seen in them.
  static Result<ProductLook> make(const std::string& sku,
                                  const agent::ProductPictures& pictures,
                                  float spacing_m = 0.0035F);

  // Of a look that was packed before. Precondition: there are some.
  static ProductLook of(const std::string& sku, std::vector<PackedSurfel> surfels);

  const std::string& sku() const { return sku_; }
  const std::vector<Surfel>& surfels() const { return surfels_; }
  std::vector<PackedSurfel> packed() const;
  Vec3f low() const { return low_; }
  Vec3f high() const { return high_; }
  Vec3f middle() const { return (low_ + high_) * 0.5F; }
  float diagonal_m() const { return length(high_ - low_); }

  // The surfel nearest to a point, by a table as coarse as its cells; -1 farther away than the
  // table reaches. Any number of threads may ask.
  int nearest(Vec3f product_point) const;

 private:
  // Made when it is asked for first: of a whole catalogue few products are.
  struct Table {
    std::once_flag made;
    Vec3f origin;
    std::array<int, 3> cells{};
    std::vector<std::int16_t> nearest;
  };
  void make_table() const;
  void spread(bool forwards) const;

  std::string sku_;
  std::vector<Surfel> surfels_;
  Vec3f low_, high_;
  std::unique_ptr<Table> table_ = std::make_unique<Table>();
};

}  // namespace marketgen::perception
