#include "render/silhouette.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "base/parallel.h"
#include "render/cameras/view.h"
#include "render/tracing.h"

namespace marketgen::render::raytrace {
namespace {

using Box = std::array<double, 4>;  // x0, y0, x1, y1 from the picture's top left corner

struct PixelArea {
  int x0, y0, x1, y1;  // x1 and y1 are past the last
};

// Around all vertices of the object; nothing when some lie where the camera cannot project them.
std::optional<Box> box_around(const World& world,
                              const Projection& project,
                              std::span<const Instance* const> parts) {
  Box box{1e30, 1e30, -1e30, -1e30};
  for (const Instance* part : parts) {
    const TracedMesh& mesh = world.meshes[part->mesh];
    for (const TriangleSet* set : {&mesh.solid, &mesh.glass}) {
      for (const Vec3f& position : set->positions) {
        const auto p = project(to_double(part->world_from_mesh(position)));
        if (!p) return std::nullopt;
        box = {std::min(box[0], p->x + 0.5),
               std::min(box[1], p->y + 0.5),
               std::max(box[2], p->x + 0.5),
               std::max(box[3], p->y + 0.5)};
      }
    }
  }
  return box;
}

// The pixels that a box may touch; all of the picture without one.
PixelArea pixels_of(const std::optional<Box>& box, const View& view) {
  if (!box) return {0, 0, view.width(), view.height()};
  const auto clamped = [](double x, int most) {
    return static_cast<int>(std::clamp(x, 0.0, static_cast<double>(most)));
  };
  return {clamped(std::floor((*box)[0]) - 1, view.width()),
          clamped(std::floor((*box)[1]) - 1, view.height()),
          clamped(std::ceil((*box)[2]) + 1, view.width()),
          clamped(std::ceil((*box)[3]) + 1, view.height())};
}

bool covers(const World& world, const Instance& part, const Ray& ray) {
  const Placement& place = part.world_from_mesh;
  const Ray turned{place.to_local(ray.origin), place.turn_back(ray.direction), ray.near, ray.far};
  RTCRay query = embree_ray(turned, mask_solid);
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcOccluded1(world.meshes[part.mesh].bvh.get(), &context, &query);
  return query.tfar < 0;
}

bool is_fixture(std::span<const Instance* const> parts) {
  return std::ranges::any_of(parts, [](const Instance* part) { return part->fixture >= 0; });
}

int covered_pixels(const World& world,
                   const View& view,
                   const Frame& frame,
                   std::uint32_t object,
                   std::span<const Instance* const> parts,
                   const PixelArea& area) {
  int count = 0;
  for (int y = area.y0; y < area.y1; ++y) {
    for (int x = area.x0; x < area.x1; ++x) {
      const Ray ray = view.ray(static_cast<float>(x) + 0.5F, static_cast<float>(y) + 0.5F);
      const auto pixel = static_cast<std::size_t>(y) * static_cast<std::size_t>(view.width()) +
                         static_cast<std::size_t>(x);
      // Seen is covered, whatever the last bits of a turned ray say about its edge.
      const bool covered =
          frame.instance[pixel] == object || std::ranges::any_of(parts, [&](const Instance* part) {
            return covers(world, *part, ray);
          });
      count += covered ? 1 : 0;
    }
  }
  return count;
}

}  // namespace

std::vector<Silhouette> silhouettes_of(const World& world,
                                       const Camera& camera,
                                       const Frame& frame,
                                       std::span<const std::uint32_t> objects) {
  std::map<std::uint32_t, std::vector<const Instance*>> parts;
  for (const std::uint32_t object : objects)
    parts[object];
  for (std::size_t i = 0; i < world.instances.size(); ++i) {
    if (world.hidden.has(i)) continue;  // its copy among the actors' is what is to be seen
    if (const auto found = parts.find(world.instances[i].id); found != parts.end())
      found->second.push_back(&world.instances[i]);
  }
  const View view(camera);
  const Projection project(camera);
  return parallel_map(objects.size(), [&](std::size_t i) {
    const std::span<const Instance* const> own = parts.at(objects[i]);
    Silhouette result{objects[i], {}, box_around(world, project, own)};
    if (!is_fixture(own)) {
      const PixelArea area = pixels_of(result.box_px, view);
      result.pixels = covered_pixels(world, view, frame, objects[i], own, area);
    }
    return result;
  });
}

}  // namespace marketgen::render::raytrace
