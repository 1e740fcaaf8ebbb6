#include "assets/fixture_model.h"

#include <algorithm>
#include <utility>

#include "assets/fixtures/generator.h"
#include "assets/fixtures/palette.h"

namespace marketgen {
namespace {

struct Generator {
  std::string_view name, description;
  Result<FixtureModel> (*make)(const FixtureShape&, const FixturePalette&);
};

constexpr Generator generators[] = {
#define FIXTURE_GENERATOR(name, description) {#name, description, make_##name},
#include "assets/fixture_generators.inc"
#undef FIXTURE_GENERATOR
};

Error unknown_generator(std::string_view name) {
  std::vector<std::string_view> known;
  for (const Generator& generator : generators)
    known.push_back(generator.name);
  return unknown_name("catalog.unknown_kind", "generator", "fixture generator", name, known);
}

constexpr float bevel_m = 0.002F;
constexpr float thinnest_bevelled_m =
    0.006F;  // half size: a bevel would eat a third of anything thinner
constexpr int cylinder_segments = 24;
constexpr float pi = 3.14159265F;

Mesh box_mesh(const FixturePart& part, std::uint16_t surface) {
  const Vec3f half = part.half_size;
  const float thinnest = std::min({half.x, half.y, half.z});
  Mesh mesh;
  add_box(mesh, -half, half, thinnest >= thinnest_bevelled_m ? bevel_m : 0.0F, surface, 1.0F);
  return mesh;
}

// A capped cylinder whose texture coordinates are metres along the surface.
Mesh cylinder_mesh(const FixturePart& part, std::uint16_t surface) {
  const float radius = part.half_size.x;
  const float half_length = part.half_size.z;
  const std::vector<ProfilePoint> profile{{0, -half_length, surface, true},
                                          {radius, -half_length, surface, true},
                                          {radius, half_length, surface, true},
                                          {0, half_length, surface, true}};
  Mesh mesh;
  add_lathe(mesh, profile, cylinder_segments);
  const float around_m = 2 * pi * radius;
  const float along_m = 2 * radius + 2 * half_length;
  for (Vec2f& uv : mesh.uvs)
    uv = {uv.x * around_m, uv.y * along_m};
  return mesh;
}

// Sizes that are too far from the usual ones leave nothing of some part.
Result<void> require_parts(const FixtureShape& shape, const FixtureModel& model) {
  const bool whole = std::ranges::all_of(model.parts, [](const FixturePart& part) {
    return part.half_size.x > 0 && part.half_size.y > 0 && part.half_size.z > 0;
  });
  if (whole) return {};
  return Error{"assets.bad_row",
               shape.generator,
               "a " + shape.generator + " of " + std::to_string(shape.width_mm) + " x " +
                   std::to_string(shape.depth_mm) + " x " + std::to_string(shape.height_mm) +
                   " mm has no room for all its parts; ask for measures nearer to the usual ones"};
}

}  // namespace

Result<FixtureModel> make_fixture_model(const FixtureShape& shape, const Catalog& catalog) {
  for (const Generator& generator : generators) {
    if (generator.name != shape.generator) continue;
    MARKETGEN_TRY(const FixturePalette palette, make_palette(shape, catalog));
    MARKETGEN_TRY(FixtureModel model, generator.make(shape, palette));
    MARKETGEN_CHECK(require_parts(shape, model));
    return model;
  }
  return unknown_generator(shape.generator);
}

std::vector<FixtureGeneratorInfo> fixture_generators() {
  std::vector<FixtureGeneratorInfo> list;
  for (const Generator& generator : generators) {
    list.push_back({generator.name, generator.description});
  }
  return list;
}

void add_part_mesh(Mesh& mesh, const FixturePart& part, std::uint16_t surface) {
  Mesh own = part.shape == PartShape::box ? box_mesh(part, surface) : cylinder_mesh(part, surface);
  place(own, part.fixture_from_part);
  mesh.append(own);
}

}  // namespace marketgen
