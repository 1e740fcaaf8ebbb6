// What hangs on a shop's ceiling beside lamps and signs: air outlets, smoke detectors, sprinklers,
// cameras; below a dark, open one the air ducts themselves.
#pragma once
#include <cstdint>

#include "render/stage/draft.h"
#include "render/stage/room.h"

namespace marketgen::render::raytrace {

class CeilingBuilder {
 public:
  CeilingBuilder(Draft& draft, const Room& room);
  // After the lamps: nothing hangs where one does.
  void build(Draft& draft) const;

 private:
  enum Finish : std::uint16_t { white, slot, metal, dome, duct, finishes };
  void add_services(Mesh& mesh, const World& world) const;
  void add_ducts(Mesh& mesh, const World& world) const;

  const Room& room_;
  std::vector<std::uint16_t> materials_;  // by Finish
  bool open_ = false;                     // dark: one sees past the ducts into nothing
};

}  // namespace marketgen::render::raytrace
