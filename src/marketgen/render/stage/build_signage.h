// What is written in the shop: price labels on shelf edges, cards under those of offers, hanging
// signs over zones, bands with zone names along the walls, numbers over lanes, boards over exits.
#pragma once
#include <optional>
#include <string>
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

// What is printed on a sign of that size: white letters on `ground`.
std::uint16_t sign_material(Draft& draft,
                            const std::string& text,
                            const std::string& ground,
                            float width,
                            float height,
                            int height_px);

// Rows of the layout's lanes from one end of the line of tills to the other: their numbers less 1.
std::vector<std::uint32_t> lanes_in_order(const layout::Layout& layout);

// Letters on boards of fixtures that would be blank: over the ends of runs the name of the zone,
// on tasting tables an invitation, on the lamps of lanes their numbers. Of stores with full outfit.
class BoardLetters {
 public:
  explicit BoardLetters(Draft& draft);
  void build(Draft& draft) const;

 private:
  // On the front of all parts of the fixture that they are on, over so large a share of its width.
  struct Words {
    std::uint32_t fixture = 0;
    std::string text;
    bool (*are_on)(const scene::ScenePart&) = nullptr;
    bool both_sides = false;
    float share = 1;
  };
  struct Board {
    std::uint32_t fixture = 0, part = 0;  // rows of the scene
    std::uint16_t material = 0;
    float half_width = 0;
    bool both_sides = false;
  };
  void write(Draft& draft, const Words& words);

  std::vector<Board> boards_;
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
  // Over a door that leads out.
  struct ExitBoard {
    std::size_t wall = 0;
    float middle = 0, low = 0;
  };
  void hang_boards(Draft& draft);
  void write_names(Draft& draft);
  void number_lanes(Draft& draft);
  void mark_exits(Draft& draft);
  void add_board(Mesh& mesh, const Board& board) const;
  void add_exit(Mesh& mesh, const ExitBoard& board) const;
  // A strip along the wall between two heights, broken where openings are as high.
  void add_band(Mesh& mesh, const WallEdge& edge, float low, float high, float depth) const;

  const Room& room_;
  std::vector<Board> boards_;
  std::vector<WallName> names_;
  std::vector<ExitBoard> exits_;
  std::uint16_t band_ = 0, metal_ = 0, exit_ = 0;
  std::optional<std::uint16_t> neon_;  // of looks that have it
  float band_low_ = 2.55F, board_low_ = 2.35F;
};

}  // namespace marketgen::render::raytrace
