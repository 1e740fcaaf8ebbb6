#include "render/path/scattering.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace marketgen::render::raytrace {
namespace {

constexpr float smoothest_alpha = 3e-3F;
constexpr int table_size = 32;    // entries for cosines 0..1, and for roughnesses 0..1
constexpr int table_strata = 16;  // squared: directions an entry is the mean of

float alpha_of(float roughness) {
  return std::max(roughness * roughness, smoothest_alpha);
}

// Albedo of a GGX surface by cosine and roughness, its Fresnel term split as f0 * scale + bias.
struct AlbedoTable {
  std::array<std::array<GlossAlbedo, table_size>, table_size> entries;  // [roughness][cosine]
  std::array<float, table_size> dielectric_mean;  // of the whole dielectric coat, by roughness

  AlbedoTable() {
    for (std::size_t r = 0; r < table_size; ++r) {
      const float alpha = alpha_of(static_cast<float>(r) / (table_size - 1));
      float mean = 0;
      for (std::size_t c = 0; c < table_size; ++c) {
        const float cosine = std::max(static_cast<float>(c) / (table_size - 1), 1e-3F);
        entries[r][c] = measured(cosine, alpha);
        const float width = c == 0 || c + 1 == table_size ? 0.5F : 1.0F;
        mean += 2 * cosine * width * entries[r][c].total(dielectric_reflectance) / (table_size - 1);
      }
      dielectric_mean[r] = mean;
    }
  }

  static GlossAlbedo measured(float cosine, float alpha) {
    const Vec3f view{std::sqrt(1 - cosine * cosine), 0, cosine};
    float scale = 0, bias = 0;
    for (int i = 0; i < table_strata * table_strata; ++i) {
      const float u = (static_cast<float>(i % table_strata) + 0.5F) / table_strata;
      const float v = (static_cast<float>(i / table_strata) + 0.5F) / table_strata;
      const Vec3f half = ggx_half_vector(view, alpha, u, v);
      const float v_dot_h = dot(view, half);
      const Vec3f light = half * (2 * v_dot_h) - view;
      if (light.z <= 0) continue;
      const float weight = ggx_masking(light.z, alpha);
      const float lift = fifth_power(1 - std::clamp(v_dot_h, 0.0F, 1.0F));
      scale += weight * (1 - lift);
      bias += weight * lift;
    }
    constexpr float share = 1.0F / (table_strata * table_strata);
    return {scale * share, bias * share};
  }
};

const AlbedoTable& albedo_table() {
  static const AlbedoTable table;
  return table;
}

struct TablePlace {
  std::size_t low;
  float share;
};
TablePlace table_place(float x) {
  const float at = std::clamp(x, 0.0F, 1.0F) * (table_size - 1);
  const auto low = std::min(static_cast<std::size_t>(at), std::size_t{table_size - 2});
  return {low, at - static_cast<float>(low)};
}

// Mean over all directions of what the dielectric coat mirrors.
float mean_coat_albedo(float roughness) {
  const TablePlace r = table_place(roughness);
  const auto& mean = albedo_table().dielectric_mean;
  return std::lerp(mean[r.low], mean[r.low + 1], r.share);
}

// Turquin 2019: single scattering times this returns all light where f0 is 1.
float compensation(const GlossAlbedo& albedo, float f0) {
  const float single = std::max(albedo.scale + albedo.bias, 1e-3F);
  return 1 + f0 * (1 - single) / single;
}

}  // namespace

float GlossAlbedo::total(float f0) const {
  return (f0 * scale + bias) * compensation(*this, f0);
}

GlossAlbedo gloss_albedo(float cos_theta, float roughness) {
  const TablePlace c = table_place(cos_theta), r = table_place(roughness);
  const auto& entries = albedo_table().entries;
  const auto between = [&](float GlossAlbedo::*part) {
    const auto row = [&](std::size_t k) {
      return std::lerp(entries[k][c.low].*part, entries[k][c.low + 1].*part, c.share);
    };
    return std::lerp(row(r.low), row(r.low + 1), r.share);
  };
  return {between(&GlossAlbedo::scale), between(&GlossAlbedo::bias)};
}

Scattering::Scattering(
    const Finish& finish, Vec3f normal, Vec3f diffuse_normal, Vec3f face_normal, Vec3f view)
    : finish_(finish),
      frame_(normal),
      diffuse_frame_(diffuse_normal),
      face_normal_(face_normal),
      view_(view),
      n_dot_v_(std::max(dot(normal, view), 1e-3F)),
      alpha_(alpha_of(finish.roughness)),
      coat_alpha_(alpha_of(finish.coat_roughness)) {
  const GlossAlbedo albedo = gloss_albedo(n_dot_v_, finish.roughness);
  const Vec3f f0 = mix(Vec3f{1, 1, 1} * dielectric_reflectance, finish.color, finish.metallic);
  gloss_scale_ = {
      compensation(albedo, f0.x), compensation(albedo, f0.y), compensation(albedo, f0.z)};
  let_in_ = 1 - albedo.total(dielectric_reflectance);
  float coat_share = 0;
  if (finish.coat > 0) {
    const GlossAlbedo coat = gloss_albedo(n_dot_v_, finish.coat_roughness);
    coat_scale_ = finish.coat * compensation(coat, dielectric_reflectance);
    coat_share = finish.coat * coat.total(dielectric_reflectance);
    below_coat_ = 1 - coat_share;
  }
  const float gloss_share = below_coat_ * albedo.total(luminance(f0));
  const float diffuse_share =
      below_coat_ * luminance(finish.color) * (1 - finish.metallic) * let_in_;
  const float whole = coat_share + gloss_share + diffuse_share;
  // Every lobe that is there keeps a chance that its highlights do not become sparkles.
  constexpr float min_chance = 0.1F;
  const float coat_weight = coat_share > 0 ? std::max(coat_share / whole, min_chance) : 0;
  const float gloss_weight = std::max(gloss_share / whole, min_chance);
  const float diffuse_weight = diffuse_share > 0 ? std::max(diffuse_share / whole, min_chance) : 0;
  const float sum = coat_weight + gloss_weight + diffuse_weight;
  coat_chance_ = coat_weight / sum;
  gloss_chance_ = gloss_weight / sum;
  through_chance_ = diffuse_weight / sum * finish.translucency;
}

float Scattering::gloss_density(float n_dot_h, float alpha) const {
  return ggx_density(n_dot_h, alpha) * ggx_masking(n_dot_v_, alpha) / (4 * n_dot_v_);
}

Vec3f Scattering::gloss_value(Vec3f light, float n_dot_l, Vec3f half) const {
  const float n_dot_h = std::max(dot(frame_.normal, half), 0.0F);
  const float v_dot_h = dot(view_, half);
  const Vec3f f0 = mix(Vec3f{1, 1, 1} * dielectric_reflectance, finish_.color, finish_.metallic);
  const float base = gloss_density(n_dot_h, alpha_) * ggx_masking(n_dot_l, alpha_) * below_coat_;
  Vec3f value = fresnel(f0, v_dot_h) * gloss_scale_ * base;
  if (coat_scale_ > 0) {
    const float coat = gloss_density(n_dot_h, coat_alpha_) * ggx_masking(n_dot_l, coat_alpha_);
    value += fresnel(Vec3f{1, 1, 1} * dielectric_reflectance, v_dot_h) * (coat * coat_scale_);
  }
  return dot(face_normal_, light) > 0 ? value : Vec3f{};
}

Vec3f Scattering::diffuse_value(float n_dot_l) const {
  const float lets_out = 1 - gloss_albedo(n_dot_l, finish_.roughness).total(dielectric_reflectance);
  const float through_coat =
      let_in_ * lets_out / std::max(1 - mean_coat_albedo(finish_.roughness), 1e-3F);
  return finish_.color *
         ((1 - finish_.metallic) * below_coat_ * through_coat * n_dot_l * inverse_pi);
}

Scattering::Value Scattering::evaluate(Vec3f light) const {
  Value value;
  const float n_dot_l = dot(frame_.normal, light);
  const float diffuse_n_dot_l = dot(diffuse_frame_.normal, light);
  const bool above = dot(face_normal_, light) > 0;
  if (n_dot_l > 0 && above) {
    const Vec3f half = normalized(light + view_);
    const float n_dot_h = std::max(dot(frame_.normal, half), 0.0F);
    value.gloss = gloss_value(light, n_dot_l, half);
    value.pdf += gloss_chance_ * gloss_density(n_dot_h, alpha_);
    if (coat_chance_ > 0) value.pdf += coat_chance_ * gloss_density(n_dot_h, coat_alpha_);
  }
  const float diffuse_chance = 1 - coat_chance_ - gloss_chance_ - through_chance_;
  if (diffuse_n_dot_l > 0 && above) {
    value.diffuse = diffuse_value(diffuse_n_dot_l) * (1 - finish_.translucency);
    value.pdf += diffuse_chance * diffuse_n_dot_l * inverse_pi;
  } else if (diffuse_n_dot_l < 0 && !above && finish_.translucency > 0) {
    value.diffuse = diffuse_value(-diffuse_n_dot_l) * finish_.translucency;
    value.pdf += through_chance_ * -diffuse_n_dot_l * inverse_pi;
  }
  return value;
}

Scattering::Choice Scattering::sample(float pick, float u, float v) const {
  const bool coat = pick < coat_chance_;
  if (!coat && pick >= coat_chance_ + gloss_chance_) {
    Vec3f local = cosine_direction(u, v);
    if (pick < coat_chance_ + gloss_chance_ + through_chance_) local.z = -local.z;
    return {diffuse_frame_.to_world(local), false};
  }
  const Vec3f local = frame_.to_local(view_);
  const Vec3f half = ggx_half_vector(local, coat ? coat_alpha_ : alpha_, u, v);
  return {frame_.to_world(half * (2 * dot(local, half)) - local), true};
}

float interface_reflectance(float cos_theta, float eta) {
  const float c = std::clamp(cos_theta, 0.0F, 1.0F);
  const float beyond2 = 1 - (1 - c * c) / (eta * eta);
  if (beyond2 <= 0) return 1;
  const float b = std::sqrt(beyond2);
  const float parallel = (eta * c - b) / (eta * c + b), across = (c - eta * b) / (c + eta * b);
  return 0.5F * (parallel * parallel + across * across);
}

float sheet_reflectance(float cos_theta, float index) {
  const float face = interface_reflectance(cos_theta, index);
  return 2 * face / (1 + face);
}

std::optional<Vec3f> refracted(Vec3f direction, Vec3f normal, float eta) {
  const float c = -dot(direction, normal);
  const float beyond2 = 1 - (1 - c * c) / (eta * eta);
  if (beyond2 <= 0) return std::nullopt;
  return normalized(direction / eta + normal * (c / eta - std::sqrt(beyond2)));
}

}  // namespace marketgen::render::raytrace
