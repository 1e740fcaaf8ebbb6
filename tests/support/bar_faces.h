// Packs hung in a bright room with their bar codes to the camera, as a cashier turns them, and what
// a scanner reads from the pictures (zbarimg, a separate program).
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "assets/print/label.h"
#include "assets/product_model.h"
#include "geometry/pose.h"
#include "io/png.h"
#include "render/render.h"
#include "render/stage/label_library.h"
#include "support/run_program.h"

namespace marketgen {

// Where the middle of a product's bars lies on its mesh, product frame.
struct BarFace {
  Vec3 middle, outward, up;  // up: against v
  double length_m = 0;       // of the bars and, roughly, of the whole symbol across them
  bool ladder = false;
};

namespace bar_faces {

inline Vec3 wide(Vec3f v) {
  return {static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z)};
}

// The triangle of the label that holds (u, v), as a frame there.
inline std::optional<BarFace> face_at(const assets::ProductModel& model,
                                      const assets::LabelBars& bars) {
  const double u = (bars.u0 + bars.u1) / 2, v = (bars.v0 + bars.v1) / 2;
  const Mesh& mesh = model.mesh;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (model.surfaces[mesh.surfaces[t]].texture != "label") continue;
    const auto [a, b, c] = mesh.triangles[t];
    const Vec2f ta = mesh.uvs[a], tb = mesh.uvs[b] - ta, tc = mesh.uvs[c] - ta;
    const double area = static_cast<double>(tb.x) * static_cast<double>(tc.y) -
                        static_cast<double>(tc.x) * static_cast<double>(tb.y);
    if (std::fabs(area) < 1e-12) continue;
    const double du = u - static_cast<double>(ta.x), dv = v - static_cast<double>(ta.y);
    const double wb = (du * static_cast<double>(tc.y) - dv * static_cast<double>(tc.x)) / area;
    const double wc = (dv * static_cast<double>(tb.x) - du * static_cast<double>(tb.y)) / area;
    if (wb < 0 || wc < 0 || wb + wc > 1) continue;
    const Vec3 pa = wide(mesh.positions[a]), pb = wide(mesh.positions[b]) - pa,
               pc = wide(mesh.positions[c]) - pa;
    const Vec3 along_u = (pb * static_cast<double>(tc.y) - pc * static_cast<double>(tb.y)) / area;
    const Vec3 along_v = (pc * static_cast<double>(tb.x) - pb * static_cast<double>(tc.x)) / area;
    BarFace face;
    face.middle = pa + pb * wb + pc * wc;
    face.outward = normalized(cross(pb, pc));
    face.up = normalized(along_v * -1.0);
    face.ladder = bars.ladder;
    face.length_m = bars.ladder ? length(along_v) * static_cast<double>(bars.v1 - bars.v0)
                                : length(along_u) * static_cast<double>(bars.u1 - bars.u0);
    return face;
  }
  return std::nullopt;
}

// The rotation whose matrix has these rows (orthonormal, right-handed).
inline Quaternion rotation_with_rows(Vec3 x, Vec3 y, Vec3 z) {
  const double w2 = std::max(0.0, 1 + x.x + y.y + z.z), x2 = std::max(0.0, 1 + x.x - y.y - z.z),
               y2 = std::max(0.0, 1 - x.x + y.y - z.z), z2 = std::max(0.0, 1 - x.x - y.y + z.z);
  Quaternion q{std::sqrt(w2) / 2, std::sqrt(x2) / 2, std::sqrt(y2) / 2, std::sqrt(z2) / 2};
  const double best = std::max({w2, x2, y2, z2});
  const double s = 2 * std::sqrt(best);
  if (best == w2)
    q = {s / 4, (z.y - y.z) / s, (x.z - z.x) / s, (y.x - x.y) / s};
  else if (best == x2)
    q = {(z.y - y.z) / s, s / 4, (x.y + y.x) / s, (x.z + z.x) / s};
  else if (best == y2)
    q = {(x.z - z.x) / s, (x.y + y.x) / s, s / 4, (y.z + z.y) / s};
  else
    q = {(y.x - x.y) / s, (x.z + z.x) / s, (y.z + z.y) / s, s / 4};
  return q;
}

}  // namespace bar_faces

// One product per place on a grid of hooks, each with a camera at arm's length.
struct BarStage {
  scene::Scene scene;
  std::vector<render::Camera> cameras;    // of scene.catalog
  std::vector<std::string> without_face;  // products whose bars are on no triangle
};

inline BarStage bar_stage(const std::vector<catalog::Product>& products) {
  constexpr double spacing_m = 1.0, hook_m = 1.4, wall_m = 1.5;
  constexpr int columns = 10;
  BarStage stage;
  scene::Scene& scene = stage.scene;
  const int rows = static_cast<int>(products.size()) / columns + 1;
  scene.layout.shell.width_mm = static_cast<int>((columns * spacing_m + 2 * wall_m) * 1000);
  scene.layout.shell.depth_mm = static_cast<int>((rows * spacing_m + 2 * wall_m) * 1000);
  scene.layout.shell.ceiling_mm = 3000;
  scene.layout.look.floor = scene.layout.look.wall = scene.layout.look.ceiling = "";
  scene.layout.look.light_lux = 1000;
  for (const catalog::Product& product : products) {
    const auto label = render::raytrace::library_label(product);
    const auto model = assets::make_product_model(product);
    const auto face = label.ok() && label->bars && model.ok()
                          ? bar_faces::face_at(*model, *label->bars)
                          : std::nullopt;
    if (!face) {
      stage.without_face.push_back(product.sku);
      continue;
    }
    const auto i = static_cast<int>(scene.products.size());
    const Vec3 hook{wall_m + (i % columns) * spacing_m, wall_m + i / columns * spacing_m, hook_m};
    // Outward becomes -Y (to the camera), up becomes +Z.
    const Vec3 inward = face->outward * -1.0;
    const Quaternion turn = bar_faces::rotation_with_rows(
        normalized(cross(inward, face->up)),
        inward,
        normalized(cross(normalized(cross(inward, face->up)), inward)));
    const Vec3 at = hook - rotate(turn, face->middle);
    scene::SceneProduct item;
    item.sku = static_cast<std::uint32_t>(scene.catalog.size());
    item.position_m = {
        static_cast<float>(at.x), static_cast<float>(at.y), static_cast<float>(at.z)};
    item.rotation_wxyz = {static_cast<float>(turn.w),
                          static_cast<float>(turn.x),
                          static_cast<float>(turn.y),
                          static_cast<float>(turn.z)};
    scene.catalog.push_back(product);
    scene.products.push_back(item);
    // The symbol fills about four fifths of the picture's longer or shorter side.
    constexpr double arm_m = 0.4;
    constexpr int long_px = 440, short_px = 330;
    const double high_m = face->ladder ? face->length_m * 1.35 : face->length_m * 1.0;
    render::Camera camera{product.sku, hook - Vec3{0, arm_m, 0}, hook};
    camera.fov_deg = 2 * std::atan(high_m / 2 / arm_m) * 180 / 3.14159265358979;
    camera.width = face->ladder ? short_px : long_px;
    camera.height = face->ladder ? long_px : short_px;
    stage.cameras.push_back(camera);
  }
  return stage;
}

// What zbarimg reads in each picture: code by file name; a picture that it cannot read is missing.
// A process for each: one that has read many misses codes that it reads by themselves.
inline std::map<std::string, std::string> scanned(const std::vector<std::filesystem::path>& files) {
  std::map<std::string, std::string> codes;
  for (const auto& file : files) {
    const std::string read =
        run({"zbarimg", "--quiet", "--raw", "-Sdisable", "-Sean13.enable", file.string()}).out;
    if (!read.empty()) codes[file.stem().string()] = read.substr(0, read.find('\n'));
  }
  return codes;
}

}  // namespace marketgen
