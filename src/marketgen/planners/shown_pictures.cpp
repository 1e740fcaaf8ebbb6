#include "planners/shown_pictures.h"

#include <fmt/format.h>

#include <algorithm>

#include "drawing/shrunk_png.h"
#include "io/file.h"

namespace marketgen::planners {
namespace {

constexpr std::uint64_t max_picture_bytes = 256U << 20;

Result<ShownPicture> shown(const std::string& file, PictureKind kind) {
  MARKETGEN_TRY(const std::string bytes, io::read_file(file, max_picture_bytes));
  MARKETGEN_TRY(drawing::ShrunkPng png, drawing::shrunk_png(bytes, file, shown_picture_px));
  return ShownPicture{file, kind, std::move(png.bytes), png.width, png.height};
}

PictureKind kind_of(const intake::Brief& brief, const std::string& file) {
  const auto photo = std::ranges::find(brief.photos, file, &photo::PhotoReading::file);
  return photo == brief.photos.end() ? PictureKind::drawing : PictureKind::photo;
}

// Numbers of pictures: "Picture 1 is", "Pictures 2 to 4 are".
std::string numbered(std::size_t first, std::size_t count) {
  return count == 1 ? fmt::format("Picture {} is", first)
                    : fmt::format("Pictures {} to {} are", first, first + count - 1);
}

}  // namespace

ShownPictures shown_pictures(const intake::Brief& brief) {
  std::vector<std::string> files = brief.image_files;
  std::ranges::stable_partition(
      files, [&](const std::string& file) { return kind_of(brief, file) == PictureKind::drawing; });
  ShownPictures all;
  for (const std::string& file : files) {
    if (all.pictures.size() == max_shown_pictures) {
      all.left_out.push_back(fmt::format(
          "{}: a language model is shown {} pictures at most", file, max_shown_pictures));
      continue;
    }
    Result<ShownPicture> picture = shown(file, kind_of(brief, file));
    if (picture.ok())
      all.pictures.push_back(std::move(*picture));
    else
      all.left_out.push_back(fmt::format(
          "{}: is not shown to the language model: {}", file, to_string(picture.error())));
  }
  return all;
}

std::vector<ShownPicture> photos_of(const std::vector<ShownPicture>& pictures) {
  std::vector<ShownPicture> photos;
  std::ranges::copy_if(pictures, std::back_inserter(photos), [](const ShownPicture& picture) {
    return picture.kind == PictureKind::photo;
  });
  return photos;
}

std::string words_about(const std::vector<ShownPicture>& pictures) {
  const std::size_t photos = photos_of(pictures).size(), drawings = pictures.size() - photos;
  std::string text;
  if (drawings > 0)
    text += numbered(1, drawings) + " the customer's drawing of zones, seen from above. ";
  if (photos > 0)
    text += numbered(drawings + 1, photos) +
            (photos == 1 ? " a photo of a shop" : " photos of shops") +
            " that the store is to look like. ";
  return text;
}

std::vector<std::string> png_bytes_of(const std::vector<ShownPicture>& pictures) {
  std::vector<std::string> bytes;
  for (const ShownPicture& picture : pictures)
    bytes.push_back(picture.png);
  return bytes;
}

}  // namespace marketgen::planners
