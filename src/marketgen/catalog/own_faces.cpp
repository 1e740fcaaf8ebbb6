#include "catalog/own_faces.h"

#include <algorithm>
#include <optional>

#include <fmt/format.h>

#include "geometry/area_filter.h"
#include "io/cache_entry.h"
#include "io/file.h"
#include "io/jpeg.h"
#include "io/model_file.h"
#include "io/picture_file.h"
#include "io/png.h"

namespace marketgen::catalog {
namespace fs = std::filesystem;
namespace {

constexpr std::string_view face_endings[] = {".png", ".jpg"};
constexpr KeptKind face_kind{"picture", "faces", face_endings, max_face_bytes, "image.bad_file"};

constexpr std::uint8_t min_opaque = 128;  // of alpha: below it a pixel is see-through

bool is_opaque(const Image& image, int x, int y) {
  return image.channels < 4 || image.at(x, y)[3] >= min_opaque;
}

struct PixelRows {
  int x0, y0, x1, y1;  // the first, and one past the last
};

// What encloses every opaque pixel.
std::optional<PixelRows> opaque_box(const Image& image) {
  PixelRows box{image.width, image.height, 0, 0};
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      if (!is_opaque(image, x, y)) continue;
      box = {std::min(box.x0, x),
             std::min(box.y0, y),
             std::max(box.x1, x + 1),
             std::max(box.y1, y + 1)};
    }
  }
  if (box.x1 <= box.x0) return std::nullopt;
  return box;
}

// The box cut out. A see-through pixel takes the colour of the nearest opaque one in its row, which
// is what a pack's outline leaves beside its neck; a row without one that of the row above.
Image cut_out(const Image& image, const PixelRows& box) {
  Image cut(box.x1 - box.x0, box.y1 - box.y0);
  for (int y = 0; y < cut.height; ++y) {
    int last = -1;  // opaque column met before
    for (int x = 0; x < cut.width; ++x) {
      if (!is_opaque(image, box.x0 + x, box.y0 + y)) continue;
      const std::uint8_t* pixel = image.at(box.x0 + x, box.y0 + y);
      for (int to = last < 0 ? 0 : (last + x) / 2 + 1; to <= x; ++to)
        std::copy_n(pixel, 3, cut.at(to, y));
      for (int to = last + 1; last >= 0 && to <= (last + x) / 2; ++to)
        std::copy_n(cut.at(last, y), 3, cut.at(to, y));
      last = x;
    }
    for (int to = last + 1; last >= 0 && to < cut.width; ++to)
      std::copy_n(cut.at(last, y), 3, cut.at(to, y));
    if (last < 0) std::copy_n(cut.at(0, y - 1), 3 * cut.width, cut.at(0, y));  // never the first
  }
  return cut;
}

Image within_limit(Image image) {
  const int longest = std::max(image.width, image.height);
  if (longest <= max_face_px) return image;
  const auto side = [&](int length) {
    return static_cast<int>((std::int64_t{length} * max_face_px + longest / 2) / longest);
  };
  return area_scaled(image, side(image.width), side(image.height));
}

// The name under which the picture in `file` is kept. What was made ready before is not again.
Result<std::string> keep_face(const fs::path& file) {
  MARKETGEN_TRY(const std::string bytes, io::read_file(file, max_face_bytes));
  const fs::path entry = io::cache_folder() / "faces" / "made" / io::sha256_hex(bytes);
  constexpr std::string_view kind = "face/1";
  if (const std::optional<std::string> made = io::kept_entry(entry, kind);
      made && is_kept({&face_kind, *made, {}}))
    return *made;
  MARKETGEN_TRY(const ReadyFace face, ready_face(bytes, file.string()));
  MARKETGEN_TRY(std::string name, keep_bytes(face_kind, face.bytes, face.ending));
  (void)io::keep_entry(entry, kind, name);  // has said itself what went wrong; it costs time only
  return name;
}

}  // namespace

Result<ReadyFace> ready_face(std::string_view bytes, const std::string& where) {
  MARKETGEN_TRY(const Image image, io::decoded_picture(bytes, where));
  const std::optional<PixelRows> box = opaque_box(image);
  if (!box) return Error{"image.bad_file", where, "is see-through everywhere: it shows no pack"};
  ReadyFace face;
  face.picture = within_limit(cut_out(image, *box));
  if (std::min(face.picture.width, face.picture.height) < min_face_px)
    return Error{"image.too_small",
                 where,
                 fmt::format("the pack on it has {} x {} pixels; give a picture with at least {} a "
                             "side, of the pack alone",
                             face.picture.width,
                             face.picture.height,
                             min_face_px)};
  const bool photo = !io::is_png(bytes);
  MARKETGEN_TRY(face.bytes, photo ? io::encode_jpeg(face.picture) : io::encode_png(face.picture));
  face.ending = face_endings[photo ? 1 : 0];
  return face;
}

Result<void> keep_faces(Product& product, const fs::path& folder, const std::string& where) {
  if (!product.faces) return {};
  const FaceSlot* first = nullptr;
  for (const FaceSlot& slot : face_slots) {
    std::string& name = (*product.faces).*slot.file;
    if (name.empty()) continue;
    const std::string place = fmt::format("{}/faces/{}", where, slot.name);
    MARKETGEN_TRY(const fs::path file, io::path_within(folder, name, place));
    MARKETGEN_TRY(name, keep_face(file));
    if (first == nullptr) first = &slot;
  }
  if (first == nullptr)
    return Error{"catalog.bad_row",
                 where + "/faces",
                 "names no picture; give front, another side or wrap, or leave faces out"};
  if (product.label.primary != LabelStyle().primary) return {};
  MARKETGEN_TRY(const Image picture, kept_face(face_name(product, *first)));
  product.label.primary = border_color(picture);
  return {};
}

KeptName face_name(const Product& product, const FaceSlot& slot) {
  return {&face_kind,
          product.faces ? (*product.faces).*slot.file : std::string(),
          fmt::format("{}/faces/{}", product.sku, slot.name)};
}

std::vector<KeptName> face_names(const Product& product) {
  std::vector<KeptName> names;
  for (const FaceSlot& slot : face_slots) {
    KeptName name = face_name(product, slot);
    if (!name.name.empty()) names.push_back(std::move(name));
  }
  return names;
}

Result<Image> kept_face(const KeptName& name) {
  MARKETGEN_TRY(const std::string bytes, kept_bytes(name));
  return io::decoded_picture(bytes, name.where);
}

Result<PictureSize> kept_face_size(const KeptName& name) {
  MARKETGEN_TRY(const std::string bytes, kept_bytes(name));
  return io::picture_size(bytes, name.where);
}

std::string border_color(const Image& picture) {
  const int edge = std::max(1, std::min(picture.width, picture.height) / 100);
  std::array<std::array<int, 256>, 3> counts{};
  int pixels = 0;
  for (int y = 0; y < picture.height; ++y) {
    const bool in_edge_row = y < edge || y >= picture.height - edge;
    for (int x = 0; x < picture.width; ++x) {
      if (!in_edge_row && x == edge) x = std::max(edge, picture.width - edge);
      if (x >= picture.width) break;
      for (std::size_t c = 0; c < 3; ++c)
        ++counts[c][picture.at(x, y)[c]];
      ++pixels;
    }
  }
  const auto median = [&](std::size_t c) {
    int value = 0;
    for (int below = counts[c][0]; below * 2 < pixels; below += counts[c][++value]) {
    }
    return value;
  };
  return fmt::format("#{:02x}{:02x}{:02x}", median(0), median(1), median(2));
}

}  // namespace marketgen::catalog
