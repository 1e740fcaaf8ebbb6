#include "render/path/path.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "render/path/light_through.h"
#include "render/path/path_numbers.h"
#include "render/path/scattering.h"
#include "render/picture_objects.h"
#include "render/shading_math.h"
#include "render/stage/clear_pack.h"

namespace marketgen::render::raytrace {
namespace {

constexpr int max_bounces = 12, max_crossings = 24;
constexpr int roulette_from = 3;  // bounces before paths may end by chance
// In units of white; caps fireflies. Light that reaches the eye by one bounce is never capped, but
// for lamps found through the contents of a pack: few paths find them, as bright dots.
constexpr float brightest_indirect = 10, brightest_through_pack = 2.5F;
// The same of light that a pane or wall mirrors onto what the eye sees: lamps found that way are
// found by one path in hundreds.
constexpr float brightest_glint = 0.5F;
constexpr float path_light_end_m = 5e-3F;
// Metres per metre: textures are read blurred after the first bounce.
constexpr float path_bounce_footprint = 0.05F;
// Paths end in stored light only behind a bounce at least this rough: smoother ones are mirrors.
constexpr float rough_from = 0.35F;
constexpr float glass_index = 1.5F;
constexpr float min_mirror_chance = 0.25F;
// Relief is read from stored light, which knows its tilt only roughly.
constexpr float darkest_tilt = 0.5F, brightest_tilt = 1.8F;
constexpr float min_tilt_turn = 1e-4F;

std::uint32_t pixel_number(const PathStart& start) {
  return static_cast<std::uint32_t>(start.y) * 65536U + static_cast<std::uint32_t>(start.x);
}

Finish finish_of(const Surface& s, const Material& m) {
  return {s.albedo, s.roughness, s.metallic, m.coat, m.coat_roughness, m.translucency};
}

// Light that wandered below a surface leaves around where it came in: a point drawn from the
// normalised diffusion profile (Christensen and Burley 2015), mean reach `reach_m`.
struct Outlet {
  Vec3f position, normal, face_normal;
};
Outlet outlet_of(const World& world, const Surface& surface, float reach_m, PathNumbers& numbers) {
  const Outlet straight{surface.position, surface.relief_normal, surface.face_normal};
  const Vec2f at = numbers.pair();
  const float depth = reach_m / 2.5F;  // the profile's mean radius is 2.5 of its parameter
  const bool near = at.x < 0.25F;      // a quarter of the light keeps to the narrow exponential
  const float u = near ? at.x * 4 : (at.x - 0.25F) / 0.75F;
  const float radius = std::min(-(near ? depth : 3 * depth) * std::log(1 - u), 4 * reach_m);
  const TangentFrame frame(surface.face_normal);
  const Vec3f aside = frame.tangent * (radius * std::cos(two_pi * at.y)) +
                      frame.bitangent * (radius * std::sin(two_pi * at.y));
  const float height = radius + 1e-3F;
  const Ray probe{
      surface.position + aside + surface.face_normal * height, -surface.face_normal, 0, 2 * height};
  const Hit hit = trace_one(world, probe, mask_solid);
  if (!hit.any()) return straight;
  const Surface found = surface_at(world, probe, hit, path_bounce_footprint * radius);
  if (found.id != surface.id || found.back_face) return straight;
  return {found.position, found.relief_normal, found.face_normal};
}

class PathTracer {
 public:
  PathTracer(const PathScene& scene,
             const View& view,
             const PathSettings& settings,
             PathNumbers numbers)
      : scene_(scene),
        view_(view),
        settings_(settings),
        numbers_(numbers),
        firefly_(brightest_indirect / scene.world.exposure) {}

  PathLight run(Ray ray, Hit hit) {
    for (int crossings = 0; crossings <= max_crossings;) {
      if (!hit.any()) {
        add_surroundings(ray);
        break;
      }
      fade(hit.t);
      Surface surface = surface_at(scene_.world, ray, hit, footprint_at(hit.t));
      if (inside_ && surface.back_face) surface.albedo = label_back;  // a label seen from behind
      const Material& material = scene_.world.materials[surface.material];
      if (surface.glass || material.clear) {
        ray = cross(surface, material, ray);
        ++crossings;
      } else if (!bounce(surface, material, ray)) {
        break;
      }
      hit =
          trace_one(scene_.world, ray, (bounces_ == 0 ? settings_.mask : mask_opaque) | mask_glass);
    }
    return light_;
  }

 private:
  enum class Lobe { none, diffuse, gloss };  // of the first surface that turned the path

  float footprint_at(float t) {
    if (bounces_ > 0) return path_bounce_footprint * t;
    travelled_ += t;
    return view_.footprint(travelled_);
  }

  // What the contents of a pack take of the light since they were entered.
  void fade(float t) {
    if (!inside_) return;
    const Vec3f depth = scene_.world.materials[*inside_].absorption_per_m * t;
    throughput_ *= Vec3f{std::exp(-depth.x), std::exp(-depth.y), std::exp(-depth.z)};
  }

  static float share_below(float most, Vec3f light) {
    const float top = largest(light);
    return top > most ? most / top : 1;
  }

  void add(Vec3f light, Lobe lobe) {
    if (bounces_ > 0 || bent_) {
      const float most = firefly_ * ((glint_  ? brightest_glint
                                      : bent_ ? brightest_through_pack
                                              : brightest_indirect) /
                                     brightest_indirect);
      light = light * share_below(most, light);
    }
    if (!is_finite(light)) return;
    if (lobe == Lobe::none) {
      light_.glow += light;
      light_.beyond += light * (1 - share_below(settings_.brightest_shown, light));
    }
    if (lobe == Lobe::diffuse) light_.diffuse += light;
    if (lobe == Lobe::gloss) light_.gloss += light;
  }

  // Whether a lamp found by chance was already counted in full where the path last scattered:
  // light_through looks straight through clear packs.
  bool counted_by_lamps() const { return bounces_ > 0 && bent_; }

  void add_surroundings(const Ray& ray) {
    // After a rough bounce, daylight has been counted by the windows' area lights.
    const bool sampled = scene_.world.surroundings.sampled_as_lights;
    if (bounces_ > 0 && sampled && (bent_ || scatter_pdf_ > 0)) return;
    add(throughput_ * scene_.world.surroundings.radiance(ray.direction), lobe_);
  }

  // Through a pane, a thin wall, or into and out of what fills a pack; or mirrored by it.
  Ray cross(const Surface& surface, const Material& material, const Ray& ray) {
    const bool bends = !surface.glass && material.refraction > 1;
    const float eta = surface.back_face ? 1 / material.refraction : material.refraction;
    const float cosine = -dot(surface.relief_normal, ray.direction);
    const float reflected = bends           ? interface_reflectance(cosine, eta)
                            : surface.glass ? interface_reflectance(cosine, glass_index)
                                            : sheet_reflectance(cosine, glass_index);
    // What a window mirrors by night is far brighter than what is behind it: one path in a few
    // looks, not one in twenty.
    const bool first_pane =
        surface.glass && surface.id == shell_object && lobe_ == Lobe::none && !surface.back_face;
    const float chance = first_pane ? std::max(reflected, min_mirror_chance) : reflected;
    if (numbers_.one() < chance) {
      throughput_ *= Vec3f{1, 1, 1} * (reflected / chance);
      if (lobe_ == Lobe::none && !inside_) lobe_ = Lobe::gloss;
      scatter_pdf_ = 0;
      glint_ = bounces_ > 0;
      return {surface.position, mirrored(ray.direction, surface.relief_normal)};
    }
    if (first_pane) throughput_ *= Vec3f{1, 1, 1} * ((1 - reflected) / (1 - chance));
    const Vec3f beyond = surface.position - surface.face_normal * (2 * surface_lift_m);
    if (surface.glass) throughput_ *= surface.albedo;
    if (!bends) return {beyond, ray.direction};
    inside_ = surface.back_face ? std::nullopt : std::optional<std::size_t>(surface.material);
    bent_ = true;
    const auto turned = refracted(ray.direction, surface.relief_normal, eta);
    return {beyond, turned ? *turned : ray.direction};
  }

  // Takes the surface's light and turns `ray` into the next one; false when the path ends.
  bool bounce(const Surface& surface, const Material& material, Ray& ray) {
    add_emission(surface, ray);
    if (bounces_ == 0) note_look(surface);
    if (bounces_ > 0 && settings_.end_in_stored_light && softened_) {
      add(throughput_ * stored(surface, ray.direction), lobe_);
      return false;
    }
    return bounces_ < max_bounces && scatter(surface, material, ray);
  }

  void add_emission(const Surface& surface, const Ray& ray) {
    if (largest(surface.emission) <= 0) return;
    float weight = 1;
    if (surface.light >= 0) {
      if (counted_by_lamps()) return;
      const AreaLight& light = scene_.world.lights[static_cast<std::size_t>(surface.light)];
      if (bounces_ > 0 && dot(ray.direction, light.normal) >= 0) return;
      if (scatter_pdf_ > 0) {
        const float lamp_pdf = scene_.lights.pdf(
            scattered_at_, surface.light, ray.direction, length(surface.position - scattered_at_));
        weight = scatter_pdf_ * scatter_pdf_ / (scatter_pdf_ * scatter_pdf_ + lamp_pdf * lamp_pdf);
      }
    }
    add(throughput_ * surface.emission * weight, lobe_);
  }

  void note_look(const Surface& surface) {
    if (lobe_ != Lobe::none) return;  // seen in a mirror
    const Vec3f through = throughput_ * tilt(surface);
    light_.albedo = surface.diffuse() * through;
    light_.paint = surface.albedo * through;
  }

  // How much more or less light relief catches than the flat face: keeps relief out of the filter.
  float tilt(const Surface& surface) const {
    if (dot(surface.relief_normal, surface.normal) > 1 - min_tilt_turn) return 1;
    return std::clamp(scene_.field.tilt(place_of(surface), surface.normal, surface.relief_normal),
                      darkest_tilt,
                      brightest_tilt);
  }

  // Radiance towards where the ray came from, from stored light; lamps' own light left out.
  Vec3f stored(const Surface& surface, Vec3f direction) const {
    const Place place = place_of(surface);
    const Vec3f mirrored_share = rough_fresnel(
        surface.reflectance(), -dot(surface.relief_normal, direction), surface.roughness);
    const Vec3f before = scene_.field.at(place, surface.relief_normal) * inverse_pi;
    // What little a coat mirrors is taken for as bright as what lights it.
    const Vec3f around =
        surface.metallic > 0
            ? scene_.field.at(place, mirrored(direction, surface.relief_normal)) * inverse_pi
            : before;
    return surface.diffuse() * (Vec3f{1, 1, 1} - mirrored_share) * before + mirrored_share * around;
  }

  bool scatter(const Surface& surface, const Material& material, Ray& ray) {
    Outlet outlet{surface.position, surface.relief_normal, surface.face_normal};
    if (material.scatter_m > 0 && bounces_ == 0)
      outlet = outlet_of(scene_.world, surface, material.scatter_m, numbers_);
    const Scattering scattering(finish_of(surface, material),
                                surface.relief_normal,
                                outlet.normal,
                                outlet.face_normal,
                                -ray.direction);
    add_lamp(outlet, scattering);
    const float pick = numbers_.one();
    const Vec2f at = numbers_.pair();
    const Scattering::Choice choice = scattering.sample(pick, at.x, at.y);
    const Scattering::Value value = scattering.evaluate(choice.direction);
    if (value.pdf <= 1e-6F) return false;
    throughput_ *= (value.diffuse + value.gloss) / value.pdf;
    if (lobe_ == Lobe::none) lobe_ = choice.gloss ? Lobe::gloss : Lobe::diffuse;
    softened_ = softened_ || !choice.gloss || surface.roughness >= rough_from;
    scatter_pdf_ = value.pdf;
    scattered_at_ = outlet.position;
    bent_ = glint_ = false;
    ++bounces_;
    ray = {start_of(outlet, choice.direction), choice.direction};
    return survives();
  }

  // Directions through a thin body start on its far side.
  static Vec3f start_of(const Outlet& outlet, Vec3f direction) {
    if (dot(direction, outlet.face_normal) >= 0) return outlet.position;
    return outlet.position - outlet.face_normal * (2 * surface_lift_m);
  }

  bool survives() {
    if (bounces_ <= roulette_from) return largest(throughput_) > 0;
    const float survival = std::clamp(largest(throughput_), 0.05F, 0.95F);
    if (numbers_.one() >= survival) return false;
    throughput_ = throughput_ / survival;
    return true;
  }

  void add_lamp(const Outlet& outlet, const Scattering& scattering) {
    const float pick = numbers_.one();
    const Vec2f at = numbers_.pair();
    const LightSample sample = scene_.lights.sample(outlet.position, pick, at.x, at.y);
    if (sample.pdf <= 0) return;
    const Scattering::Value value = scattering.evaluate(sample.direction);
    if (value.pdf <= 0) return;
    const Vec3f passed = light_through(scene_.world,
                                       {start_of(outlet, sample.direction),
                                        sample.direction,
                                        0,
                                        sample.distance - path_light_end_m});
    if (largest(passed) <= 0) return;
    const float weight =
        sample.pdf * sample.pdf / (sample.pdf * sample.pdf + value.pdf * value.pdf);
    const Vec3f light = throughput_ * sample.irradiance_scale * passed * weight;
    add(light * value.diffuse, lobe_ == Lobe::none ? Lobe::diffuse : lobe_);
    add(light * value.gloss, lobe_ == Lobe::none ? Lobe::gloss : lobe_);
  }

  const PathScene& scene_;
  const View& view_;
  const PathSettings& settings_;
  PathNumbers numbers_;
  float firefly_;
  PathLight light_;
  Vec3f throughput_{1, 1, 1}, scattered_at_;
  float scatter_pdf_ = 0;  // 0: the eye or a mirror; lamps seen then count in full
  float travelled_ = 0;
  int bounces_ = 0;
  std::optional<std::size_t> inside_;  // material of the wall whose contents the path is in
  bool bent_ = false;                  // by contents since it last scattered
  bool glint_ = false;                 // mirrored by something clear since it last scattered
  bool softened_ = false;              // by a rough bounce
  Lobe lobe_ = Lobe::none;
};

}  // namespace

Ray eye_ray(const View& view, const PathStart& start) {
  const Vec2f inside = PathNumbers(pixel_number(start), start.number).pair();
  return view.ray(static_cast<float>(start.x) + inside.x, static_cast<float>(start.y) + inside.y);
}

PathLight trace_path(const PathScene& scene,
                     const View& view,
                     const PathSettings& settings,
                     const PathStart& start,
                     const Ray& ray,
                     const Hit& first) {
  PathNumbers numbers(pixel_number(start), start.number);
  (void)numbers.pair();  // the one that eye_ray took
  return PathTracer(scene, view, settings, numbers).run(ray, first);
}

}  // namespace marketgen::render::raytrace
