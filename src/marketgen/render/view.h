// A camera turned into rays.
#pragma once
#include "render/camera.h"
#include "render/tracing.h"

namespace marketgen::raytrace {

class View {
 public:
  explicit View(const Camera& camera);

  // Through picture point (x, y) in pixels, (0, 0) the top left corner.
  Ray ray(float x, float y) const;
  // Along the optical axis, of a point at `distance` along a ray.
  float depth_of(const Ray& ray, float distance) const {
    return dot(ray.direction, forward_) * distance;
  }
  // Width that one pixel covers at `distance`.
  float footprint(float distance) const { return pixel_ + pixel_per_m_ * distance; }
  int width() const { return width_; }
  int height() const { return height_; }

 private:
  Vec3f origin_, forward_, right_, up_;
  int width_, height_;
  float half_width_, half_height_;  // of the picture, at distance 1, or in metres when orthographic
  float pixel_ = 0, pixel_per_m_ = 0;
  bool orthographic_;
};

}  // namespace marketgen::raytrace
