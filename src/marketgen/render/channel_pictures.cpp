#include "render/channel_pictures.h"

#include <algorithm>
#include <cmath>

#include "assets/print/lettering.h"

namespace marketgen::render {
namespace {

constexpr int sheet_columns = 3;

using Rgb = std::array<std::uint8_t, 3>;

std::uint8_t channel_byte(double x) {
  return static_cast<std::uint8_t>(std::clamp(x, 0.0, 1.0) * 255 + 0.5);
}

// Turbo (A. Mikhailov, "Turbo, an improved rainbow colormap", Google AI blog, 2019), its
// polynomial.
Rgb turbo(double x) {
  const auto polynomial = [x](const std::array<double, 6>& c) {
    return c[0] + x * (c[1] + x * (c[2] + x * (c[3] + x * (c[4] + x * c[5]))));
  };
  return {channel_byte(polynomial(
              {0.13572138, 4.61539260, -42.66032258, 132.13108234, -152.94239396, 59.28637943})),
          channel_byte(polynomial(
              {0.09140261, 2.19418839, 4.84296658, -14.18503333, 4.27729857, 2.82956604})),
          channel_byte(polynomial(
              {0.10667330, 12.64194608, -60.58204836, 110.36276771, -89.90310912, 27.34824973}))};
}

void set_pixel(Image& image, std::size_t pixel, const Rgb& color) {
  std::copy(color.begin(), color.end(), &image.pixels[3 * pixel]);
}

void draw_rectangle(Image& image, const std::array<int, 4>& box, const Rgb& color, int step) {
  const auto [x0, y0, x1, y1] = box;
  const auto dot_at = [&](int x, int y) {
    if (x >= 0 && y >= 0 && x < image.width && y < image.height && (x + y) % step == 0)
      std::copy(color.begin(), color.end(), image.at(x, y));
  };
  for (int x = x0; x < x1; ++x)
    dot_at(x, y0), dot_at(x, y1 - 1);
  for (int y = y0; y < y1; ++y)
    dot_at(x0, y), dot_at(x1 - 1, y);
}

// Clamped a little beyond the picture: an object close by may reach very far out of it.
std::array<int, 4> drawable(const std::array<double, 4>& box, const Image& image) {
  const auto pixel = [](double x, int side) {
    return static_cast<int>(std::lround(std::clamp(x, -8.0, side + 8.0)));
  };
  return {pixel(box[0], image.width),
          pixel(box[1], image.height),
          pixel(box[2], image.width),
          pixel(box[3], image.height)};
}

// Categories of the actors, by their order, up to the last that is seen.
std::vector<std::string> actors_seen(const scene::Scene& scene,
                                     const PictureAnnotations& annotations) {
  std::vector<std::string> categories;
  for (const ObjectAnnotation& object : annotations.objects) {
    if (object.kind != ObjectKind::actor) continue;
    categories.resize(object.id - first_actor_object(scene), "actor");
    categories.push_back(object.category);
  }
  return categories;
}

}  // namespace

std::array<float, 2> depth_range_m(const std::vector<float>& depth_m) {
  std::vector<float> seen;
  std::copy_if(
      depth_m.begin(), depth_m.end(), std::back_inserter(seen), [](float d) { return d > 0; });
  if (seen.empty()) return {0, 1};
  const auto far = seen.begin() + static_cast<std::ptrdiff_t>((seen.size() - 1) * 98 / 100);
  std::nth_element(seen.begin(), far, seen.end());
  return {*std::min_element(seen.begin(), seen.end()), *far};
}

Image draw_depth(const std::vector<float>& depth_m,
                 int width,
                 int height,
                 std::array<float, 2> range_m) {
  Image image(width, height);
  const auto [near, far] = range_m;
  for (std::size_t i = 0; i < depth_m.size(); ++i) {
    if (depth_m[i] <= 0) continue;
    const float share = (depth_m[i] - near) / std::max(far - near, 1e-6F);
    set_pixel(image, i, turbo(0.95 - 0.9 * static_cast<double>(std::clamp(share, 0.0F, 1.0F))));
  }
  return image;
}

Image draw_matter(const Frame& frame) {
  constexpr std::array<Rgb, 5> colors{
      Rgb{0, 0, 0}, {150, 150, 150}, {60, 130, 255}, {250, 200, 40}, {60, 210, 110}};
  Image image(frame.color.width, frame.color.height);
  for (std::size_t i = 0; i < frame.matter.size(); ++i)
    set_pixel(image, i, colors[frame.matter[i]]);
  return image;
}

Image draw_categories(const Frame& frame, const PictureCategories& categories) {
  Image image(frame.color.width, frame.color.height);
  for (std::size_t i = 0; i < frame.instance.size(); ++i)
    set_pixel(image, i, object_color(categories.of(frame.instance[i])));
  return image;
}

Image draw_boxes(const Frame& frame, const PictureAnnotations& annotations) {
  Image image = frame.color;
  for (const ObjectAnnotation& object : annotations.objects) {
    if (object.kind != ObjectKind::product && object.kind != ObjectKind::actor) continue;
    const Rgb color = object_color(object.id);
    if (object.full_box_px) draw_rectangle(image, drawable(*object.full_box_px, image), color, 3);
    draw_rectangle(image, object.box_px, color, 1);
  }
  return image;
}

std::vector<ChannelPicture> channel_pictures(const Frame& frame,
                                             const scene::Scene& scene,
                                             const PictureAnnotations& annotations,
                                             const NoisyPlanes& noisy) {
  const int width = frame.color.width, height = frame.color.height;
  const std::array<float, 2> range_m = depth_range_m(frame.depth_m);
  return {{"color", frame.color},
          {"boxes", draw_boxes(frame, annotations)},
          {"depth", draw_depth(frame.depth_m, width, height, range_m)},
          {"instances", draw_instances(frame, width, height)},
          {"categories",
           draw_categories(frame, PictureCategories(scene, actors_seen(scene, annotations)))},
          {"normals", draw_normals(frame, width, height)},
          {"matter", draw_matter(frame)},
          {"noisy-color", noisy.color},
          {"noisy-depth", draw_depth(noisy.depth_m, width, height, range_m)}};
}

Image channel_sheet(const std::vector<ChannelPicture>& channels) {
  const Image& first = channels.front().image;
  const int caption = std::max(12, first.height / 14), gap = std::max(2, first.width / 160);
  const int rows = (static_cast<int>(channels.size()) + sheet_columns - 1) / sheet_columns;
  const int step_x = first.width + gap, step_y = first.height + caption + gap;
  assets::Canvas canvas(step_x * sheet_columns + gap, step_y * rows + gap, assets::Color{1, 1, 1});
  for (std::size_t i = 0; i < channels.size(); ++i) {
    const int x = gap + static_cast<int>(i) % sheet_columns * step_x;
    const int y = static_cast<int>(i) / sheet_columns * step_y;
    assets::Headline name{
        channels[i].name, {}, assets::Color{0.1, 0.1, 0.1}, {}, assets::Align::left};
    name.area = {double(x), double(y), double(first.width), double(caption)};
    name.max_size = caption * 0.7;
    assets::draw_headline(canvas, name);
  }
  Image sheet = canvas.image();
  for (std::size_t i = 0; i < channels.size(); ++i) {
    const Image& picture = channels[i].image;
    const int x = gap + static_cast<int>(i) % sheet_columns * step_x;
    const int y = static_cast<int>(i) / sheet_columns * step_y + caption;
    for (int row = 0; row < picture.height; ++row)
      std::copy_n(
          picture.at(0, row), static_cast<std::size_t>(picture.width) * 3, sheet.at(x, y + row));
  }
  return sheet;
}

}  // namespace marketgen::render
