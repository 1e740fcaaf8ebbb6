// What is written in the shop: price labels on shelf edges, cards under those of offers, hanging
// signs over zones, bands with zone names along the walls.
#pragma once
#include <optional>
#include <vector>

#include "render/stage/draft.h"
#include "render/stage/room.h"

namespace marketgen::render::raytrace {

class PriceLabelBuilder {
 public:
  explicit PriceLabelBuilder(Draft& draft);
  void build(Draft& draft) const;

 private:
  struct Looks {
    std::uint16_t tag = 0;
    std::optional<std::uint16_t> card;  // of an offer
  };
  std::vector<Looks> looks_of_label_;  // by scene.price_labels
};

class SignBuilder {
 public:
  SignBuilder(Draft& draft, const Room& room);
  void build(Draft& draft) const;

 private:
  // A board that hangs from the ceiling and is read from both sides.
  struct Board {
    Vec3f middle;
    bool facing_x = false;  // its faces look along x
    float width = 0;
    std::uint16_t material = 0;
  };
  // A zone's name on a wall's band.
  struct WallName {
    std::size_t wall = 0;
    float middle = 0, width = 0;
    std::uint16_t material = 0;
  };
  void hang_boards(Draft& draft);
  void write_names(Draft& draft);
  void add_board(Mesh& mesh, const Board& board) const;
  // A strip along the wall between two heights, broken where openings are as high.
  void add_band(Mesh& mesh, const WallEdge& edge, float low, float high, float depth) const;

  const Room& room_;
  std::vector<Board> boards_;
  std::vector<WallName> names_;
  std::uint16_t band_ = 0, metal_ = 0;
  std::optional<std::uint16_t> neon_;  // of looks that have it
  float band_low_ = 2.55F, board_low_ = 2.35F;
};

}  // namespace marketgen::render::raytrace
