// What can be read from pictures taken at stated distances by a plain camera (1280 x 720, 60
// degrees high): bar codes by zbar, prices and names on shelf labels by tesseract.
//
// tools/read_distances sets MARKETGEN_READING=all: more goods, every distance, and the labels,
// whose reader tools/setup does not install. MARKETGEN_READING_PICTURES keeps the pictures in that
// folder.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <string>

#include "base/text.h"
#include "io/file.h"
#include "scene/price_tags.h"
#include "support/bar_faces.h"
#include "synthetic_scene.h"

namespace marketgen {
namespace {

bool reads_all() {
  return std::getenv("MARKETGEN_READING") != nullptr;
}

std::filesystem::path picture_folder(const ScratchFolder& scratch) {
  const char* kept = std::getenv("MARKETGEN_READING_PICTURES");
  const std::filesystem::path folder = kept == nullptr ? scratch.path() : kept;
  std::filesystem::create_directories(folder);
  return folder;
}

// Every n-th packed product of the catalogue.
std::vector<catalog::Product> some_products(std::size_t count) {
  const catalog::Catalog catalog = catalog::load_catalog(io::data_folder().value()).value();
  std::vector<catalog::Product> packed, chosen;
  std::copy_if(catalog.products.begin(),
               catalog.products.end(),
               std::back_inserter(packed),
               [](const catalog::Product& product) { return !product.ean.empty(); });
  for (std::size_t i = 0; i < count; ++i)
    chosen.push_back(packed[i * packed.size() / count]);
  return chosen;
}

render::Camera hand_camera(const std::string& name, Vec3 at, double distance_m) {
  render::Camera camera{name, at - Vec3{0, distance_m, 0}, at};
  camera.fov_deg = 60;
  camera.width = 1280, camera.height = 720;
  return camera;
}

int bar_codes_read(const BarStage& stage,
                   render::Renderer& renderer,
                   double distance_m,
                   const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  for (const render::Camera& shown : stage.cameras) {
    const render::Camera camera = hand_camera(shown.name, shown.at, distance_m);
    files.push_back(folder / (shown.name + ".png"));
    render::RenderOptions options;
    options.quality = render::Quality::fast;
    EXPECT_TRUE(io::write_png(files.back(), renderer.render(camera, options)->color).ok());
  }
  const auto codes = scanned(files);
  return static_cast<int>(
      std::ranges::count_if(stage.scene.catalog, [&](const catalog::Product& product) {
        const auto found = codes.find(product.sku);
        return found != codes.end() && found->second == product.ean;
      }));
}

// A module of the smallest symbol, 0.264 mm, covers 1.6 pixels at 0.1 m.
TEST(Reading, BarCodesAtAHandsDistance) {
  const BarStage stage = bar_stage(some_products(reads_all() ? 20 : 6));
  const ScratchFolder scratch;
  const std::filesystem::path folder = picture_folder(scratch);
  const auto renderer = render::Renderer::create(stage.scene).value();
  const std::vector<double> distances =
      reads_all() ? std::vector<double>{0.1, 0.15, 0.2, 0.3, 0.5} : std::vector<double>{0.1};
  const double count = static_cast<double>(stage.cameras.size());
  for (const double distance_m : distances) {
    const int right = bar_codes_read(stage, *renderer, distance_m, folder);
    std::printf("bar codes at %.2f m: %d of %.0f\n", distance_m, right, count);
    if (distance_m == 0.1) {
      EXPECT_GE(right, 0.8 * count);
    }
  }
}

// A white board in a room with price labels on it, 0.4 m apart, as on a shelf's edge.
struct LabelBoard {
  scene::Scene scene = empty_room(9000, 5000, 3000);
  std::vector<Vec3> middles;  // of the labels, by product

  explicit LabelBoard(const std::vector<catalog::Product>& products) {
    scene.layout.look.light_lux = 1000;
    scene.layout.look.floor = scene.layout.look.wall = scene.layout.look.ceiling = "";
    add_box_fixture(scene, {4.5F, 3, 0}, {0, 0.1F, 1}, {4, 0.1F, 1});
    for (std::size_t i = 0; i < products.size(); ++i)
      add_label(products[i], static_cast<std::uint32_t>(i));
    scene.fixtures[0].shelf_count = static_cast<std::uint32_t>(scene.shelves.size());
  }

  void add_label(const catalog::Product& product, std::uint32_t i) {
    scene::SceneShelf shelf;
    shelf.position_m = {
        -3.6F + 0.4F * static_cast<float>(i % 19), 0, 0.7F + 0.3F * static_cast<float>(i / 19)};
    shelf.width_m = 0.4F;
    scene.shelves.push_back(shelf);
    scene.catalog.push_back(product);
    scene::PriceLabel label;
    label.shelf = label.sku = i;
    label.x_m = 0.2F;
    label.price_cents = scene::price_cents(product);
    scene.price_labels.push_back(label);
    // 18 mm below the shelf and 7 mm before it is where a rail holds them.
    const auto shelf_at = scene::world_from_shelf(scene, i).position;
    middles.push_back(shelf_at + Vec3{0, -0.0068, -0.018});
  }
};

// A part of the label in the picture, by shares of its width and height, four times enlarged: what
// a reader gets that knows where the label is.
Image enlarged_part(const render::Frame& frame,
                    const render::Camera& camera,
                    Vec3 middle,
                    std::array<double, 4> part) {
  const scene::PriceLabel sizes;
  const render::Projection project(camera);
  const auto corner = [&](double u, double v) {
    return *project(middle + Vec3{(u - 0.5) * static_cast<double>(sizes.width_m),
                                  0,
                                  (0.5 - v) * static_cast<double>(sizes.height_m)});
  };
  const Vec2 low = corner(part[0], part[1]), high = corner(part[2], part[3]);
  constexpr int zoom = 4, margin = 40;
  Image image(static_cast<int>((high.x - low.x) * zoom) + 2 * margin,
              static_cast<int>((high.y - low.y) * zoom) + 2 * margin);
  // Round it the label's own ground: readers take an edge for ink.
  const std::uint8_t* ground =
      frame.color.at(static_cast<int>(high.x) - 1, static_cast<int>(low.y) + 1);
  for (std::size_t i = 0; i < image.pixels.size(); ++i)
    image.pixels[i] = ground[i % 3];
  for (int y = margin; y < image.height - margin; ++y) {
    for (int x = margin; x < image.width - margin; ++x) {
      const double u = low.x + (x - margin) / double(zoom), v = low.y + (y - margin) / double(zoom);
      const int column = static_cast<int>(u), row = static_cast<int>(v);
      for (int c = 0; c < 3; ++c) {
        const auto mixed = [&](int r) {
          return frame.color.at(column, r)[c] * (1 - (u - column)) +
                 frame.color.at(column + 1, r)[c] * (u - column);
        };
        image.at(x, y)[c] =
            static_cast<std::uint8_t>(mixed(row) * (1 - (v - row)) + mixed(row + 1) * (v - row));
      }
    }
  }
  return image;
}

std::string read_by_tesseract(const std::filesystem::path& file,
                              const std::string& layout,
                              bool digits) {
  std::vector<std::string> command{
      "tesseract", file.string(), "stdout", "--dpi", "300", "--psm", layout};
  if (digits) command.insert(command.end(), {"-c", "tessedit_char_whitelist=0123456789"});
  const std::string text = run(command).out;
  std::string found;
  std::copy_if(text.begin(), text.end(), std::back_inserter(found), [&](char c) {
    return !digits || (c >= '0' && c <= '9');
  });
  return found;
}

// Whether one of the name's words of four letters or more is in the text.
bool names(const std::string& text, const catalog::Product& product) {
  const std::string lower = lower_ascii(text);
  for (const std::string& word : split(product.name, ' ')) {
    if (word.size() >= 4 && lower.find(lower_ascii(word)) != std::string::npos) return true;
  }
  return false;
}

struct LabelReading {
  bool price = false, name = false;
};

// The euros are large, the cents raised beside them: no layout that tesseract knows, so each is
// read by itself.
LabelReading read_label(const render::Frame& frame,
                        const render::Camera& camera,
                        Vec3 middle,
                        const catalog::Product& product,
                        const std::filesystem::path& stem) {
  const auto part = [&](const char* what, std::array<double, 4> area) {
    std::filesystem::path file = stem;
    file += std::string("-") + what + ".png";
    EXPECT_TRUE(io::write_png(file, enlarged_part(frame, camera, middle, area)).ok());
    return file;
  };
  const long cents = std::lround(product.price * 100);
  const auto euros_file = part("euros", {0.58, 0.10, 0.85, 0.74}),
             cents_file = part("cents", {0.85, 0.12, 0.985, 0.45}),
             name_file = part("name", {0.02, 0.02, 0.56, 0.56});
  LabelReading reading;
  reading.price = read_by_tesseract(euros_file, "10", true) == std::to_string(cents / 100) &&
                  read_by_tesseract(cents_file, "6", true) == fmt::format("{:02}", cents % 100);
  reading.name = names(read_by_tesseract(name_file, "6", false), product);
  return reading;
}

TEST(Reading, LabelsAtArmsLength) {
  if (!reads_all()) GTEST_SKIP() << "tools/read_distances reads labels";
  std::vector<catalog::Product> products = some_products(24);
  std::erase_if(products,
                [](const catalog::Product& p) { return p.price >= 9.995; });  // one digit of euros
  products.resize(std::min<std::size_t>(products.size(), 19));                // a row of the board
  const LabelBoard board(products);
  const ScratchFolder scratch;
  const std::filesystem::path folder = picture_folder(scratch);
  const auto renderer = render::Renderer::create(board.scene).value();
  render::RenderOptions options;
  options.quality = render::Quality::fast;
  for (const double distance_m : {0.3, 0.5, 0.8}) {
    int prices = 0, named = 0;
    for (std::size_t i = 0; i < products.size(); ++i) {
      const render::Camera camera = hand_camera(products[i].sku, board.middles[i], distance_m);
      const render::Frame frame = renderer->render(camera, options).value();
      const LabelReading reading =
          read_label(frame,
                     camera,
                     board.middles[i],
                     products[i],
                     folder / fmt::format("{}-{:.1f}", products[i].sku, distance_m));
      prices += reading.price ? 1 : 0;
      named += reading.name ? 1 : 0;
    }
    std::printf("labels at %.1f m: price of %d, name of %d of %zu\n",
                distance_m,
                prices,
                named,
                products.size());
    std::fflush(stdout);
    if (distance_m == 0.3) {
      EXPECT_GE(named, static_cast<int>(products.size() * 8 / 10));
    }
  }
}

}  // namespace
}  // namespace marketgen
