// Picture files, PNG or JPEG by the ending of their name.
#pragma once
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "geometry/image.h"

namespace marketgen::io {

// PNG for names that end in .png or have no ending, JPEG for .jpg and .jpeg, of any case. Errors:
// usage.bad_flag for another ending, io.*.
Result<void> write_picture(const std::filesystem::path& path, const Image& image);

// Asked before the work that a file is to hold: error usage.bad_flag at `where` unless the name
// ends in one of `endings` (".png", lower case), whatever its case, or has no ending.
Result<void> check_ending(const std::filesystem::path& path,
                          const std::vector<std::string_view>& endings,
                          const std::string& where);
// The same for what write_picture() can write.
Result<void> check_picture_ending(const std::filesystem::path& path, const std::string& where);

// A PNG, or else a JPEG, which is turned as the camera was held. Errors: of decode_png() and
// decode_jpeg().
Result<Image> decoded_picture(std::string_view bytes, const std::string& where);

// The pixels of such a file as it has them, not turned; only its head is read. Errors: as above.
Result<PictureSize> picture_size(std::string_view bytes, const std::string& where);

}  // namespace marketgen::io
