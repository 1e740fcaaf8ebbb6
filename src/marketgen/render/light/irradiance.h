// Light stored in the air: how much arrives from each side, at points between the boards of every
// shelf and on a coarse grid through the room.
//
// Used to light what rays see at second hand (bounces, reflections), where a blurred answer is
// enough and noise is not. Shelf points are bounded by their boards, so that light does not leak
// into compartments as it would through a plain room grid.
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "render/light/light_grid.h"
#include "render/path/float4.h"
#include "render/sensor/float8.h"
#include "render/tracing.h"
#include "scene/scene.h"

namespace marketgen::render::raytrace {

// Irradiance on a surface facing +x, -x, +y, -y, +z, -z.
struct AmbientCube {
  std::array<Vec3f, 6> faces;
  float validity = 0;  // 0 inside solid matter
  Vec3f irradiance(Vec3f normal) const;
};

// The same in half precision, one cache line; the faces' fourth channel is the validity.
struct alignas(64) PackedCube {
  std::array<std::array<std::uint16_t, 4>, 6> faces;
};

// What a bake makes: of each probe.
struct BakedLight {
  std::vector<PackedCube> probes, without_panels;  // all light, and all but the panels' own
  Vec3f mean;            // of the valid room probes: where nothing is known
  float floor_mean = 0;  // irradiance, see IrradianceField::floor_mean()
};

// Where light is asked for, and what stands there: rows of the scene, -1 = none.
struct Place {
  Vec3f point;
  std::int32_t fixture = -1, shelf = -1;
};
Place place_of(Vec3f position, Vec3f face_normal, std::int32_t fixture, std::int32_t shelf);
Place place_of(const Surface& surface);

class IrradianceField {
 public:
  // Deterministic for any thread count. With `keep`, light is taken from the disk where an earlier
  // bake left it, and left there; see light_cache.h.
  IrradianceField(const World& world,
                  const LightGrid& lights,
                  const scene::Scene& scene,
                  bool keep = false);

  // Irradiance on something at `place` that faces `facing`; over pi it is the mean radiance from
  // that side.
  Vec3f at(const Place& place, Vec3f facing) const;

  // The same, and what comes from the side of `mirror` when the ceiling's panels are left out (they
  // are too bright and too small for so coarse a store: see PanelReflection).
  struct TwoSided {
    Float4 facing, mirror;
  };
  TwoSided at(const Place& place, Float4 facing, Float4 mirror) const;

  // Row of the scene's shelf in whose room a point lies; -1: in none.
  std::int32_t shelf_at(Vec3f point) const;

  // Light on something that is tilted from `facing` over the light on it when it is not.
  float tilt(const Place& place, Vec3f facing, Vec3f tilted) const;

  // Mean irradiance on level surfaces just above the free floor: what a light meter carried through
  // the shop reads.
  float floor_mean() const { return light_.floor_mean; }
  // Irradiance on what stands at the front edges of shelves and faces the aisle: the median over
  // their length, half way up. 0 without shelves.
  float goods_median() const;

 private:
  static constexpr int depth_rows = 4, height_rows = 3;
  // Depths of the probe rows behind a shelf's front edge: one row before the edge, where goods
  // catch the most light.
  static constexpr std::array<float, depth_rows> depth_share{-0.1F, 0.12F, 0.4F, 0.85F};
  static constexpr std::array<float, height_rows> height_share{0.12F, 0.5F, 0.88F};
  struct Shelf {
    Placement world_from_shelf;
    Vec3f size;               // width, depth, clearance
    std::uint32_t first = 0;  // of its probes
    int columns = 2;
  };
  // Probe indices around a point and their weights.
  struct Corners {
    Int8 probe;
    Float8 weight;
  };
  void place_room(const World& world);
  void place_shelves(const scene::Scene& scene);
  void bake(const World& world, const LightGrid& lights, const PolygonMm& outline);
  void fill_invalid(std::vector<AmbientCube>& probes) const;
  void fill_room(std::vector<AmbientCube>& probes) const;
  AmbientCube mean_around(const std::vector<AmbientCube>& room, int index) const;
  int room_count() const { return size_[0] * size_[1] * size_[2]; }
  Vec3f mean_of_room() const;
  float mean_of_floor() const;
  const Shelf* shelf_of(const Place& place, Vec3f facing) const;
  Corners corners_at(const Place& place, Float4 facing) const;
  Corners corners_in_shelf(const Shelf& shelf, Vec3f point) const;
  Corners corners_in_room(Vec3f point, Float4 facing) const;
  Float4 gathered(const std::vector<PackedCube>& probes,
                  const Corners& corners,
                  Float4 facing) const;

  std::vector<Vec3f> positions_;
  std::vector<AmbientCube> probes_;  // while baking
  BakedLight light_;
  std::vector<Shelf> shelves_;
  std::vector<std::array<std::uint32_t, 2>> shelves_of_fixture_;  // first, count
  Vec3f low_, step_;
  std::array<int, 3> size_{2, 2, 2};
};

}  // namespace marketgen::render::raytrace
