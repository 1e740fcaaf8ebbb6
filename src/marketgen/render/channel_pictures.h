// Every plane of a frame as a picture for people, and all of them on one sheet.
#pragma once
#include <string>
#include <vector>

#include "geometry/image.h"
#include "render/annotations.h"
#include "render/render.h"

namespace marketgen::render {

// Depth, near yellow and red to far blue; black where there is none. `range_m`: nearest and
// farthest.
Image draw_depth(const std::vector<float>& depth_m,
                 int width,
                 int height,
                 std::array<float, 2> range_m);
// From the nearest depth to that which 98 % of the pixels keep to; {0, 1} without depth.
std::array<float, 2> depth_range_m(const std::vector<float>& depth_m);
Image draw_matter(
    const Frame& frame);  // black none, grey solid, blue glass, yellow metal, green clear
// A colour per category, that of its row.
Image draw_categories(const Frame& frame, const PictureCategories& categories);
// The colour picture with the boxes of products and actors: what shows, and thin what is hidden.
Image draw_boxes(const Frame& frame, const PictureAnnotations& annotations);

struct ChannelPicture {
  std::string name;  // as a file's: "depth"
  Image image;
};
// What a noisy sensor makes of the frame.
struct NoisyPlanes {
  Image color;
  std::vector<float> depth_m;
};
// color, boxes, depth, instances, categories, normals, matter, and of the noisy sensor noisy-color
// and noisy-depth (in depth's colours).
std::vector<ChannelPicture> channel_pictures(const Frame& frame,
                                             const scene::Scene& scene,
                                             const PictureAnnotations& annotations,
                                             const NoisyPlanes& noisy);
// All of them in rows of three, each with its name.
Image channel_sheet(const std::vector<ChannelPicture>& channels);

}  // namespace marketgen::render
