// Reads a COCO data set back and holds it against the store: words against its planogram, masks
// against pictures of object numbers that are drawn once more, depth against where the items stand.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "base/interrupt.h"
#include "export/coco_document.h"
#include "export/coco_read.h"
#include "export/coco_truth.h"
#include "export/exporter.h"
#include "io/file.h"
#include "io/jpeg.h"
#include "io/png.h"
#include "render/picture_objects.h"
#include "render/render.h"

namespace marketgen::exporters {
namespace {

constexpr double max_off_item_share = 0.01;  // of points that the depth puts beside their item

class CocoCheck {
 public:
  CocoCheck(const scene::Scene& scene,
            const std::filesystem::path& file,
            render::Renderer& renderer)
      : scene_(scene), file_(file), renderer_(renderer), truth_(scene) {}

  Result<ExportSummary> run(const ReadCoco& coco) {
    if (coco.scene_hash != scene::scene_hash(scene_))
      return mismatch(file_.string(), "its pictures are of another store");
    MARKETGEN_CHECK(truth_.check_categories(coco, file_.string()));
    for (const ReadCocoImage& image : coco.images) {
      MARKETGEN_CHECK(check_interrupt());
      MARKETGEN_CHECK(check_picture(image, coco));
    }
    if (static_cast<double>(off_item_) > max_off_item_share * static_cast<double>(depths_))
      return mismatch(
          file_.string(),
          fmt::format("depth puts {} of {} points beside their items", off_item_, depths_));
    return summary(coco);
  }

 private:
  Result<void> check_picture(const ReadCocoImage& image, const ReadCoco& coco) {
    const std::string where = place(image);
    MARKETGEN_CHECK(check_color(image));
    MARKETGEN_TRY(const io::Png16 depth, depth_of(image));
    MARKETGEN_TRY(const std::vector<std::uint32_t> plane, numbers_of(image));
    std::map<std::uint32_t, int> shown;  // pixels of each item
    for (const std::uint32_t object : plane) {
      if (object >= render::first_product_object(scene_)) ++shown[object];
    }
    for (const ReadCocoAnnotation& read : coco.annotations.at(image.id)) {
      const std::string at = fmt::format("{}, annotation {}", where, read.id);
      const CocoKind kind = kind_of(coco.categories.at(read.category).first);
      MARKETGEN_CHECK(truth_.check(kind, read, at));
      MARKETGEN_TRY(const std::vector<std::uint32_t> pixels, mask_of(read, image, at));
      ++counts_[kind], misplaced_ += read.misplaced ? 1 : 0;
      wrong_tags_ += read.fault.empty() ? 0 : 1;
      if (read.place) fixtures_.insert(read.place->fixture);
      if (kind != CocoKind::item) continue;
      MARKETGEN_CHECK(check_item(read, pixels, image, plane, depth, at));
      const std::uint32_t object =
          render::first_product_object(scene_) + *truth_.product(read.instance);
      if (static_cast<std::size_t>(shown[object]) != pixels.size())
        return mismatch(at, "its mask lacks pixels that show \"" + read.instance + "\"");
      shown.erase(object);
      skus_.insert(read.sku);
    }
    if (shown.empty()) return {};
    const std::uint32_t missing = shown.begin()->first - render::first_product_object(scene_);
    return mismatch(where,
                    fmt::format("it has no annotation of \"{}\", which shows in {} pixels",
                                scene::product_id(scene_, missing),
                                shown.begin()->second));
  }

  static CocoKind kind_of(const std::string& category) {
    if (category == coco_gap) return CocoKind::gap;
    if (category == coco_missing_tag) return CocoKind::missing_tag;
    return category == coco_price_tag ? CocoKind::price_tag : CocoKind::item;
  }

  std::string place(const ReadCocoImage& image) const {
    return fmt::format("{}, picture {}", file_.string(), image.id);
  }

  // A file that lies beside; its name may not lead elsewhere.
  Result<std::string> beside(const ReadCocoImage& image, const std::string& name) const {
    const std::filesystem::path relative(name);
    if (relative.is_absolute() || relative.lexically_normal().string().starts_with(".."))
      return mismatch(place(image), "\"" + name + "\" does not lie beside it");
    Result<std::string> bytes = io::read_file(file_.parent_path() / relative);
    if (!bytes.ok()) return mismatch(place(image), name + ": " + bytes.error().message);
    return bytes;
  }

  Result<void> check_color(const ReadCocoImage& image) const {
    MARKETGEN_TRY(const std::string bytes, beside(image, image.file_name));
    const auto color = io::decode_jpeg(bytes, image.file_name);
    if (!color.ok()) return mismatch(place(image), color.error().message);
    if (color->width == image.width && color->height == image.height) return {};
    return mismatch(place(image), image.file_name + " is of another size");
  }

  Result<io::Png16> depth_of(const ReadCocoImage& image) const {
    MARKETGEN_TRY(const std::string bytes, beside(image, image.depth_file));
    auto depth = io::decode_png16(bytes, image.depth_file);
    if (!depth.ok()) return mismatch(place(image), depth.error().message);
    if (depth->width == image.width && depth->height == image.height) return depth;
    return mismatch(place(image), image.depth_file + " is of another size");
  }

  // What the camera sees of the store, once more.
  Result<std::vector<std::uint32_t>> numbers_of(const ReadCocoImage& image) const {
    const auto camera = render::camera_of(image.camera, place(image));
    if (!camera.ok()) return mismatch(place(image), camera.error().message);
    if (camera->width != image.width || camera->height != image.height)
      return mismatch(place(image), "its camera has another size");
    std::vector<std::uint32_t> plane(static_cast<std::size_t>(image.width) *
                                     static_cast<std::size_t>(image.height));
    const render::Shot shot{
        &renderer_, *camera, {nullptr, nullptr, plane.data(), nullptr, nullptr}};
    MARKETGEN_CHECK(render::render_batch({&shot, 1}, {.quality = render::Quality::fast}));
    return plane;
  }

  // Its box and area are those of its mask.
  static Result<std::vector<std::uint32_t>> mask_of(const ReadCocoAnnotation& read,
                                                    const ReadCocoImage& image,
                                                    const std::string& where) {
    const auto pixels =
        mask_pixels(read.counts, static_cast<std::uint32_t>(image.width * image.height));
    if (!pixels || pixels->empty()) return mismatch(where, "its mask is none of the picture");
    if (static_cast<std::size_t>(read.area) != pixels->size())
      return mismatch(
          where, fmt::format("its mask has {} pixels, its area is {}", pixels->size(), read.area));
    std::array<int, 4> around{image.width, image.height, 0, 0};
    for (const std::uint32_t pixel : *pixels) {
      const int x = static_cast<int>(pixel) / image.height,
                y = static_cast<int>(pixel) % image.height;
      around = {std::min(around[0], x),
                std::min(around[1], y),
                std::max(around[2], x + 1),
                std::max(around[3], y + 1)};
    }
    if (read.box != std::array{around[0], around[1], around[2] - around[0], around[3] - around[1]})
      return mismatch(where, "its box does not lie around its mask");
    if (read.occlusion < 0 || read.occlusion >= 1)
      return mismatch(where, fmt::format("{} is no occlusion of what shows", read.occlusion));
    return *pixels;
  }

  // Its pixels are those that show it, and their depth lies where it stands.
  Result<void> check_item(const ReadCocoAnnotation& read,
                          const std::vector<std::uint32_t>& pixels,
                          const ReadCocoImage& image,
                          const std::vector<std::uint32_t>& plane,
                          const io::Png16& depth,
                          const std::string& where) {
    const std::uint32_t product = *truth_.product(read.instance);
    const auto in_rows = [&](std::uint32_t pixel) {
      const auto height = static_cast<std::uint32_t>(image.height);
      return static_cast<std::size_t>(pixel % height) * static_cast<std::size_t>(image.width) +
             pixel / height;
    };
    for (const std::uint32_t pixel : pixels) {
      if (plane[in_rows(pixel)] != render::first_product_object(scene_) + product)
        return mismatch(where, "its mask has pixels that do not show \"" + read.instance + "\"");
    }
    const std::uint32_t sample = pixels[pixels.size() / 2];
    const Vec3 point = image.point_at(static_cast<int>(sample) / image.height,
                                      static_cast<int>(sample) % image.height,
                                      depth.pixels[in_rows(sample)] * 1e-3);
    ++depths_, off_item_ += truth_.lies_in(product, point) ? 0 : 1;
    return {};
  }

  ExportSummary summary(const ReadCoco& coco) {
    ExportSummary found;
    found.pictures = coco.images.size();
    found.products = counts_[CocoKind::item], found.gaps = counts_[CocoKind::gap];
    found.price_tags = counts_[CocoKind::price_tag], found.misplaced = misplaced_;
    found.wrong_price_tags = wrong_tags_;
    found.missing_price_tags = counts_[CocoKind::missing_tag];
    found.annotations = found.products + found.gaps + found.price_tags + found.missing_price_tags;
    found.skus = skus_.size(), found.fixtures = fixtures_.size();
    found.in_words = fmt::format(
        "{} pictures of {} fixtures: {} items of {} SKUs ({} misplaced), {} gaps, {} price tags "
        "({} wrong), {} missing ones",
        found.pictures,
        found.fixtures,
        found.products,
        found.skus,
        found.misplaced,
        found.gaps,
        found.price_tags,
        found.wrong_price_tags,
        found.missing_price_tags);
    return found;
  }

  const scene::Scene& scene_;
  const std::filesystem::path& file_;
  render::Renderer& renderer_;
  CocoTruth truth_;
  std::map<CocoKind, std::uint64_t> counts_;
  std::uint64_t misplaced_ = 0, wrong_tags_ = 0, depths_ = 0, off_item_ = 0;
  std::set<std::string> skus_, fixtures_;
};

}  // namespace

Result<ExportSummary> check_coco(const scene::Scene& scene,
                                 const std::filesystem::path& file,
                                 const ExportOptions&) {
  MARKETGEN_TRY(const ReadCoco coco, read_coco(file));
  MARKETGEN_TRY(
      const std::unique_ptr<render::Renderer> renderer,
      render::Renderer::create(scene, silent_progress(), {.print = render::PrintDetail::distant}));
  return CocoCheck(scene, file, *renderer).run(coco);
}

}  // namespace marketgen::exporters
