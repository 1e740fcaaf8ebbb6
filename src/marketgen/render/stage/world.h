// What the ray tracer sees: triangles with their materials, instances of shared meshes, area
// lights, and the BVHs over them.
//
// The store's part is built once per scene (build_world) and constant afterwards; actors are set
// and moved between pictures (actor_stage.h). Read by any number of threads. Store frame, metres.
// Radiance is in lux per steradian, scaled so that the floor of the empty room gets
// Look::light_lux.
#pragma once
#include <array>
#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "base/result.h"
#include "geometry/mesh.h"
#include "geometry/pose.h"
#include "render/embree_handle.h"
#include "render/stage/item_look.h"
#include "render/stage/relief_texture.h"
#include "render/stage/surroundings.h"
#include "render/stage/texture.h"

namespace marketgen::render::raytrace {

// Ray masks: which kinds of geometry a ray meets.
constexpr unsigned mask_solid = 1;
constexpr unsigned mask_glass = 2;
constexpr unsigned mask_ceiling =
    4;  // ceiling, panels and what hangs there: left out of views from above
constexpr unsigned mask_opaque = mask_solid | mask_ceiling;

// The first 64 bytes are read as numbers side by side: see surface8.cpp.
struct Material {
  Vec3f color{0.8F, 0.8F, 0.8F};  // linear; multiplies the texture
  Vec3f emission{};               // radiance it sends out by itself
  float roughness = 0.5F, metallic = 0;
  std::int32_t texture = -1;  // index into World::textures
  // Index into World::reliefs: normals, and roughness and metallic instead of those above.
  std::int32_t relief = -1;
  float roughness_scale = 1;  // on the relief's
  bool glass = false;  // thin pane: reflects, lets the rest straight through, tinted by `color`
  // The wall of a clear pack, seen through; `color` is what pack and contents look like from afar.
  bool clear = false;

  // ---- What only path tracing reads ----
  float refraction = 1;      // clear only: index of what fills the pack behind this wall; 1 = air
  Vec3f absorption_per_m{};  // clear only: of what fills it (Beer-Lambert)
  float coat = 0, coat_roughness = 0.1F;  // share of a clear lacquer on top
  float translucency = 0;                 // share of diffuse light that leaves on the far side
  float scatter_m = 0;  // how far light wanders below the surface, mean; 0 = not at all
};

// A rectangle that lights: corner + u * edge_u + v * edge_v, on the side of `normal`.
struct AreaLight {
  Vec3f corner, edge_u, edge_v, normal, radiance;
  float area = 0;
  Vec3f middle() const { return corner + (edge_u + edge_v) * 0.5F; }
};
AreaLight make_area_light(Vec3f corner, Vec3f edge_u, Vec3f edge_v, Vec3f radiance);

// Everything about one triangle that shading needs, in one cache line.
struct alignas(64) TriangleRecord {
  std::array<std::array<std::int16_t, 3>, 3> normals;  // per vertex, in 1/32767
  std::array<std::int16_t, 3> face_normal;
  std::array<Vec2f, 3> uvs;
  float texel_density = 0;  // log2(texels per metre): mip level = this + log2(footprint)
  std::uint16_t material = 0;
  std::uint16_t tangent = 0;  // where the texture's rows run: see packed_tangent
  std::int32_t light = -1;  // of the light it shows: index into World::lights or TracedMesh::lights
  std::uint32_t owner = 0;  // Frame::instance id; triangles of instances take their instance's
};
static_assert(sizeof(TriangleRecord) == 64);

inline Vec3f unpacked_normal(const std::array<std::int16_t, 3>& n) {
  return normalized(
      Vec3f{static_cast<float>(n[0]), static_cast<float>(n[1]), static_cast<float>(n[2])});
}
// The direction in which u grows on a triangle, as an angle in the TangentFrame of its face normal;
// the lowest bit is set where the texture is seen mirrored.
std::uint16_t packed_tangent(const std::array<Vec3f, 3>& positions,
                             const std::array<Vec2f, 3>& uvs,
                             Vec3f face_normal);
struct TextureAxes {
  Vec3f along, up;  // of the texture's rows, and towards its top; unit vectors in the face's plane
};
TextureAxes texture_axes(std::uint16_t packed, Vec3f face_normal);

// Triangles under one Embree geometry.
struct TriangleSet {
  std::vector<Vec3f> positions;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<TriangleRecord> records;
  bool empty() const { return triangles.empty(); }
};

// One shape that many instances share, in its own frame.
struct TracedMesh {
  TriangleSet solid, glass;
  std::vector<AreaLight> lights;  // shown by its emissive triangles
  Bvh bvh;
};

// Rigid transform in single precision, for vectors and points.
struct Placement {
  Vec3f x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1}, position;  // images of the axes, and of the origin
  Vec3f turn(Vec3f v) const { return x * v.x + y * v.y + z * v.z; }
  Vec3f turn_back(Vec3f v) const { return {dot(x, v), dot(y, v), dot(z, v)}; }
  Vec3f operator()(Vec3f p) const { return turn(p) + position; }
  Vec3f to_local(Vec3f p) const { return turn_back(p - position); }
  friend bool operator==(const Placement&, const Placement&) = default;
};
Placement placement_of(const Pose& pose);

// The first 64 bytes are read as numbers side by side: see surface8.cpp.
struct alignas(64) Instance {
  std::uint32_t id = 0;                   // Frame::instance
  std::int32_t fixture = -1, shelf = -1;  // rows of the scene it belongs to, -1 = none
  ItemLook look;
  Placement world_from_mesh;
  std::uint32_t mesh = 0;
  std::int32_t joint = -1;       // row of the scene that moves it, -1 = none
  std::int32_t first_light = 0;  // its mesh's lights in World::lights
  // Of its mesh's geometries, by MeshGeometry; set when the BVHs are built.
  std::array<const TriangleRecord*, 2> records{};
};

// What stands in the store beside its scene. The World's rows from these on are theirs.
struct ActorRows {
  std::size_t first_mesh = 0, first_instance = 0, first_material = 0;
  Bvh bvh;  // instance first_instance + k is its geometry k; empty without actors
};

// Instances of the store that stand elsewhere now, as copies among the actors'. A small store's BVH
// is built anew without them; in a large one's they stay, and rays pass through their places.
struct HiddenRows {
  std::vector<std::uint8_t> is_hidden;  // of each of the store's instances; empty when none is
  Bounds3 bounds;                       // around the hidden places
  bool in_bvh = false;                  // rays have to pass them
  bool has(std::size_t instance) const {
    return instance < is_hidden.size() && is_hidden[instance] != 0;
  }
};

// A texture that the world has without its finest levels, as it would be drawn whole. Errors: of
// what draws it.
struct WholeTexture {
  int width = 0, height = 0;
  std::function<Result<Texture>()> draw;
};

struct World {
  Device device;
  std::string art_key;  // over what decides the textures' pixels
  std::vector<Texture> textures;
  std::map<std::size_t, WholeTexture> whole_tiles;  // by texture: of tiled materials kept coarse
  std::vector<ReliefTexture> reliefs;
  std::vector<Material> materials;
  TriangleSet shell, shell_glass, ceiling;  // in the store frame
  std::vector<TracedMesh> meshes;
  std::vector<Instance> instances;
  std::vector<AreaLight> lights;
  std::uint32_t panel_count = 0;  // the first lights are ceiling panels
  Surroundings surroundings;
  Bounds3 room;
  float exposure = 1;  // picture value = exposure * radiance
  bool has_glass = false;
  Bvh bvh;  // shell + the store's instances
  ActorRows actors;
  HiddenRows hidden;
  std::uint32_t first_product_instance = 0;  // of scene.products[0]
};

// Appends `mesh` with surface i drawn in material materials_of_surfaces[i]. UVs are used as they
// are. Panes of glass go to `glass`. Precondition: the materials' textures are loaded (their sizes
// set the mip levels).
struct TriangleOwner {
  std::uint32_t id = 0;
  std::int32_t light = -1;
};
void append(TriangleSet& solid,
            TriangleSet& glass,
            const Mesh& mesh,
            const std::vector<std::uint16_t>& materials_of_surfaces,
            const World& world,
            TriangleOwner owner);

// Builds the BVHs. Nothing but actors may be added to the world afterwards.
void commit(World& world);
// Frees them: no ray meets anything afterwards.
void drop_bvhs(World& world);
// Builds the BVHs of the actors' meshes and instances; none when there are no instances.
void commit_actors(World& world);
// Takes over where these of the actors' instances stand now.
void update_actors(World& world, std::span<const std::size_t> instances);
// Builds the store's BVH anew without what is hidden. `before`: as is_hidden was when it was built.
void leave_out_hidden(World& world, const std::vector<std::uint8_t>& before);

// Geometry ids in World::bvh; the store's instance i has id first_instance_geometry + i.
enum ShellGeometry : unsigned {
  shell_geometry,
  shell_glass_geometry,
  ceiling_geometry,
  first_instance_geometry
};
enum MeshGeometry : unsigned { mesh_solid_geometry, mesh_glass_geometry };

}  // namespace marketgen::render::raytrace
