// The room that is drawn is the room that is touched: rays through random rooms meet the drawn
// shell where they meet the physical one, and both have the same outer faces.
//
// Not the same are: entrances and exits, which stand open in physics and have a sliding door in
// pictures; skirting, push bars and bevelled edges, which physics does without; and the panes of
// windows, which physics has as thick as their frames.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <vector>

#include "physics/world/shell_pieces.h"
#include "plan/shell_measures.h"
#include "render/stage/build_shell.h"
#include "support/plan_sampler.h"
#include "support/random_plan.h"

namespace marketgen {
namespace {

constexpr double nothing_m = std::numeric_limits<double>::infinity();

struct Ray {
  Vec3 from, way;  // the way is horizontal, of length 1
};

// ---- What is drawn ----

std::unique_ptr<render::raytrace::World> drawn_shell(const plan::Shell& shell) {
  scene::Scene scene;
  scene.layout.shell = shell;
  auto world = std::make_unique<render::raytrace::World>();
  render::raytrace::Draft draft(scene, *world, {.print = render::PrintDetail::distant});
  const render::raytrace::Room room = render::raytrace::room_of(shell);
  const render::raytrace::ShellBuilder builder(draft, room);
  builder.build(draft);
  return world;
}

// Where the ray meets the triangle (Moeller and Trumbore 1997).
double distance_to(const Ray& ray, Vec3 a, Vec3 b, Vec3 c) {
  const Vec3 u = b - a, v = c - a, p = cross(ray.way, v);
  const double turned = dot(u, p);
  if (std::abs(turned) < 1e-12) return nothing_m;
  const Vec3 off = ray.from - a;
  const double s = dot(off, p) / turned;
  const Vec3 q = cross(off, u);
  const double t = dot(ray.way, q) / turned, along = dot(v, q) / turned;
  return s < 0 || t < 0 || s + t > 1 || along <= 0 ? nothing_m : along;
}

double drawn_m(const render::raytrace::World& world, const Ray& ray) {
  double nearest = nothing_m;
  for (const render::raytrace::TriangleSet* set : {&world.shell, &world.shell_glass}) {
    for (const auto& [a, b, c] : set->triangles) {
      const auto corner = [&](std::uint32_t i) {
        const Vec3f p = set->positions[i];
        return Vec3{p.x, p.y, p.z};
      };
      nearest = std::min(nearest, distance_to(ray, corner(a), corner(b), corner(c)));
    }
  }
  return nearest;
}

// ---- What is touched ----

double distance_to(const Ray& ray, const physics::ShellPiece& piece) {
  const Pose back = inverse(piece.pose);
  const Vec3 o = back * ray.from, d = rotate(back.rotation, ray.way), half = piece.half_size;
  double enter = 0, leave = nothing_m;
  for (const auto& [from, way, size] :
       {std::array{o.x, d.x, half.x}, std::array{o.y, d.y, half.y}, std::array{o.z, d.z, half.z}}) {
    if (std::abs(way) < 1e-12) {
      if (std::abs(from) > size) return nothing_m;
      continue;
    }
    const auto [low, high] = std::minmax({(-size - from) / way, (size - from) / way});
    enter = std::max(enter, low);
    leave = std::min(leave, high);
  }
  return enter < leave ? enter : nothing_m;
}

// The piece that the ray meets first; null when it leaves the room.
const physics::ShellPiece* touched(const std::vector<physics::ShellPiece>& pieces, const Ray& ray) {
  const physics::ShellPiece* first = nullptr;
  double nearest = nothing_m;
  for (const physics::ShellPiece& piece : pieces) {
    const double distance = distance_to(ray, piece);
    if (distance >= nearest) continue;
    nearest = distance;
    first = &piece;
  }
  return first;
}

// The ray only clips an edge of the piece, which is bevelled in pictures: with as much taken off
// all round, it would miss.
bool only_clips(const physics::ShellPiece& piece, const Ray& ray) {
  constexpr double bevel_m = 0.015;  // the largest is that of columns: 10 mm
  physics::ShellPiece core = piece;
  core.half_size = core.half_size - Vec3{bevel_m, bevel_m, 0};
  return distance_to(ray, core) == nothing_m;
}

// How far a place is from the piece's surface, inside or outside.
double off_surface_m(const physics::ShellPiece& piece, Vec3 place) {
  const Vec3 at = inverse(piece.pose) * place;
  const double x = std::abs(at.x) - piece.half_size.x, y = std::abs(at.y) - piece.half_size.y,
               z = std::abs(at.z) - piece.half_size.z;
  const double inside = std::max({x, y, z});
  return inside <= 0 ? -inside : length(Vec3{std::max(x, 0.0), std::max(y, 0.0), std::max(z, 0.0)});
}

// How far off the physical surface a picture may show it.
double tolerance_m(physics::ShellPieceKind kind) {
  switch (kind) {
    case physics::ShellPieceKind::wall:
      return 0.002;  // plans are in millimetres
    case physics::ShellPieceKind::door:
      return 0.010;  // kick plates, bevels and the gap between leaves
    case physics::ShellPieceKind::column:
      return 0.015;  // a bevel
    case physics::ShellPieceKind::pane:
      break;
  }
  return (plan::glazing_back_m - plan::glazing_front_m) / 2;  // glass in the middle of its frame
}

// The ray crosses a wall's inner face in an opening that stands open in physics, or so near to an
// edge of any that a millimetre decides what it meets.
bool is_left_out(const plan::Shell& shell, const Ray& ray) {
  constexpr double edge_m = 0.025;  // as much wall is kept beside an opening that is drawn
  for (const plan::Opening& opening : shell.openings) {
    const bool along_x = opening.wall == plan::Wall::north || opening.wall == plan::Wall::south;
    const double line = opening.wall == plan::Wall::north  ? shell.depth_mm * 1e-3
                        : opening.wall == plan::Wall::east ? shell.width_mm * 1e-3
                                                           : 0;
    const double step = along_x ? ray.way.y : ray.way.x;
    const double go = (line - (along_x ? ray.from.y : ray.from.x)) / step;
    const double length = (along_x ? shell.width_mm : shell.depth_mm) * 1e-3;
    const double at = along_x ? ray.from.x + go * ray.way.x : ray.from.y + go * ray.way.y;
    const double off = std::abs(at - opening.center * length) - opening.width_mm * 5e-4;
    const double top = plan::opening_top_m(opening.kind, shell.ceiling_mm * 1e-3);
    const double over = std::max(ray.from.z - top, plan::opening_sill_m(opening.kind) - ray.from.z);
    if (go < 0 || std::max(off, over) > edge_m) continue;
    const bool shop_door =
        opening.kind == plan::OpeningKind::entrance || opening.kind == plan::OpeningKind::exit;
    if (shop_door || std::max(off, over) > -edge_m) return true;
  }
  return false;
}

// Over the skirting and under the ceiling, and not where doors have their push bars.
Ray random_ray(const plan::Shell& shell, Stream& draw) {
  const double ceiling = shell.ceiling_mm * 1e-3;
  double z = 0;
  do
    z = draw.uniform(0.12, ceiling - 0.05);
  while (z > 0.97 && z < 1.06);
  const double way = draw.uniform(0, 2 * std::acos(-1.0));
  return {{draw.uniform(0.05, shell.width_mm * 1e-3 - 0.05),
           draw.uniform(0.05, shell.depth_mm * 1e-3 - 0.05),
           z},
          {std::cos(way), std::sin(way), 0}};
}

bool is_in_the_room(const plan::Shell& shell, Vec3 place) {
  const PointMm p = floor_mm(place);
  constexpr int clear_mm = 50;
  const bool in_column = std::ranges::any_of(shell.columns, [&](const plan::Column& column) {
    return plan::footprint_of(column).grown(clear_mm).contains(p);
  });
  return !in_column && (!shell.outline_mm || contains(*shell.outline_mm, p));
}

struct Compared {
  int rays = 0, left_out = 0;
  std::array<int, 4> met{};  // by ShellPieceKind
};

void compare(const plan::Shell& shell, Stream& draw, Compared& compared) {
  const auto world = drawn_shell(shell);
  const std::vector<physics::ShellPiece> pieces = physics::shell_pieces(shell);
  for (int i = 0; i < 100; ++i) {
    const Ray ray = random_ray(shell, draw);
    if (!is_in_the_room(shell, ray.from)) continue;
    ++compared.rays;
    if (is_left_out(shell, ray)) {
      ++compared.left_out;
      continue;
    }
    const physics::ShellPiece* piece = touched(pieces, ray);
    const double seen_m = drawn_m(*world, ray);
    ASSERT_NE(piece, nullptr) << "seen at " << seen_m << " m, but nothing is there";
    ASSERT_LT(seen_m, nothing_m) << piece->id << " is not drawn";
    if (only_clips(*piece, ray)) {
      ++compared.left_out;
      continue;
    }
    EXPECT_LE(off_surface_m(*piece, ray.from + ray.way * seen_m), tolerance_m(piece->kind))
        << piece->id;
    ++compared.met[static_cast<std::size_t>(piece->kind)];
  }
}

TEST(ShellProperty, RaysMeetWhatIsDrawnWhereItIsTouched) {
  Compared compared;
  PlanSampler sampler;
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    SCOPED_TRACE(seed);
    Stream draw = Seed(seed).child("shell").stream();  // of rays, however many fields a plan has
    Stream plans = Seed(seed).child("plans").stream();
    compare(RandomPlan(seed).make().shell, draw, compared);
    compare(sampler.random_plan(plans).shell, draw, compared);
  }
  EXPECT_GT(compared.rays, 15'000);
  EXPECT_LT(5 * compared.left_out, compared.rays);
  for (std::size_t kind = 0; kind < compared.met.size(); ++kind)
    EXPECT_GT(compared.met[kind], 20) << physics::names_of(physics::ShellPieceKind{})[kind];
}

struct Extent {
  double low_x = nothing_m, low_y = nothing_m, high_x = -nothing_m, high_y = -nothing_m;
  void include(Vec3 p) {
    low_x = std::min(low_x, p.x), high_x = std::max(high_x, p.x);
    low_y = std::min(low_y, p.y), high_y = std::max(high_y, p.y);
  }
};

TEST(ShellProperty, WallsAreDrawnAsThickAsTheyAre) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    plan::Shell shell = RandomPlan(seed).make().shell;
    shell.outline_mm.reset();
    Extent drawn, physical;
    const auto world = drawn_shell(shell);
    for (const Vec3f& p : world->shell.positions)
      drawn.include({p.x, p.y, p.z});
    for (const physics::ShellPiece& piece : physics::shell_pieces(shell)) {
      for (const double x : {-piece.half_size.x, piece.half_size.x}) {
        for (const double y : {-piece.half_size.y, piece.half_size.y})
          physical.include(piece.pose * Vec3{x, y, 0});
      }
    }
    EXPECT_NEAR(drawn.low_x, physical.low_x, 1e-4);
    EXPECT_NEAR(drawn.low_y, physical.low_y, 1e-4);
    EXPECT_NEAR(drawn.high_x, physical.high_x, 1e-4);
    EXPECT_NEAR(drawn.high_y, physical.high_y, 1e-4);
    EXPECT_NEAR(drawn.high_x, shell.width_mm * 1e-3 + plan::wall_thickness_m, 1e-4);
  }
}

}  // namespace
}  // namespace marketgen
