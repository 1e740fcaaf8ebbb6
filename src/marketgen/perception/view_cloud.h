// A depth picture as points and normals, pixel by pixel. Base frame, metres.
#pragma once
#include <optional>
#include <vector>

#include "agent/eyes.h"
#include "geometry/vector.h"

namespace marketgen::perception {

class ViewCloud {
 public:
  explicit ViewCloud(agent::View view);
  // The camera stands elsewhere than it was said to, and so does all that it sees: base_from_base.
  void move(const Pose& way);

  const agent::View& view() const { return view_; }
  int width() const { return view_.width(); }
  int height() const { return view_.height(); }
  std::size_t size() const { return points_.size(); }
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width()) +
           static_cast<std::size_t>(x);
  }

  bool has(std::size_t pixel) const { return view_.depth_m[pixel] > 0; }
  Vec3f point(std::size_t pixel) const { return points_[pixel]; }
  // Whether neighbours have much the same depth. Pixels at the edge of something near are measured
  // anywhere between it and what is behind it: nothing is there.
  bool is_surface(std::size_t pixel) const;
  // Unit, towards the camera; zero at steps of depth and where there is no depth.
  Vec3f normal(std::size_t pixel) const { return normals_[pixel]; }
  // Mean over the pixel and its neighbours, sRGB as 0..1.
  Vec3f color(std::size_t pixel) const { return colors_[pixel]; }

  Vec3f eye() const { return eye_; }
  // The pixel that shows a point and how far ahead of the camera it is; nothing outside the
  // picture.
  struct Seen {
    std::size_t pixel = 0;
    float depth_m = 0;
  };
  std::optional<Seen> project(Vec3f base_point) const;
  // Side of what a pixel shows at a distance.
  float pixel_m(float depth_m) const { return depth_m / static_cast<float>(view_.lens.fx); }

 private:
  void place_camera();
  void place_points();
  void find_normals();
  void blur_colors();

  agent::View view_;
  Vec3f eye_, right_, down_, ahead_;  // of the camera
  std::vector<Vec3f> points_, normals_, colors_;
};

}  // namespace marketgen::perception
