// What dresses the room: posters on free walls and on the ends of shelves, mats behind the doors.
#pragma once
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "render/stage/draft.h"
#include "render/stage/room.h"

namespace marketgen::render::raytrace {

class DecorBuilder {
 public:
  DecorBuilder(Draft& draft, const Room& room);
  void build(Draft& draft) const;

 private:
  // A sheet of paper: its middle's lower edge, the wall's or fixture's frame (y out of it), width.
  struct Sheet {
    Placement at;
    float width = 0;
    bool framed = false;
    std::uint32_t owner = 0;  // object in the picture
    std::uint16_t material = 0;
  };
  void hang_on_walls(Draft& draft);
  void hang_on_ends(Draft& draft);
  void hang(Draft& draft, Sheet sheet, const std::string& zone_type);
  void add_mats(Draft& draft) const;

  const Room& room_;
  std::vector<Sheet> sheets_;
  std::map<std::string, unsigned> hung_;  // posters so far, by zone type
  std::uint16_t frame_ = 0, mat_ = 0, mat_edge_ = 0;
};

}  // namespace marketgen::render::raytrace
