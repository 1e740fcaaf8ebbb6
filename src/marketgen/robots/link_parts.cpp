#include "robots/link_parts.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "io/model_file.h"
#include "robots/rotation.h"

namespace marketgen::robots {
namespace {

constexpr double quarter_turn = std::numbers::pi / 2;
constexpr int tube_segments = 32, ball_rings = 12, corner_steps = 4;
constexpr const char* capsule_color = "#b9bcc0";

// Adds the triangle unless two of its corners are one point.
void add_sound_triangle(Mesh& mesh, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  const Vec3f pa = mesh.positions[a], pb = mesh.positions[b], pc = mesh.positions[c];
  if (pa == pb || pb == pc || pc == pa) return;
  mesh.add_triangle(a, b, c, 0);
}

// A ball cut into eight pieces that are moved into the corners of a box; strips join them. Column j
// of a ring looks along the angle of its place in its quarter; rings go from the bottom up.
class RoundedBox {
 public:
  RoundedBox(Vec3 size, double rounding)
      : inner_(size / 2.0 - Vec3{rounding, rounding, rounding}), rounding_(rounding) {}

  Mesh build() {
    for (int half = 0; half < 2; ++half) {
      for (int i = 0; i <= corner_steps; ++i)
        add_ring(half, (half - 1 + static_cast<double>(i) / corner_steps) * quarter_turn);
    }
    constexpr int rings = 2 * (corner_steps + 1);
    for (int ring = 0; ring + 1 < rings; ++ring)
      add_strip(ring);
    add_cap(0, false);
    add_cap(rings - 1, true);
    return std::move(mesh_);
  }

 private:
  static constexpr int columns = 4 * (corner_steps + 1);

  void add_ring(int half, double latitude) {
    for (int quarter = 0; quarter < 4; ++quarter) {
      const double sx = quarter == 0 || quarter == 3 ? 1 : -1, sy = quarter < 2 ? 1 : -1;
      const Vec3 corner = inner_ * Vec3{sx, sy, half == 1 ? 1.0 : -1.0};
      for (int i = 0; i <= corner_steps; ++i) {
        const double turn = (quarter + static_cast<double>(i) / corner_steps) * quarter_turn;
        const Vec3 out{std::cos(latitude) * std::cos(turn),
                       std::cos(latitude) * std::sin(turn),
                       std::sin(latitude)};
        mesh_.add_vertex(to_float(corner + out * rounding_), to_float(out), {});
      }
    }
  }
  static std::uint32_t at(int ring, int column) {
    return static_cast<std::uint32_t>(ring * columns + column % columns);
  }
  void add_strip(int ring) {
    for (int k = 0; k < columns; ++k) {
      add_sound_triangle(mesh_, at(ring, k), at(ring, k + 1), at(ring + 1, k + 1));
      add_sound_triangle(mesh_, at(ring, k), at(ring + 1, k + 1), at(ring + 1, k));
    }
  }
  void add_cap(int ring, bool upwards) {
    constexpr int quarter = corner_steps + 1;
    const std::uint32_t a = at(ring, 0), b = at(ring, quarter), c = at(ring, 2 * quarter),
                        d = at(ring, 3 * quarter);
    add_sound_triangle(mesh_, a, upwards ? b : c, upwards ? c : b);
    add_sound_triangle(mesh_, a, upwards ? c : d, upwards ? d : c);
  }

  Vec3 inner_;
  double rounding_;
  Mesh mesh_;
};

Mesh box_mesh(const BodyShape& shape) {
  const double least = std::min({shape.size.x, shape.size.y, shape.size.z});
  if (!(least > 0)) return {};
  if (shape.rounding > 0)
    return RoundedBox(shape.size, std::min(shape.rounding, 0.499 * least)).build();
  const Vec3f half = to_float(shape.size / 2.0);
  Mesh mesh;
  add_box(mesh, -half, half, 0, 0);
  return mesh;
}

Mesh tube_mesh(const BodyShape& shape) {
  const double length = shape.length, low = shape.radius, high = shape.radius_end;
  if (!(length > 0 && low > 0 && high > 0)) return {};
  const double rounding = std::min({shape.rounding, 0.499 * length, 0.999 * low, 0.999 * high});
  std::vector<ProfilePoint> profile;
  const auto add = [&](double radius, double z, bool crease) {
    profile.push_back({static_cast<float>(radius), static_cast<float>(z), 0, crease});
  };
  add(0, 0, false);
  if (rounding > 0) {
    for (int i = 0; i <= corner_steps; ++i) {
      const double turn = quarter_turn * i / corner_steps;
      add(low - rounding + rounding * std::sin(turn), rounding * (1 - std::cos(turn)), i == 0);
    }
    for (int i = 0; i <= corner_steps; ++i) {
      const double turn = quarter_turn * i / corner_steps;
      add(high - rounding + rounding * std::cos(turn),
          length - rounding * (1 - std::sin(turn)),
          i == corner_steps);
    }
  } else {
    add(low, 0, true);
    add(high, length, true);
  }
  add(0, length, false);
  Mesh mesh;
  add_lathe(mesh, profile, tube_segments);
  return mesh;
}

Mesh ball_mesh(double radius) {
  if (!(radius > 0)) return {};
  std::vector<ProfilePoint> profile;
  for (int i = 0; i <= ball_rings; ++i) {
    const double turn = quarter_turn * (2.0 * i / ball_rings - 1);
    const bool pole = i == 0 || i == ball_rings;
    profile.push_back({pole ? 0.0F : static_cast<float>(radius * std::cos(turn)),
                       static_cast<float>(radius * std::sin(turn)),
                       0});
  }
  Mesh mesh;
  add_lathe(mesh, profile, tube_segments);
  return mesh;
}

Result<Mesh> mesh_from_file(const BodyShape& shape) {
  const std::filesystem::path file = shape.mesh_file;
  const std::string kind = file.extension().string();
  if (kind != ".glb" && kind != ".obj")
    return Error{"robot.bad_file",
                 shape.mesh_file,
                 "a mesh of kind \"" + kind + "\" cannot be read; convert it to .glb or .obj"};
  MARKETGEN_TRY(io::OutsideModel model, io::read_model_file(file));
  for (Vec3f& p : model.mesh.positions)
    p = p * to_float(shape.size);
  std::fill(model.mesh.surfaces.begin(), model.mesh.surfaces.end(), std::uint16_t{0});
  place(model.mesh, shape.link_from_shape);
  return model.mesh;
}

std::vector<BodyShape> shapes_of_capsules(const Link& link) {
  std::vector<BodyShape> shapes;
  for (const Capsule& c : link.capsules) {
    const Vec3 along = c.b - c.a;
    const Pose at{c.a, rotation_from_z_to(length(along) > 0 ? normalized(along) : Vec3{0, 0, 1})};
    BodyShape ball;
    ball.kind = ShapeKind::ball, ball.link_from_shape = at, ball.radius = c.radius;
    BodyShape tube = ball;
    tube.kind = ShapeKind::tube, tube.radius_end = c.radius, tube.length = length(along);
    ball.color = tube.color = capsule_color;
    shapes.push_back(ball);
    ball.link_from_shape.position = c.b;
    shapes.push_back(ball);
    if (tube.length > 0) shapes.push_back(tube);
  }
  return shapes;
}

bool same_finish(const LinkPart& part, const BodyShape& shape) {
  return part.color == shape.color && part.roughness == shape.roughness &&
         part.metallic == shape.metallic;
}

}  // namespace

Mesh mesh_of(const BodyShape& shape) {
  Mesh mesh;
  switch (shape.kind) {
    case ShapeKind::box:
      mesh = box_mesh(shape);
      break;
    case ShapeKind::tube:
      mesh = tube_mesh(shape);
      break;
    case ShapeKind::ball:
      mesh = ball_mesh(shape.radius);
      break;
    case ShapeKind::mesh:
      break;
  }
  place(mesh, shape.link_from_shape);
  return mesh;
}

Result<std::vector<LinkPart>> link_parts(const Link& link) {
  std::vector<LinkPart> parts;
  for (const BodyShape& shape : link.look.empty() ? shapes_of_capsules(link) : link.look) {
    Mesh mesh;
    if (shape.kind == ShapeKind::mesh) {
      MARKETGEN_TRY(mesh, mesh_from_file(shape));
    } else {
      mesh = mesh_of(shape);
    }
    auto part = std::find_if(
        parts.begin(), parts.end(), [&](const LinkPart& p) { return same_finish(p, shape); });
    if (part == parts.end())
      part = parts.insert(parts.end(), LinkPart{{}, shape.color, shape.roughness, shape.metallic});
    part->mesh.append(mesh);
  }
  return parts;
}

Result<std::vector<std::vector<LinkPart>>> robot_parts(const Robot& robot,
                                                       std::span<const Pose> base_from_link) {
  std::vector<std::vector<LinkPart>> all;
  for (std::size_t link = 0; link < robot.links.size(); ++link) {
    MARKETGEN_TRY(std::vector<LinkPart> parts, link_parts(robot.links[link]));
    for (LinkPart& part : parts)
      place(part.mesh, base_from_link[link]);
    all.push_back(std::move(parts));
  }
  return all;
}

}  // namespace marketgen::robots
