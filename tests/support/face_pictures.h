// Pictures of packs' sides as tests draw them: each pixel says where on the picture it is and which
// side it shows.
#pragma once
#include <filesystem>
#include <fstream>
#include <string>

#include "geometry/image.h"
#include "io/jpeg.h"
#include "io/png.h"

namespace marketgen {

// Red grows to the right and green downwards, both from 20 to 220; blue is the side's own.
inline Image graded_picture(int width, int height, int blue) {
  Image picture(width, height);
  const auto share = [](int at, int length) {
    return static_cast<std::uint8_t>(20 + 200 * (2 * at + 1) / (2 * length));
  };
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      picture.at(x, y)[0] = share(x, width);
      picture.at(x, y)[1] = share(y, height);
      picture.at(x, y)[2] = static_cast<std::uint8_t>(blue);
    }
  }
  return picture;
}

inline Image plain_picture(int width, int height, Rgb8 color) {
  Image picture(width, height);
  for (std::size_t i = 0; i < picture.pixels.size(); i += 3) {
    picture.pixels[i] = color.r;
    picture.pixels[i + 1] = color.g;
    picture.pixels[i + 2] = color.b;
  }
  return picture;
}

inline void write_bytes(const std::filesystem::path& file, const std::string& bytes) {
  std::filesystem::create_directories(file.parent_path());
  std::ofstream(file, std::ios::binary) << bytes;
}
inline void write_png_face(const std::filesystem::path& file, const Image& picture) {
  write_bytes(file, io::encode_png(picture).value());
}

}  // namespace marketgen
