#include "render/path.h"

#include <algorithm>
#include <cmath>

#include "render/shading_math.h"

namespace marketgen::raytrace {
namespace {

constexpr int most_bounces = 12, most_panes = 8;
constexpr int roulette_from = 3;  // bounces before paths may end by chance
constexpr float brightest_indirect =
    20;  // in units of white; caps fireflies, direct light is never capped
constexpr float pane_step_m = 1.5e-3F, path_light_end_m = 5e-3F;
constexpr float path_bounce_footprint =
    0.05F;  // metres per metre: textures are read blurred after the first hit
constexpr float least_alpha = 3e-3F;

// Uniform numbers of one path (PCG-XSH-RR, O'Neill 2014).
class PathNumbers {
 public:
  PathNumbers(std::uint32_t pixel, std::uint32_t number)
      : state_((std::uint64_t{hashed(pixel)} << 32 | hashed(number ^ 0x5bd1e995U)) + pixel) {
    next();
  }
  float next() {
    state_ = state_ * 6364136223846793005ULL + 1442695040888963407ULL;
    const auto mixed = static_cast<std::uint32_t>(((state_ >> 18U) ^ state_) >> 27U);
    return unit_float(std::rotr(mixed, static_cast<int>(state_ >> 59U)));
  }

 private:
  std::uint64_t state_;
};

// How a surface scatters: diffuse below a GGX coat, or metal.
class Scattering {
 public:
  Scattering(const Surface& surface, Vec3f view)
      : surface_(surface),
        frame_(surface.relief_normal),
        view_(view),
        n_dot_v_(std::max(dot(surface.relief_normal, view), 1e-3F)),
        alpha_(std::max(surface.roughness * surface.roughness, least_alpha)) {
    const float mirrored_share = luminance(fresnel(surface.reflectance(), n_dot_v_));
    const float diffuse_share = luminance(surface.diffuse());
    gloss_chance_ =
        diffuse_share <= 0
            ? 1
            : std::clamp(mirrored_share / (mirrored_share + diffuse_share), 0.12F, 0.9F);
    if (mirrored_share <= 0) gloss_chance_ = 0;
  }

  struct Value {
    Vec3f diffuse, gloss;  // reflectance distribution times cosine
    float pdf = 0;         // of `sample` choosing this direction
  };
  Value evaluate(Vec3f light) const {
    Value value;
    const float n_dot_l = dot(surface_.relief_normal, light);
    if (n_dot_l <= 0 || dot(surface_.face_normal, light) <= 0) return value;
    const Vec3f half = normalized(light + view_);
    const float n_dot_h = std::max(dot(surface_.relief_normal, half), 0.0F);
    const Vec3f mirrored_part = fresnel(surface_.reflectance(), dot(view_, half));
    const float density =
        ggx_density(n_dot_h, alpha_) * ggx_masking(n_dot_v_, alpha_) / (4 * n_dot_v_);
    value.gloss = mirrored_part * (density * ggx_masking(n_dot_l, alpha_));
    value.diffuse = surface_.diffuse() * (Vec3f{1, 1, 1} - mirrored_part) * (n_dot_l * inverse_pi);
    value.pdf = gloss_chance_ * density + (1 - gloss_chance_) * n_dot_l * inverse_pi;
    return value;
  }

  struct Choice {
    Vec3f direction;
    bool gloss = false;
  };
  Choice sample(PathNumbers& numbers) const {
    const bool gloss = numbers.next() < gloss_chance_;
    const float u = numbers.next(), v = numbers.next();
    if (!gloss) return {frame_.to_world(cosine_direction(u, v)), false};
    const Vec3f local = frame_.to_local(view_);
    const Vec3f half = ggx_half_vector(local, alpha_, u, v);
    return {frame_.to_world(half * (2 * dot(local, half)) - local), true};
  }

 private:
  const Surface& surface_;
  TangentFrame frame_;
  Vec3f view_;
  float n_dot_v_, alpha_, gloss_chance_ = 0;
};

// Which first scattering a path went through: what its light counts as.
enum class Lobe { none, diffuse, other };

class PathTracer {
 public:
  PathTracer(const Lighting& lighting, const View& view, PathNumbers numbers, PathSums& sums)
      : lighting_(lighting), view_(view), numbers_(numbers), sums_(sums) {}

  void run(Ray ray, unsigned mask) {
    int bounces = 0, panes = 0;
    while (bounces <= most_bounces && panes <= most_panes) {
      const Hit hit = trace_one(lighting_.world, ray, mask | mask_glass);
      if (!hit.any()) return add_surroundings(ray, bounces);
      travelled_ += hit.t;
      const float footprint =
          bounces == 0 ? view_.footprint(travelled_) : path_bounce_footprint * hit.t;
      const Surface surface = surface_at(lighting_.world, ray, hit, footprint);
      if (surface.glass) {
        ray = through_pane(surface, ray);
        ++panes;
        continue;
      }
      add_emission(surface, ray, bounces);
      if (bounces == 0) sums_.albedo += surface.diffuse() * relief_shade(lighting_, surface);
      if (!scatter(surface, ray, bounces)) return;
      mask = mask_opaque;
      ++bounces;
    }
  }

 private:
  void add(Vec3f light, Lobe lobe, int bounces) {
    if (bounces > 0) {
      const float limit = brightest_indirect / lighting_.world.exposure;
      const float top = largest(light);
      if (top > limit) light = light * (limit / top);
    }
    if (!is_finite(light)) return;
    (lobe == Lobe::diffuse ? sums_.diffuse : sums_.other) += light;
  }

  void add_surroundings(const Ray& ray, int bounces) {
    // After a rough bounce, daylight has been counted by the windows' area lights.
    if (bounces > 0 && scatter_pdf_ > 0 && lighting_.world.surroundings.sampled_as_lights) return;
    add(throughput_ * lighting_.world.surroundings.radiance(ray.direction), lobe_, bounces);
  }

  Ray through_pane(const Surface& pane, const Ray& ray) {
    const float reflected = fresnel({pane_reflectance, pane_reflectance, pane_reflectance},
                                    -dot(pane.relief_normal, ray.direction))
                                .x;
    if (numbers_.next() < reflected) {
      if (lobe_ == Lobe::none) lobe_ = Lobe::other;
      return {pane.position, mirrored(ray.direction, pane.relief_normal)};
    }
    throughput_ *= pane.albedo;
    return {pane.position + ray.direction * pane_step_m, ray.direction};
  }

  void add_emission(const Surface& surface, const Ray& ray, int bounces) {
    if (largest(surface.emission) <= 0) return;
    float weight = 1;
    if (surface.light >= 0 && scatter_pdf_ > 0) {
      const AreaLight& light = lighting_.world.lights[static_cast<std::size_t>(surface.light)];
      if (dot(ray.direction, light.normal) >= 0) return;
      const float lamp_pdf = lighting_.lights.pdf(
          scattered_at_, surface.light, ray.direction, length(surface.position - scattered_at_));
      weight = scatter_pdf_ * scatter_pdf_ / (scatter_pdf_ * scatter_pdf_ + lamp_pdf * lamp_pdf);
    }
    add(throughput_ * surface.emission * weight, lobe_, bounces);
  }

  // Adds lamp light and turns `ray` into the next one; false when the path ends.
  bool scatter(const Surface& surface, Ray& ray, int bounces) {
    const Scattering scattering(surface, -ray.direction);
    add_lamp(surface, scattering, bounces);
    const Scattering::Choice choice = scattering.sample(numbers_);
    const Scattering::Value value = scattering.evaluate(choice.direction);
    if (value.pdf <= 1e-6F) return false;
    throughput_ *= (value.diffuse + value.gloss) / value.pdf;
    if (lobe_ == Lobe::none) lobe_ = choice.gloss ? Lobe::other : Lobe::diffuse;
    scatter_pdf_ = value.pdf;
    scattered_at_ = surface.position;
    ray = {surface.position, choice.direction};
    if (bounces < roulette_from) return largest(throughput_) > 0;
    const float survival = std::clamp(largest(throughput_), 0.05F, 0.95F);
    if (numbers_.next() >= survival) return false;
    throughput_ = throughput_ / survival;
    return true;
  }

  void add_lamp(const Surface& surface, const Scattering& scattering, int bounces) {
    const float pick = numbers_.next(), u = numbers_.next(), v = numbers_.next();
    const LightSample sample = lighting_.lights.sample(surface.position, pick, u, v);
    if (sample.pdf <= 0) return;
    const Scattering::Value value = scattering.evaluate(sample.direction);
    if (value.pdf <= 0) return;
    const Ray shadow{surface.position, sample.direction, 0, sample.distance - path_light_end_m};
    if (is_blocked(lighting_.world, shadow, mask_opaque)) return;
    const float weight =
        sample.pdf * sample.pdf / (sample.pdf * sample.pdf + value.pdf * value.pdf);
    const Vec3f light = throughput_ * sample.irradiance_scale * weight;
    add(light * value.diffuse, lobe_ == Lobe::none ? Lobe::diffuse : lobe_, bounces);
    add(light * value.gloss, lobe_ == Lobe::none ? Lobe::other : lobe_, bounces);
  }

  const Lighting& lighting_;
  const View& view_;
  PathNumbers numbers_;
  PathSums& sums_;
  Vec3f throughput_{1, 1, 1}, scattered_at_;
  float scatter_pdf_ = 0;  // 0: the eye or a mirror-like pane; lamps seen then count in full
  float travelled_ = 0;
  Lobe lobe_ = Lobe::none;
};

}  // namespace

void add_path(const Lighting& lighting,
              const View& view,
              int x,
              int y,
              std::uint32_t number,
              unsigned camera_mask,
              PathSums& sums) {
  PathNumbers numbers(static_cast<std::uint32_t>(y) * 65536U + static_cast<std::uint32_t>(x),
                      number);
  const float dx = numbers.next(), dy = numbers.next();
  const Ray ray = view.ray(static_cast<float>(x) + dx, static_cast<float>(y) + dy);
  PathTracer(lighting, view, numbers, sums).run(ray, camera_mask);
}

}  // namespace marketgen::raytrace
