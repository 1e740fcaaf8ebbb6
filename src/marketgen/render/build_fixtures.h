// Fixtures as instances; equal modules share one mesh.
#pragma once
#include <vector>

#include "geometry/mesh.h"
#include "render/draft.h"

namespace marketgen::raytrace {

class FixtureBuilder {
 public:
  explicit FixtureBuilder(Draft& draft);
  void build(Draft& draft) const;

 private:
  // One box of light, before its faces are known to be free.
  struct Lamp {
    std::uint16_t material = 0;
    std::uint32_t part = 0;  // row in scene.parts
  };
  struct Shape {
    Mesh mesh;  // without lamps; its surfaces index `materials`
    std::vector<std::uint16_t> materials;
    std::vector<Lamp> lamps;
  };
  static Shape make_shape(Draft& draft, const SceneFixture& fixture);
  static void add_lamps(Draft& draft, const Shape& shape, TracedMesh& mesh);

  std::vector<Shape> shapes_;
  std::vector<std::uint32_t> shape_of_fixture_;
};

}  // namespace marketgen::raytrace
