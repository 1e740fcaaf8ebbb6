// A camera turned into rays. A lens without distortion costs a ray nothing; with distortion each
// ray takes a few steps of Newton's method.
#pragma once
#include <optional>

#include "render/cameras/camera.h"
#include "render/tracing.h"

namespace marketgen::render::raytrace {

class View {
 public:
  explicit View(const Camera& camera);

  // Through picture point (x, y) in pixels, (0, 0) the top left CORNER of the picture: half a pixel
  // more than in the pixels of camera_model.h.
  Ray ray(float x, float y) const;
  // The same through eight points.
  Rays8 rays(Float8 x, Float8 y) const;
  static constexpr float near_m = 0.02F;  // rays start here: a lens has a size
  // Along the optical axis, of a point at `distance` along a ray.
  float depth_of(const Ray& ray, float distance) const {
    return dot(ray.direction, forward_) * distance;
  }
  Float8 depth_of(const Vec8& direction, Float8 distance) const {
    return dot(direction, all(forward_)) * distance;
  }
  // Width that one pixel covers at `distance`.
  float footprint(float distance) const { return pixel_ + pixel_per_m_ * distance; }
  Float8 footprint(Float8 distance) const {
    return Float8(pixel_) + Float8(pixel_per_m_) * distance;
  }
  int width() const { return width_; }
  int height() const { return height_; }

 private:
  Vec3f origin_, forward_, right_, up_;
  Vec3f bent_offset(float x, float y) const;

  int width_, height_;
  float half_width_, half_height_;  // of the picture, at distance 1, or in metres when orthographic
  float shift_x_ = 0, shift_y_ = 0;  // of its middle from the axis, the same way
  std::optional<Intrinsics> lens_;   // with distortion
  float pixel_ = 0, pixel_per_m_ = 0;
  bool orthographic_;
};

}  // namespace marketgen::render::raytrace
