#include "perception/product_look.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <unordered_set>
#include <utility>

namespace marketgen::perception {
namespace {

constexpr float cell_m = 0.004F, around_m = 0.03F;  // of the table of nearest surfels
constexpr std::size_t max_surfels = 30000;
constexpr float farther_apart = 1.25F;  // the pieces of what has more surface than that
constexpr float min_picture_facing =
    0.25F;  // surface seen more aslant than this is left to other sides

// A picture's surface in the product's frame.
class PictureSurface {
 public:
  explicit PictureSurface(const agent::ProductPicture& picture) : picture_(picture) {
    const Quaternion& q = picture.product_from_camera.rotation;
    right_ = to_float(rotate(q, {1, 0, 0}));
    down_ = to_float(rotate(q, {0, 1, 0}));
    ahead_ = to_float(rotate(q, {0, 0, 1}));
  }

  void add_to(std::vector<Surfel>& surfels, float spacing_m) const {
    const int step = std::max(1, static_cast<int>(spacing_m / picture_.pixel_m));
    for (int y = step; y + step < picture_.color.height; y += step) {
      for (int x = step; x + step < picture_.color.width; x += step) {
        if (!all_there(x, y)) continue;
        const Vec3f across = point(x + 1, y) - point(x - 1, y);
        const Vec3f along = point(x, y + 1) - point(x, y - 1);
        const Vec3f normal = normalized(cross(along, across));
        if (dot(normal, ahead_) > -min_picture_facing) continue;
        surfels.push_back({point(x, y), normal, color(x, y, step), is_clear(x, y)});
      }
    }
  }

 private:
  float depth(int x, int y) const {
    return picture_.depth_m[static_cast<std::size_t>(y * picture_.color.width + x)];
  }
  bool all_there(int x, int y) const {
    return depth(x, y) > 0 && depth(x - 1, y) > 0 && depth(x + 1, y) > 0 && depth(x, y - 1) > 0 &&
           depth(x, y + 1) > 0;
  }
  Vec3f point(int x, int y) const {
    const auto side = static_cast<float>(picture_.pixel_m);
    const float across =
        (static_cast<float>(x) - 0.5F * static_cast<float>(picture_.color.width - 1)) * side;
    const float along =
        (static_cast<float>(y) - 0.5F * static_cast<float>(picture_.color.height - 1)) * side;
    return to_float(picture_.product_from_camera.position) + right_ * across + down_ * along +
           ahead_ * depth(x, y);
  }
  bool is_clear(int x, int y) const {
    return !picture_.clear.empty() &&
           picture_.clear[static_cast<std::size_t>(y * picture_.color.width + x)] != 0;
  }
  // Mean over what the surfel stands for.
  Vec3f color(int x, int y, int step) const {
    Vec3f sum;
    float count = 0;
    for (int v = y - step / 2; v <= y + step / 2; ++v) {
      for (int u = x - step / 2; u <= x + step / 2; ++u) {
        if (!(depth(u, v) > 0)) continue;
        const std::uint8_t* rgb = picture_.color.at(u, v);
        sum += Vec3f{
            static_cast<float>(rgb[0]), static_cast<float>(rgb[1]), static_cast<float>(rgb[2])};
        ++count;
      }
    }
    return sum / (255 * std::max(1.0F, count));
  }

  const agent::ProductPicture& picture_;
  Vec3f right_, down_, ahead_;
};

// One of those that share a cell and a side: the first.
std::vector<Surfel> thinned(const std::vector<Surfel>& surfels, float spacing_m) {
  std::vector<Surfel> kept;
  std::unordered_set<std::uint64_t> taken;
  for (const Surfel& surfel : surfels) {
    const auto cell = [&](float v) {
      return static_cast<std::uint64_t>(std::lround(v / spacing_m) + 4096) & 0x3fff;
    };
    const Vec3f n = surfel.normal;
    const Vec3f size{std::abs(n.x), std::abs(n.y), std::abs(n.z)};
    const int axis = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
    const float sign = axis == 0 ? n.x : axis == 1 ? n.y : n.z;
    const auto side = static_cast<std::uint64_t>(2 * axis + (sign > 0 ? 1 : 0));
    const std::uint64_t key =
        (((cell(surfel.point.x) << 14 | cell(surfel.point.y)) << 14) | cell(surfel.point.z)) << 3 |
        side;
    if (taken.insert(key).second) kept.push_back(surfel);
  }
  return kept;
}

constexpr float points_per_m = 20000, normals_per_unit = 32767, colors_per_unit = 255;

std::int16_t rounded(float value) {
  return static_cast<std::int16_t>(std::lround(std::clamp(value, -32767.0F, 32767.0F)));
}

PackedSurfel packed_surfel(const Surfel& surfel) {
  const auto rows = [](Vec3f v, float scale) {
    return std::array{rounded(v.x * scale), rounded(v.y * scale), rounded(v.z * scale)};
  };
  const auto channel = [](float share) {
    return static_cast<std::uint8_t>(std::lround(std::clamp(share, 0.0F, 1.0F) * colors_per_unit));
  };
  return {rows(surfel.point, points_per_m),
          rows(surfel.normal, normals_per_unit),
          {channel(surfel.color.x), channel(surfel.color.y), channel(surfel.color.z)},
          static_cast<std::uint8_t>(surfel.clear ? 1 : 0)};
}

Vec3f vector_of(const auto& numbers) {
  return {static_cast<float>(numbers[0]),
          static_cast<float>(numbers[1]),
          static_cast<float>(numbers[2])};
}

}  // namespace

Surfel unpacked(const PackedSurfel& packed) {
  return {vector_of(packed.point) / points_per_m,
          vector_of(packed.normal) / normals_per_unit,  // made unit again it would pack to others
          vector_of(packed.color) / colors_per_unit,
          packed.clear != 0};
}

std::vector<PackedSurfel> ProductLook::packed() const {
  std::vector<PackedSurfel> all;
  std::ranges::transform(surfels_, std::back_inserter(all), packed_surfel);
  return all;
}

ProductLook ProductLook::of(const std::string& sku, std::vector<PackedSurfel> surfels) {
  ProductLook look;
  look.sku_ = sku;
  std::ranges::transform(surfels, std::back_inserter(look.surfels_), unpacked);
  look.low_ = look.high_ = look.surfels_.front().point;
  for (const Surfel& s : look.surfels_) {
    const Vec3f p = s.point;
    look.low_ = {
        std::min(look.low_.x, p.x), std::min(look.low_.y, p.y), std::min(look.low_.z, p.z)};
    look.high_ = {
        std::max(look.high_.x, p.x), std::max(look.high_.y, p.y), std::max(look.high_.z, p.z)};
  }
  return look;
}

Result<ProductLook> ProductLook::make(const std::string& sku,
                                      const agent::ProductPictures& pictures,
                                      float spacing_m) {
  std::vector<Surfel> all;
  for (const agent::ProductPicture& picture : pictures)
    PictureSurface(picture).add_to(all, spacing_m);
  if (all.empty())
    return Error{"perception.no_picture",
                 sku,
                 "its pictures show nothing of it: expected some sides of the product with depth"};
  std::vector<Surfel> kept = thinned(all, spacing_m);
  for (float apart_m = spacing_m; kept.size() > max_surfels;) {
    apart_m *= farther_apart;
    kept = thinned(all, apart_m);
  }
  std::vector<PackedSurfel> packed;
  std::ranges::transform(kept, std::back_inserter(packed), packed_surfel);
  return of(sku, std::move(packed));
}

void ProductLook::make_table() const {
  auto& [made, origin, cells, nearest] = *table_;
  const Vec3f margin{around_m, around_m, around_m};
  origin = low_ - margin;
  const Vec3f size = high_ + margin - origin;
  cells = {static_cast<int>(size.x / cell_m) + 1,
           static_cast<int>(size.y / cell_m) + 1,
           static_cast<int>(size.z / cell_m) + 1};
  nearest.assign(static_cast<std::size_t>(cells[0]) * static_cast<std::size_t>(cells[1]) *
                     static_cast<std::size_t>(cells[2]),
                 -1);
  for (std::size_t i = 0; i < surfels_.size(); ++i) {
    const Vec3f off = (surfels_[i].point - origin) / cell_m;
    const int cell = (static_cast<int>(off.z) * cells[1] + static_cast<int>(off.y)) * cells[0] +
                     static_cast<int>(off.x);
    nearest[static_cast<std::size_t>(cell)] = static_cast<std::int16_t>(i);
  }
  // Each cell takes the best of its neighbours', forth and back, twice.
  for (int i = 0; i < 2; ++i) {
    spread(true);
    spread(false);
  }
}

void ProductLook::spread(bool forwards) const {
  auto& [made, origin, cells, nearest] = *table_;
  const int sign = forwards ? 1 : -1;
  const int last_x = cells[0] - 1, last_y = cells[1] - 1, last_z = cells[2] - 1;
  const auto at = [&](int x, int y, int z) -> std::int16_t& {
    return nearest[static_cast<std::size_t>((z * cells[1] + y) * cells[0] + x)];
  };
  const auto inside = [&](int x, int y, int z) {
    return x >= 0 && y >= 0 && z >= 0 && x <= last_x && y <= last_y && z <= last_z;
  };
  const auto visit = [&](int x, int y, int z) {
    const Vec3f middle = origin + Vec3f{static_cast<float>(x) + 0.5F,
                                        static_cast<float>(y) + 0.5F,
                                        static_cast<float>(z) + 0.5F} *
                                      cell_m;
    const auto off = [&](std::int16_t i) {
      const Vec3f d = surfels_[static_cast<std::size_t>(i)].point - middle;
      return dot(d, d);
    };
    std::int16_t& best = at(x, y, z);
    for (const auto& [dx, dy, dz] : {std::array{1, 0, 0},
                                     {0, 1, 0},
                                     {0, 0, 1},
                                     {1, 1, 0},
                                     {-1, 1, 0},
                                     {1, 0, 1},
                                     {0, 1, 1},
                                     {-1, 0, 1},
                                     {0, -1, 1}}) {
      const int u = x - sign * dx, v = y - sign * dy, w = z - sign * dz;
      if (!inside(u, v, w)) continue;
      const std::int16_t other = at(u, v, w);
      if (other >= 0 && (best < 0 || off(other) < off(best))) best = other;
    }
  };
  for (int c = 0; c <= last_z; ++c)
    for (int b = 0; b <= last_y; ++b)
      for (int a = 0; a <= last_x; ++a)
        visit(forwards ? a : last_x - a, forwards ? b : last_y - b, forwards ? c : last_z - c);
}

int ProductLook::nearest(Vec3f product_point) const {
  std::call_once(table_->made, [this] { make_table(); });
  const auto& [made, origin, cells, nearest] = *table_;
  const Vec3f off = (product_point - origin) / cell_m;
  const int x = static_cast<int>(std::floor(off.x)), y = static_cast<int>(std::floor(off.y)),
            z = static_cast<int>(std::floor(off.z));
  if (x < 0 || y < 0 || z < 0 || x >= cells[0] || y >= cells[1] || z >= cells[2]) return -1;
  return nearest[static_cast<std::size_t>((z * cells[1] + y) * cells[0] + x)];
}

}  // namespace marketgen::perception
