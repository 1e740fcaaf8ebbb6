#include "render/material_picture.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "assets/materials/material_texture.h"
#include "render/picture_grid.h"
#include "render/stage/exhibit.h"

namespace marketgen::render {
namespace {

constexpr int booth_mm = 4000, ceiling_mm = 3000;
constexpr float middle_m = booth_mm * 0.5e-3F;
constexpr float table_m = 0.9F;  // height at which things are shown
constexpr float ball_radius_m = 0.12F;
constexpr float slab_m = 0.26F, slab_thickness_m = 0.018F;
// Repeats of a texture across what is shown, at least; fine materials show as many as there are.
constexpr float min_repeats = 0.9F;
constexpr double material_fov_deg = 22;

scene::Scene stage_for(const catalog::MaterialRow& material) {
  scene::Scene scene;
  scene.layout.shell.width_mm = scene.layout.shell.depth_mm = booth_mm;
  scene.layout.shell.ceiling_mm = ceiling_mm;
  scene.layout.look.floor = scene.layout.look.wall = scene.layout.look.ceiling = "";
  scene.layout.look.accent = "#c8c8c4";  // no coloured band in what mirrors show
  scene.layout.look.light_lux = 1000;
  scene.materials.push_back(material);
  return scene;
}

bool grows(const catalog::MaterialRow& material) {
  return std::ranges::find(material.uses, "produce") != material.uses.end();
}

// Metres of the shape that one repeat covers. Fruit is shown larger than it is.
float repeat_m(const catalog::MaterialRow& material, float shown_m) {
  const float coarsest = shown_m / min_repeats;
  if (grows(material)) return coarsest;
  return std::min(static_cast<float>(assets::material_extent_m(material)), coarsest);
}

// Longitude runs along u, latitude along v, both true to scale at the equator.
Mesh ball(bool poles_upright, float repeat) {
  constexpr int around = 96, down = 48;
  constexpr float pi = std::numbers::pi_v<float>;
  Mesh mesh;
  const Vec3f centre{middle_m, middle_m, table_m + ball_radius_m};
  for (int j = 0; j <= down; ++j) {
    const float latitude = pi * (static_cast<float>(j) / down - 0.5F);
    for (int i = 0; i <= around; ++i) {
      const float longitude = 2 * pi * static_cast<float>(i) / around;
      const float x = std::cos(latitude) * std::cos(longitude);
      const float y = std::cos(latitude) * std::sin(longitude);
      const float z = std::sin(latitude);
      // Level poles hide at the sides of the picture.
      const Vec3f normal = poles_upright ? Vec3f{x, y, z} : Vec3f{z, x, y};
      const Vec2f uv = poles_upright ? Vec2f{longitude, -latitude} : Vec2f{latitude, -longitude};
      mesh.add_vertex(centre + normal * ball_radius_m, normal, uv * (ball_radius_m / repeat));
    }
  }
  for (int j = 0; j < down; ++j) {
    for (int i = 0; i < around; ++i) {
      const auto a = static_cast<std::uint32_t>(j * (around + 1) + i);
      const auto c = a + static_cast<std::uint32_t>(around) + 1;
      mesh.add_triangle(a, a + 1, c + 1, 0);
      mesh.add_triangle(a, c + 1, c, 0);
    }
  }
  return mesh;
}

// A square slab that leans back and is turned a little aside.
Mesh slab(float repeat) {
  Mesh mesh;
  const Vec3f half{slab_m / 2, slab_thickness_m / 2, slab_m / 2};
  add_box(mesh, -half, half, 0.0015F, 0, 1 / repeat);
  const Pose lean{{middle_m, middle_m, table_m + slab_m * 0.46F},
                  rotation_about({0, 0, 1}, 0.42) * rotation_about({1, 0, 0}, -0.38)};
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    mesh.positions[v] = to_float(lean * to_double(mesh.positions[v]));
    mesh.normals[v] = to_float(rotate(lean.rotation, to_double(mesh.normals[v])));
  }
  return mesh;
}

Mesh table() {
  Mesh mesh;
  add_box(mesh,
          {middle_m - 0.8F, middle_m - 0.8F, table_m - 0.04F},
          {middle_m + 0.8F, middle_m + 0.8F, table_m},
          0.004F,
          0,
          1);
  return mesh;
}

bool is_laid(const catalog::MaterialRow& material) {
  return std::ranges::any_of(material.uses, [](const std::string& use) {
    return use == "floor" || use == "wall" || use == "ceiling";
  });
}

std::vector<raytrace::Exhibit> exhibits_for(const catalog::MaterialRow& material) {
  // No row is called "", so the table is plain white.
  std::vector<raytrace::Exhibit> exhibits{{table(), ""}};
  if (is_laid(material))
    exhibits.push_back({slab(repeat_m(material, slab_m)), material.id});
  else
    exhibits.push_back({ball(grows(material), repeat_m(material, 2 * ball_radius_m)), material.id});
  return exhibits;
}

Camera camera_for(int size_px) {
  const Vec3 at{double{middle_m}, double{middle_m}, double{table_m + ball_radius_m} - 0.005};
  const Vec3 back = normalized(Vec3{0.12, -1.0, 0.30});
  return {"material", at + back * 0.86, at, material_fov_deg, 0, size_px, size_px};
}

}  // namespace

Result<Image> draw_material_picture(const catalog::MaterialRow& material, int size_px) {
  const scene::Scene scene = stage_for(material);
  MARKETGEN_TRY(const std::unique_ptr<Renderer> renderer,
                raytrace::create_renderer(scene, exhibits_for(material), silent_progress()));
  RenderOptions options;
  options.quality = Quality::best;
  MARKETGEN_TRY(Frame frame, renderer->render(camera_for(size_px), options));
  return std::move(frame.color);
}

Result<Image> draw_material_sheet(const std::vector<catalog::MaterialRow>& materials,
                                  int size_px,
                                  Progress& progress) {
  progress.begin("materials", materials.size());
  MARKETGEN_TRY(Image sheet, picture_grid(materials.size(), size_px, [&](std::size_t i) {
                  progress.advance();
                  return draw_material_picture(materials[i], size_px);
                }));
  progress.end();
  return sheet;
}

}  // namespace marketgen::render
