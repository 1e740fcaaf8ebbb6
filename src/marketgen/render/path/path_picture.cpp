#include "render/path/path_picture.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>
#include <utility>

#include "base/interrupt.h"
#include "base/parallel.h"
#include "io/program.h"
#include "render/path/denoise.h"
#include "render/path/lens.h"
#include "render/path/neural_denoise.h"
#include "render/tone.h"

namespace marketgen::render::raytrace {
namespace {

constexpr int eye_block = 4;       // pixels a side that share a packet of eye rays
constexpr int path_tile = 16;      // pixels a side that one thread works on
constexpr int paths_per_pass = 4;  // between looks at the clock
// Times white: pixels on a lamp's edge are a mean of what a screen shows, so that the edge is
// smooth.
constexpr float brightest_shown_of_white = 4;

struct TileRange {
  int x0, y0, x1, y1;
};

// Makes one picture: guides first, then pass after pass of paths.
class PathPicture {
 public:
  PathPicture(const PathScene& scene, const View& view, const PathSettings& settings)
      : scene_(scene),
        view_(view),
        settings_(settings),
        across_((view.width() + path_tile - 1) / path_tile),
        down_((view.height() + path_tile - 1) / path_tile),
        guides_(pixels()),
        sums_(pixels()) {
    parallel_for(tiles(), [&](std::size_t tile) { add_guides(range_of(tile)); });
  }

  std::size_t tiles() const {
    return static_cast<std::size_t>(across_) * static_cast<std::size_t>(down_);
  }
  const PictureGuides& guides() const { return guides_; }

  // Adds paths until there are `wanted` or, if time_s > 0, that many seconds have gone by.
  Result<void> run(int wanted, double time_s, Progress& progress) {
    const double start = monotonic_seconds();
    progress.begin("paths", tiles() * static_cast<std::size_t>(wanted));
    while (done_ < wanted && (done_ == 0 || time_s <= 0 || monotonic_seconds() - start < time_s)) {
      const int now = std::min(paths_per_pass, wanted - done_);
      parallel_for(tiles(), [&](std::size_t tile) {
        if (check_interrupt().ok()) add_paths(range_of(tile), done_, done_ + now);
        progress.advance(static_cast<std::size_t>(now));
      });
      MARKETGEN_CHECK(check_interrupt());
      done_ += now;
    }
    progress.end();
    return {};
  }

  PathFilm film() const { return {view_.width(), view_.height(), sums_, done_}; }

 private:
  std::size_t pixels() const {
    return static_cast<std::size_t>(view_.width()) * static_cast<std::size_t>(view_.height());
  }
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(view_.width()) +
           static_cast<std::size_t>(x);
  }
  TileRange range_of(std::size_t tile) const {
    const int x = static_cast<int>(tile) % across_ * path_tile,
              y = static_cast<int>(tile) / across_ * path_tile;
    return {x, y, std::min(x + path_tile, view_.width()), std::min(y + path_tile, view_.height())};
  }

  // Calls body(x, y, ray, hit) for every pixel of the range; ray_of(x, y) is its ray. Rays of a
  // block are traced together.
  template <class RayOf, class Body>
  void for_pixels(const TileRange& range,
                  unsigned mask,
                  const RayOf& ray_of,
                  const Body& body) const {
    std::array<Ray, packet_size> rays;
    std::array<Hit, packet_size> hits;
    for (int by = range.y0; by < range.y1; by += eye_block) {
      for (int bx = range.x0; bx < range.x1; bx += eye_block) {
        for (int k = 0; k < eye_block * eye_block;
             ++k) {  // past the picture's edge the last pixel repeats
          rays[static_cast<std::size_t>(k)] = ray_of(std::min(bx + k % eye_block, range.x1 - 1),
                                                     std::min(by + k / eye_block, range.y1 - 1));
        }
        trace(scene_.world, rays, hits, mask, RayBundle::coherent);
        for (int k = 0; k < eye_block * eye_block; ++k) {
          const int x = bx + k % eye_block, y = by + k / eye_block;
          const auto lane = static_cast<std::size_t>(k);
          if (x < range.x1 && y < range.y1) body(x, y, rays[lane], hits[lane]);
        }
      }
    }
  }

  void add_guides(const TileRange& range) {
    const auto middle = [&](int x, int y) {
      return view_.ray(static_cast<float>(x) + 0.5F, static_cast<float>(y) + 0.5F);
    };
    for_pixels(range, settings_.mask, middle, [&](int x, int y, const Ray& ray, const Hit& hit) {
      const std::size_t i = index(x, y);
      if (!hit.any()) {
        // Near, so that the filter takes neighbours for one surface: panes mirror the shop there.
        guides_.position.set(i, ray.origin + ray.direction * 4);
        guides_.normal.set(i, -ray.direction);
        return;
      }
      const Surface s = surface_at(scene_.world, ray, hit, view_.footprint(hit.t));
      guides_.position.set(i, s.position);
      guides_.normal.set(i, s.normal);
      guides_.depth_m[i] = view_.depth_of(ray, s.distance);
      guides_.roughness[i] = s.roughness;
      guides_.instance[i] = s.id;
    });
  }

  void add_paths(const TileRange& range, int first, int last) {
    for (int number = first; number < last; ++number) {
      const auto start_of = [&](int x, int y) {
        return PathStart{x, y, static_cast<std::uint32_t>(number)};
      };
      for_pixels(
          range,
          settings_.mask | mask_glass,
          [&](int x, int y) { return eye_ray(view_, start_of(x, y)); },
          [&](int x, int y, const Ray& ray, const Hit& hit) {
            sums_[index(x, y)].add(trace_path(scene_, view_, settings_, start_of(x, y), ray, hit));
          });
    }
  }

  const PathScene& scene_;
  const View& view_;
  const PathSettings& settings_;
  int across_, down_, done_ = 0;
  PictureGuides guides_;
  std::vector<PathSums> sums_;
};

ColorPlanes radiance_of(const PathFilm& film) {
  ColorPlanes radiance(film.count());
  for (std::size_t i = 0; i < film.count(); ++i)
    radiance.set(i, film.radiance(i));
  return radiance;
}

// The neural denoiser's library where that is the one to use; asked for before hours of work.
Result<std::optional<std::filesystem::path>> library_for(Denoiser denoiser) {
  if (denoiser == Denoiser::own || denoiser == Denoiser::none)
    return std::optional<std::filesystem::path>();
  std::optional<std::filesystem::path> library = neural_denoiser_library();
  if (library || denoiser == Denoiser::automatic) return library;
  return Error{"usage.unavailable",
               "--denoise neural",
               "no Open Image Denoise here; run: " + io::worker_python() +
                   " -m pip install pyoidn; or name libOpenImageDenoise.so.2 in MARKETGEN_OIDN, or "
                   "take --denoise own"};
}

// The film's radiance, its noise taken out by the library if there is one, or as asked for.
Result<ColorPlanes> without_noise(PathFilm& film,
                                  const PictureGuides& guides,
                                  Denoiser denoiser,
                                  const std::optional<std::filesystem::path>& library,
                                  float exposure) {
  if (library) return neural_denoise(*library, film, guides, exposure);
  if (denoiser != Denoiser::none) denoise(film, guides);
  return radiance_of(film);
}

// What arrives on the film behind the lens.
ColorPlanes through_lens(ColorPlanes radiance, const ColorPlanes& beyond, const View& view) {
  for (std::size_t i = 0; i < radiance.axis[0].size(); ++i)
    radiance.set(i, radiance.at(i) - beyond.at(i));
  ColorPlanes light = with_glare(std::move(radiance), beyond, view.width());
  const auto across = static_cast<std::size_t>(view.width());
  for (std::size_t i = 0; i < light.axis[0].size(); ++i) {
    const Ray ray =
        view.ray(static_cast<float>(i % across) + 0.5F, static_cast<float>(i / across) + 0.5F);
    light.set(i, light.at(i) * arriving_share(view.depth_of(ray, 1)));
  }
  return light;
}

// The colour of a frame, exposed and tone mapped, and its radiance.
Frame frame_of(const ColorPlanes& radiance,
               const ColorPlanes& beyond,
               const View& view,
               Vec3f exposure) {
  Frame frame;
  frame.color = Image(view.width(), view.height());
  const std::size_t count = radiance.axis[0].size();
  frame.radiance.resize(3 * count);
  const ColorPlanes arriving = through_lens(radiance, beyond, view);
  parallel_for(
      count,
      [&](std::size_t i) {
        const Vec3f light = radiance.at(i);
        const Rgb8 color = display_color(arriving.at(i) * exposure);
        const std::array<std::uint8_t, 3> bytes{color.r, color.g, color.b};
        const std::array<float, 3> parts{light.x, light.y, light.z};
        for (std::size_t k = 0; k < 3; ++k) {
          frame.color.pixels[3 * i + k] = bytes[k];
          frame.radiance[3 * i + k] = parts[k];
        }
      },
      4096);
  return frame;
}

}  // namespace

PathEffort path_effort(Quality quality) {
  switch (quality) {
    case Quality::fast:
      return {16, true};
    case Quality::balanced:
      return {24, true};
    case Quality::best:
      return {256, false};
  }
  return {};
}

Result<Frame> path_picture(const PathScene& scene,
                           const View& view,
                           const RenderOptions& options,
                           Progress& progress) {
  const PathEffort effort = path_effort(options.quality);
  const float exposure =
      scene.world.exposure * std::exp2(static_cast<float>(options.exposure_stops));
  const PathSettings settings{options.hide_ceiling ? mask_solid : mask_opaque,
                              effort.end_in_stored_light,
                              brightest_shown_of_white / exposure};
  MARKETGEN_TRY(const auto library, library_for(options.denoiser));
  PathPicture picture(scene, view, settings);
  MARKETGEN_CHECK(
      picture.run(options.samples > 0 ? options.samples : effort.paths, options.time_s, progress));
  PathFilm film = picture.film();
  MARKETGEN_TRY(const ColorPlanes radiance,
                without_noise(film, picture.guides(), options.denoiser, library, exposure));
  MARKETGEN_CHECK(check_interrupt());
  return frame_of(radiance, film.beyond, view, options.light * exposure);
}

}  // namespace marketgen::render::raytrace
