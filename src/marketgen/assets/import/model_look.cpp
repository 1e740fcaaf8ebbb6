#include "assets/import/model_look.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <unordered_map>

#include <fmt/format.h>

#include "geometry/srgb.h"
#include "geometry/weld.h"

namespace marketgen::assets {
namespace {

constexpr std::size_t max_colors = 6;
constexpr double min_share = 0.01;             // of the surface, for a colour to be named
constexpr int cell = 32;                       // sRGB steps that count as one colour
constexpr std::int64_t max_samples = 1 << 16;  // pixels looked at in a picture
constexpr double weld_m = 1e-6;
constexpr std::size_t max_in_a_spot = 2000;  // vertices within 16 micrometres: welding is quadratic

std::uint8_t encoded(float linear) {
  const double c = std::clamp<double>(linear, 0, 1);
  return static_cast<std::uint8_t>(std::lround(255 * srgb_encoded(c)));
}

// Colours gathered in cells of the sRGB cube, each with its mean.
class ColorCount {
 public:
  void add(std::array<double, 3> srgb, double weight) {
    const auto at = [](double v) { return static_cast<int>(v) / cell; };
    Sum& sum = cells_[{at(srgb[0]), at(srgb[1]), at(srgb[2])}];
    for (std::size_t c = 0; c < 3; ++c)
      sum.color[c] += srgb[c] * weight;
    sum.weight += weight;
  }

  std::vector<catalog::ColorShare> shares() const {
    std::vector<Sum> sums;
    double all = 0;
    for (const auto& [_, sum] : cells_) {
      sums.push_back(sum);
      all += sum.weight;
    }
    std::stable_sort(
        sums.begin(), sums.end(), [](const Sum& a, const Sum& b) { return a.weight > b.weight; });
    std::vector<catalog::ColorShare> list;
    for (const Sum& sum : sums) {
      if (list.size() >= max_colors || sum.weight < min_share * all) break;
      const auto part = [&](std::size_t c) { return std::lround(sum.color[c] / sum.weight); };
      list.push_back({fmt::format("#{:02x}{:02x}{:02x}", part(0), part(1), part(2)),
                      std::round(1000 * sum.weight / all) / 1000});
    }
    return list;
  }

 private:
  struct Sum {
    std::array<double, 3> color{};
    double weight = 0;
  };
  std::map<std::tuple<int, int, int>, Sum> cells_;
};

// The picture's pixels, weighing `area` together.
void add_picture(ColorCount& colors, const Image& picture, double area) {
  const std::int64_t pixels = std::int64_t{picture.width} * picture.height;
  const std::int64_t step = std::max<std::int64_t>(1, pixels / max_samples);
  const double weight = area / static_cast<double>((pixels + step - 1) / step);
  for (std::int64_t i = 0; i < pixels; i += step) {
    const std::uint8_t* p =
        picture.at(static_cast<int>(i % picture.width), static_cast<int>(i / picture.width));
    colors.add({double(p[0]), double(p[1]), double(p[2])}, weight);
  }
}

Result<void> check_crowding(const Mesh& mesh, const std::string& where) {
  std::map<std::tuple<std::int64_t, std::int64_t, std::int64_t>, std::size_t> spots;
  const auto at = [](float v) { return static_cast<std::int64_t>(std::floor(v / (16 * weld_m))); };
  for (const Vec3f& p : mesh.positions) {
    if (++spots[{at(p.x), at(p.y), at(p.z)}] > max_in_a_spot)
      return Error{"model.bad_file",
                   where,
                   "thousands of its vertices lie within 0.02 mm; merge them and export it again"};
  }
  return {};
}

}  // namespace

catalog::AssetLook look_of(const io::OutsideModel& model) {
  std::vector<double> areas(model.materials.size());
  const Mesh& mesh = model.mesh;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto [a, b, c] = mesh.triangles[t];
    const Vec3 p = to_double(mesh.positions[a]);
    areas[mesh.surfaces[t]] +=
        0.5 * length(cross(to_double(mesh.positions[b]) - p, to_double(mesh.positions[c]) - p));
  }
  catalog::AssetLook look;
  ColorCount colors;
  double all = 0;
  for (std::size_t i = 0; i < areas.size(); ++i) {
    const io::ModelMaterial& m = model.materials[i];
    if (areas[i] <= 0) continue;
    all += areas[i];
    look.roughness += areas[i] * m.roughness;
    look.metallic += areas[i] * m.metallic;
    look.clear += m.clear ? areas[i] : 0;
    if (m.picture >= 0)
      add_picture(colors, model.pictures[static_cast<std::size_t>(m.picture)], areas[i]);
    else
      colors.add(
          {double(encoded(m.color.x)), double(encoded(m.color.y)), double(encoded(m.color.z))},
          areas[i]);
  }
  for (double* mean : {&look.roughness, &look.metallic, &look.clear})
    *mean = all > 0 ? std::round(1000 * *mean / all) / 1000 : 0;
  look.colors = colors.shares();
  return look;
}

catalog::AssetLook look_of(const std::vector<Image>& pictures) {
  ColorCount colors;
  for (const Image& picture : pictures)
    add_picture(colors, picture, 1);
  catalog::AssetLook look;
  look.colors = colors.shares();
  return look;
}

Result<int> open_edges_of(const Mesh& mesh, const std::string& where) {
  MARKETGEN_CHECK(check_crowding(mesh, where));
  const std::vector<std::uint32_t> welded = weld_positions(mesh.positions, weld_m);
  std::unordered_map<std::uint64_t, std::array<int, 2>> edges;  // forwards, backwards
  for (const auto& triangle : mesh.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t a = welded[triangle[i]], b = welded[triangle[(i + 1) % 3]];
      if (a == b) continue;  // a triangle thinner than the weld has no such edge
      const std::uint64_t key = (std::uint64_t{std::min(a, b)} << 32) | std::max(a, b);
      ++edges[key][a < b ? 0 : 1];
    }
  }
  int open = 0;
  for (const auto& [_, uses] : edges)
    open += uses[0] == 1 && uses[1] == 1 ? 0 : 1;
  return open;
}

}  // namespace marketgen::assets
