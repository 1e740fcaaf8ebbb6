#include "render/path/neural_denoise.h"

#include <dlfcn.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <system_error>
#include <utility>

#include "base/parallel.h"
#include "io/installation.h"

namespace marketgen::render::raytrace {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view library_name = "libOpenImageDenoise.so.2";
// Of oidn.h, version 2.
constexpr int cpu_device = 1, float3_format = 3;

using Handle = void*;

struct LibraryCloser {
  void operator()(void* library) const { dlclose(library); }
};

// The functions of the library that are used; oidn.h, version 2.
struct OidnApi {
  std::unique_ptr<void, LibraryCloser> library;
  Handle (*new_device)(int) = nullptr;
  void (*set_device_int)(Handle, const char*, int) = nullptr;
  void (*commit_device)(Handle) = nullptr;
  void (*release_device)(Handle) = nullptr;
  int (*device_error)(Handle, const char**) = nullptr;
  Handle (*new_filter)(Handle, const char*) = nullptr;
  void (*set_image)(Handle,
                    const char*,
                    void*,
                    int,
                    std::size_t,
                    std::size_t,
                    std::size_t,
                    std::size_t,
                    std::size_t) = nullptr;
  void (*set_filter_bool)(Handle, const char*, bool) = nullptr;
  void (*commit_filter)(Handle) = nullptr;
  void (*execute_filter)(Handle) = nullptr;
  void (*release_filter)(Handle) = nullptr;
};

Error denoiser_error(const fs::path& library, const std::string& what) {
  return Error{"usage.unavailable",
               library.string(),
               fmt::format("the neural denoiser cannot be used: {}; take --denoise own", what)};
}

template <class Function>
bool bind(void* library, const char* name, Function& function) {
  function = reinterpret_cast<Function>(dlsym(library, name));
  return function != nullptr;
}

Result<OidnApi> load(const fs::path& path) {
  OidnApi api;
  api.library.reset(dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL));
  if (!api.library) return denoiser_error(path, dlerror());
  void* const from = api.library.get();
  const bool complete = bind(from, "oidnNewDevice", api.new_device) &&
                        bind(from, "oidnSetDeviceInt", api.set_device_int) &&
                        bind(from, "oidnCommitDevice", api.commit_device) &&
                        bind(from, "oidnReleaseDevice", api.release_device) &&
                        bind(from, "oidnGetDeviceError", api.device_error) &&
                        bind(from, "oidnNewFilter", api.new_filter) &&
                        bind(from, "oidnSetSharedFilterImage", api.set_image) &&
                        bind(from, "oidnSetFilterBool", api.set_filter_bool) &&
                        bind(from, "oidnCommitFilter", api.commit_filter) &&
                        bind(from, "oidnExecuteFilter", api.execute_filter) &&
                        bind(from, "oidnReleaseFilter", api.release_filter);
  if (!complete) return denoiser_error(path, "it is not Open Image Denoise 2");
  return api;
}

// Three floats a pixel, as the library reads them.
std::vector<float> packed_pixels(std::size_t count, const auto& value) {
  std::vector<float> pixels(3 * count);
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3f v = value(i);
    pixels[3 * i] = v.x;
    pixels[3 * i + 1] = v.y;
    pixels[3 * i + 2] = v.z;
  }
  return pixels;
}

struct OidnImages {
  std::vector<float> color, albedo, normal, output;
};

// `light` of the film, exposed.
OidnImages images_of(const PathFilm& film,
                     const PictureGuides& guides,
                     const ColorPlanes& light,
                     float exposure) {
  const auto share = [](float x) { return std::clamp(x, 0.0F, 1.0F); };
  return {packed_pixels(film.count(), [&](std::size_t i) { return light.at(i) * exposure; }),
          packed_pixels(film.count(),
                        [&](std::size_t i) {
                          const Vec3f paint = film.paint.at(i);
                          return Vec3f{share(paint.x), share(paint.y), share(paint.z)};
                        }),
          packed_pixels(film.count(), [&](std::size_t i) { return guides.normal.at(i); }),
          std::vector<float>(3 * film.count())};
}

// Runs the network; the error, or nothing.
std::optional<std::string> run_filter(const OidnApi& api,
                                      const PathFilm& film,
                                      OidnImages& images) {
  Handle device = api.new_device(cpu_device);
  if (device == nullptr) return "it has no device for this processor";
  api.set_device_int(device, "numThreads", thread_count());
  api.commit_device(device);
  Handle filter = api.new_filter(device, "RT");
  const std::pair<const char*, std::vector<float>*> planes[] = {{"color", &images.color},
                                                                {"albedo", &images.albedo},
                                                                {"normal", &images.normal},
                                                                {"output", &images.output}};
  if (filter != nullptr) {
    for (const auto& [name, plane] : planes) {
      api.set_image(filter,
                    name,
                    plane->data(),
                    float3_format,
                    static_cast<std::size_t>(film.width),
                    static_cast<std::size_t>(film.height),
                    0,
                    0,
                    0);
    }
    api.set_filter_bool(filter, "hdr", true);
    api.commit_filter(filter);
    api.execute_filter(filter);
  }
  const char* message = nullptr;
  std::optional<std::string> failed;
  if (api.device_error(device, &message) != 0) failed = message == nullptr ? "it failed" : message;
  if (filter != nullptr) api.release_filter(filter);
  api.release_device(device);
  return failed;
}

}  // namespace

std::optional<fs::path> neural_denoiser_library() {
  std::error_code ignored;
  if (const char* named = std::getenv("MARKETGEN_OIDN")) {
    if (*named == '\0') return std::nullopt;
    return fs::path(named);
  }
  for (const fs::path& packages : io::site_packages()) {
    const fs::path library = packages / "pyoidn/oidn/lib" / library_name;
    if (fs::exists(library, ignored)) return library;
  }
  return std::nullopt;
}

Result<ColorPlanes> neural_denoise(const fs::path& library,
                                   const PathFilm& film,
                                   const PictureGuides& guides,
                                   float exposure) {
  MARKETGEN_TRY(const OidnApi api, load(library));
  std::array<OidnImages, 2> layers{images_of(film, guides, film.irradiance, exposure),
                                   images_of(film, guides, film.gloss, exposure)};
  for (OidnImages& layer : layers) {
    if (const auto failed = run_filter(api, film, layer)) return denoiser_error(library, *failed);
  }
  const auto smooth = [&](std::size_t layer, std::size_t i) {
    const std::vector<float>& light = layers[layer].output;
    return Vec3f{light[3 * i], light[3 * i + 1], light[3 * i + 2]} / exposure;
  };
  ColorPlanes radiance(film.count());
  for (std::size_t i = 0; i < film.count(); ++i)
    radiance.set(i, film.albedo.at(i) * smooth(0, i) + smooth(1, i) + film.glow.at(i));
  return radiance;
}

}  // namespace marketgen::render::raytrace
