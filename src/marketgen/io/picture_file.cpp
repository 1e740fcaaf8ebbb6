#include "io/picture_file.h"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/text.h"
#include "io/file.h"
#include "io/jpeg.h"
#include "io/png.h"

namespace marketgen::io {
namespace {

std::string ending_of(const std::filesystem::path& path) {
  return lower_ascii(path.extension().string());
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

}  // namespace marketgen::io
