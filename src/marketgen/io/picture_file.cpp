#include "io/picture_file.h"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/text.h"
#include "io/exif.h"
#include "io/file.h"
#include "io/jpeg.h"
#include "io/png.h"

namespace marketgen::io {
namespace {

std::string ending_of(const std::filesystem::path& path) {
  return lower_ascii(path.extension().string());
}

// The picture as it was seen, from one that the camera wrote down with that orientation
// (io/exif.h).
Image upright(Image image, int orientation) {
  if (orientation == 1) return image;
  const bool turned = orientation >= 5;
  Image seen(
      turned ? image.height : image.width, turned ? image.width : image.height, image.channels);
  for (int y = 0; y < seen.height; ++y) {
    for (int x = 0; x < seen.width; ++x) {
      int from_x = turned ? y : x, from_y = turned ? x : y;
      if (orientation == 2 || orientation == 3 || orientation == 7 || orientation == 8)
        from_x = image.width - 1 - from_x;
      if (orientation == 3 || orientation == 4 || orientation == 6 || orientation == 7)
        from_y = image.height - 1 - from_y;
      std::copy_n(image.at(from_x, from_y), image.channels, seen.at(x, y));
    }
  }
  return seen;
}

}  // namespace

Result<void> check_ending(const std::filesystem::path& path,
                          const std::vector<std::string_view>& endings,
                          const std::string& where) {
  const std::string ending = ending_of(path);
  if (ending.empty() || std::ranges::find(endings, ending) != endings.end()) return {};
  return Error{"usage.bad_flag",
               where,
               fmt::format("\"{}\" cannot be written as {}; give the file a name that ends in {}",
                           path.string(),
                           ending,
                           fmt::join(endings, " or "))};
}

Result<void> check_picture_ending(const std::filesystem::path& path, const std::string& where) {
  return check_ending(path, {".png", ".jpg", ".jpeg"}, where);
}

Result<void> write_picture(const std::filesystem::path& path, const Image& image) {
  MARKETGEN_CHECK(check_picture_ending(path, path.string()));
  const std::string ending = ending_of(path);
  if (ending != ".jpg" && ending != ".jpeg") return write_png(path, image);
  MARKETGEN_TRY(const std::string bytes, encode_jpeg(image));
  return write_file(path, bytes);
}

Result<Image> decoded_picture(std::string_view bytes, const std::string& where) {
  if (is_png(bytes)) return decode_png(bytes, where);
  MARKETGEN_TRY(Image image, decode_jpeg(bytes, where));
  return upright(std::move(image), jpeg_orientation(bytes));
}

Result<PictureSize> picture_size(std::string_view bytes, const std::string& where) {
  return is_png(bytes) ? png_size(bytes, where) : jpeg_size(bytes, where);
}

}  // namespace marketgen::io
