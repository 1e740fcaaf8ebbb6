// Pictures by the ending of their name: PNG keeps every bit, JPEG what a person sees, nothing else
// is written.
#include "io/picture_file.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>

#include <unistd.h>

#include "io/file.h"
#include "io/jpeg.h"
#include "io/png.h"

namespace marketgen {
namespace {
namespace fs = std::filesystem;

// A smooth sky over a coloured edge: what a lossy format must keep.
Image sample() {
  Image image(97, 61);
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      std::uint8_t* p = image.at(x, y);
      p[0] = static_cast<std::uint8_t>(y < 30 ? 40 + x : 200);
      p[1] = static_cast<std::uint8_t>(y < 30 ? 90 + y : 30);
      p[2] = static_cast<std::uint8_t>(y < 30 ? 180 : 40 + x / 2);
    }
  }
  return image;
}

class PictureFile : public testing::Test {
 protected:
  PictureFile()
      : folder_(fs::temp_directory_path() / ("marketgen-picture-" + std::to_string(getpid()))) {
    fs::create_directories(folder_);
  }
  ~PictureFile() override { fs::remove_all(folder_); }
  fs::path folder_;
};

TEST_F(PictureFile, JpegNamesHoldJpegs) {
  const Image image = sample();
  for (const char* name : {"a.jpg", "a.jpeg", "a.JPG"}) {
    ASSERT_TRUE(io::write_picture(folder_ / name, image).ok()) << name;
    const std::string bytes = io::read_file(folder_ / name).value();
    EXPECT_EQ(bytes.substr(0, 3), "\xFF\xD8\xFF") << name;
    const Result<Image> back = io::decode_jpeg(bytes, name);
    ASSERT_TRUE(back.ok()) << to_string(back.error());
    ASSERT_EQ(back->pixels.size(), image.pixels.size());
    double sum = 0;
    for (std::size_t i = 0; i < image.pixels.size(); ++i)
      sum += std::abs(int{back->pixels[i]} - int{image.pixels[i]});
    EXPECT_LT(sum / static_cast<double>(image.pixels.size()), 1.5) << name;
  }
  EXPECT_EQ(io::read_file(folder_ / "a.jpg").value(), io::encode_jpeg(image).value());
}

TEST_F(PictureFile, PngNamesAndNamesWithoutEndingHoldPngs) {
  const Image image = sample();
  for (const char* name : {"a.png", "a.PNG", "a"}) {
    ASSERT_TRUE(io::write_picture(folder_ / name, image).ok()) << name;
    EXPECT_EQ(io::read_png(folder_ / name).value().pixels, image.pixels) << name;
  }
}

TEST_F(PictureFile, OtherEndingsAreRefusedAndLeaveNothing) {
  for (const char* name : {"a.gif", "a.webp", "a.png.tmp", "a.json"}) {
    const Result<void> written = io::write_picture(folder_ / name, sample());
    ASSERT_FALSE(written.ok()) << name;
    EXPECT_EQ(written.error().code, "usage.bad_flag");
    EXPECT_FALSE(fs::exists(folder_ / name));
  }
  const Result<void> refused = io::check_picture_ending("a.gif", "-o");
  EXPECT_EQ(to_string(refused.error()),
            "error[usage.bad_flag] -o: \"a.gif\" cannot be written as .gif; give the file a name "
            "that ends in .png or .jpg or .jpeg");
  EXPECT_TRUE(io::check_ending("", {".png"}, "--depth").ok());
  EXPECT_FALSE(io::check_ending("d.jpg", {".png", ".npy"}, "--depth").ok());
}

TEST_F(PictureFile, APictureThatJpegCannotHoldIsAnError) {
  EXPECT_EQ(io::encode_jpeg(Image(70'000, 1)).error().code, "image.bad_file");
  EXPECT_EQ(io::encode_jpeg(Image(4, 4, 4)).error().code, "image.bad_file");
}

TEST(Png16, EveryValueComesBackAndOtherPicturesAreRefused) {
  const std::vector<std::uint16_t> pixels{0, 1, 255, 256, 4660, 65535};
  const std::string bytes = *io::encode_png16(3, 2, pixels);
  const Result<io::Png16> read = io::decode_png16(bytes, "depth.png");
  ASSERT_TRUE(read.ok()) << to_string(read.error());
  EXPECT_EQ(read->width, 3);
  EXPECT_EQ(read->height, 2);
  EXPECT_EQ(read->pixels, pixels);
  const Result<io::Png16> color = io::decode_png16(*io::encode_png(sample()), "color.png");
  ASSERT_FALSE(color.ok());
  EXPECT_EQ(color.error().code, "image.bad_file");
  EXPECT_NE(color.error().message.find("16-bit grey"), std::string::npos);
  for (std::size_t kept = 0; kept < bytes.size() - 12; kept += 5)  // 12: the empty end chunk
    EXPECT_FALSE(io::decode_png16(bytes.substr(0, kept), "cut.png").ok()) << kept;
}

}  // namespace
}  // namespace marketgen
