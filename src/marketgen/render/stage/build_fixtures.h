// Fixtures as instances; equal modules share one mesh.
#pragma once
#include <vector>

#include "geometry/mesh.h"
#include "render/stage/draft.h"

namespace marketgen::render::raytrace {

class FixtureBuilder {
 public:
  explicit FixtureBuilder(Draft& draft);
  void build(Draft& draft);

 private:
  // One box of light, before its faces are known to be free.
  struct Lamp {
    std::uint16_t material = 0;
    std::uint32_t part = 0;  // row in scene.parts
  };
  // What one joint moves, or the fixed body.
  struct Body {
    std::int32_t joint = -1;  // counted from the fixture's first; -1: fixed
    Mesh mesh;                // without lamps; its surfaces index `materials`
    std::vector<std::uint16_t> materials;
  };
  struct Shape {
    std::vector<Body> bodies;  // the fixed one first
    std::vector<Lamp> lamps;   // of the fixed body
    std::uint32_t first_mesh = 0;
  };
  static Shape make_shape(Draft& draft, const scene::SceneFixture& fixture);
  static Body& body_of(Shape& shape, std::int32_t joint);
  static void add_lamps(Draft& draft, const Shape& shape, TracedMesh& mesh);
  static void add_instances(World& world,
                            const scene::Scene& scene,
                            std::size_t row,
                            const Shape& shape);

  std::vector<Shape> shapes_;
  std::vector<std::uint32_t> shape_of_fixture_;
};

}  // namespace marketgen::render::raytrace
