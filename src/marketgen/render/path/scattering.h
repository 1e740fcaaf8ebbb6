// How a surface scatters light: a diffuse base under a dielectric coat, or metal, with an optional
// clear lacquer over both and light that leaks through thin bodies; and what interfaces of clear
// bodies reflect and bend. Path tracing only.
//
// Gloss is GGX with separable Smith masking, sampled by visible normals (Heitz, JCGT 2018), with
// Schlick's Fresnel. What single scattering loses between microfacets is given back by the albedo
// scaling of Turquin ("Practical multiple scattering compensation for microfacet models", 2019).
// The diffuse base gets what the coat lets in and out (Kelemen and Szirmay-Kalos 2001), so that a
// white surface returns all light.
#pragma once
#include <optional>

#include "geometry/vector.h"
#include "render/shading_math.h"

namespace marketgen::render::raytrace {

struct Finish {
  Vec3f color;  // diffuse colour, or the metal's
  float roughness = 0.5F, metallic = 0;
  float coat = 0, coat_roughness = 0.1F;  // share of a clear lacquer on top
  float translucency = 0;                 // share of the diffuse light that leaves on the far side
};

// Share of light from all around that a GGX surface mirrors towards an eye at cos_theta, when its
// Fresnel reflectance at normal incidence is `f0`: single scattering is f0 * scale + bias; `total`
// adds what scatters between facets.
struct GlossAlbedo {
  float scale = 1, bias = 0;
  float total(float f0) const;
};
GlossAlbedo gloss_albedo(float cos_theta, float roughness);

class Scattering {
 public:
  // `view` points to the eye; all are unit vectors. `diffuse_normal` is the normal where diffuse
  // light leaves; it differs from `normal` where light wanders below the surface.
  Scattering(
      const Finish& finish, Vec3f normal, Vec3f diffuse_normal, Vec3f face_normal, Vec3f view);

  struct Value {
    Vec3f diffuse, gloss;  // scattering distribution times |cosine|
    float pdf = 0;         // of `sample` choosing this direction, over solid angle
  };
  Value evaluate(Vec3f light) const;

  struct Choice {
    Vec3f direction;
    bool gloss = false;
  };
  // Picks the lobe by `pick` and the direction in it by (u, v), all in [0, 1).
  Choice sample(float pick, float u, float v) const;

 private:
  float gloss_density(float n_dot_h, float alpha) const;
  Vec3f gloss_value(Vec3f light, float n_dot_l, Vec3f half) const;
  Vec3f diffuse_value(float n_dot_l) const;

  Finish finish_;
  TangentFrame frame_, diffuse_frame_;
  Vec3f face_normal_, view_;
  float n_dot_v_, alpha_, coat_alpha_;
  Vec3f gloss_scale_;                      // compensation of the base's gloss
  float coat_scale_ = 0, below_coat_ = 1;  // lacquer's compensation, and what it lets in
  float let_in_ = 1;                       // by the dielectric coat to the diffuse base
  float coat_chance_ = 0, gloss_chance_ = 0, through_chance_ = 0;  // of lobes; the rest is diffuse
};

// Unpolarised Fresnel reflectance of a smooth interface; `eta` = index beyond over index before,
// `cos_theta` on the side before. 1 under total internal reflection.
float interface_reflectance(float cos_theta, float eta);
// Of a thin sheet with two such faces in air, bouncing between them included: 2R / (1 + R).
float sheet_reflectance(float cos_theta, float index);
// Snell's law: `direction` meets the interface from the side of `normal`. Nothing under total
// internal reflection.
std::optional<Vec3f> refracted(Vec3f direction, Vec3f normal, float eta);

}  // namespace marketgen::render::raytrace
