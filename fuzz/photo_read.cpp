// A picture from anywhere as a photo of a shop: the first two bytes are its size, the rest its
// pixels. The bank is a small one, made here: one attribute on every group of features.
#include <cmath>
#include <cstdint>
#include <cstdlib>

#include "geometry/image.h"
#include "io/png.h"
#include "photo/features.h"
#include "photo/parts.h"
#include "photo/read_photo.h"

namespace {

using namespace marketgen;

photo::PartModel model_of(std::size_t numbers) {
  photo::PartModel model;
  model.mean.assign(numbers, 0.1);
  model.scale.assign(numbers, 3);
  for (std::size_t i = 0; i < 2 * (numbers + 1); ++i)
    model.hidden.push_back(std::sin(static_cast<double>(i)));
  for (std::size_t i = 0; i < photo::part_count * 3; ++i)
    model.output.push_back(std::cos(static_cast<double>(i)));
  return model;
}

photo::Bank bank_of_two() {
  photo::Bank bank;
  bank.first_parts = model_of(photo::first_number_count());
  bank.second_parts = model_of(photo::second_number_count());
  photo::Attribute attribute;
  attribute.name = "floor";
  attribute.classes = {"stone", "wood"};
  std::size_t features = 0;
  for (const std::string_view group : photo::group_names) {
    attribute.groups.emplace_back(group);
    features += photo::feature_count(group);
  }
  attribute.mean.assign(features, 0);
  attribute.scale.assign(features, 1);
  attribute.axes.assign(features, 0.1);
  attribute.places = {0, 5};
  attribute.votes = {0, 1};
  bank.attributes = {attribute};
  return bank;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size < 3) return 0;
  static const photo::Bank bank = bank_of_two();
  constexpr int least = photo::min_side_px, more = 200;
  Image image(least + data[0] % more, least + data[1] % more, 3 + data[2] % 2);
  for (std::size_t i = 0; i < image.pixels.size(); ++i)
    image.pixels[i] = data[2 + i / 7 % (size - 2)];
  const auto read = photo::read_photo_bytes(io::encode_png(image).value(), "fuzz", bank);
  if (!read.ok()) std::abort();
  const double confidence = read->attributes.at(0).confidence;
  if (!(confidence >= 0 && confidence <= 1)) std::abort();
  return 0;
}
