#include "perception/mask_answer.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace marketgen::perception {
namespace {

using Json = nlohmann::json;

Error bad_masks(std::string why) {
  return {"perception.bad_answer", "segmentation server", std::move(why)};
}

// COCO's packing of counts (pycocotools, rleFrString): five bits a letter, the least first, a sixth
// says that more follow; from the third on the difference to the last but one.
// Nothing when they are more than `max`, or one is larger.
std::optional<std::vector<std::int64_t>> unpacked_counts(std::string_view text, std::int64_t max) {
  constexpr int max_shift = 40;  // of counts of pixels and of their differences
  std::vector<std::int64_t> counts;
  for (std::size_t at = 0; at < text.size();) {
    std::int64_t value = 0;
    bool more = true;
    for (int shift = 0; more && at < text.size(); shift += 5) {
      if (shift > max_shift) return std::nullopt;
      const int bits = text[at++] - 48;
      value |= static_cast<std::int64_t>(bits & 0x1f) << shift;
      more = (bits & 0x20) != 0;
      if (!more && (bits & 0x10) != 0) value |= -(std::int64_t{1} << (shift + 5));
    }
    if (counts.size() > 2) value += counts[counts.size() - 2];
    if (value < 0 || value > max || std::cmp_greater(counts.size(), max)) return std::nullopt;
    counts.push_back(value);
  }
  return counts;
}

// One value after the other: rows of booleans are hundreds of megabytes as a document.
class MaskReader : public nlohmann::json_sax<Json> {
 public:
  MaskReader(int width, int height) : width_(width), height_(height) {}

  std::vector<Mask> masks;
  std::string fault;
  bool listed = false;  // whether there is a list of masks at all

  bool null() override { return value(); }
  bool boolean(bool set) override { return in_cells() ? cell(set) : value(); }
  bool number_integer(number_integer_t number) override { return whole(number); }
  bool number_unsigned(number_unsigned_t number) override {
    return whole(static_cast<number_integer_t>(
        std::min<number_unsigned_t>(number, std::numeric_limits<number_integer_t>::max())));
  }
  bool number_float(number_float_t number, const string_t&) override {
    return in_cells() ? cell(number != 0) : value();
  }
  bool string(string_t& text) override {
    if (!in_packed_counts()) return value();
    auto counts = unpacked_counts(text, width_ * height_);
    if (!counts) return fail("run lengths beyond the picture");
    counts_ = *std::move(counts);
    return true;
  }
  bool binary(binary_t&) override { return value(); }
  bool key(string_t& name) override {
    levels_.back().name = name;
    return true;
  }
  bool start_object(std::size_t) override { return begin(false); }
  bool start_array(std::size_t) override { return begin(true); }
  bool end_object() override {
    levels_.pop_back();
    if (levels_.size() == 2 && in_masks() && !finish_mask()) return false;
    return true;
  }
  bool end_array() override {
    const bool row = in_cells();
    levels_.pop_back();
    if (!row) return true;
    if (column_ != width_)
      return fail(fmt::format("a row of {} pixels in a picture {} wide", column_, width_));
    column_ = 0;
    ++row_;
    return true;
  }
  bool parse_error(std::size_t at,
                   const std::string&,
                   const nlohmann::detail::exception& what) override {
    constexpr std::size_t max_said = 200;  // it repeats what it read
    return fail(fmt::format(
        "no JSON at byte {}: {}", at, std::string_view(what.what()).substr(0, max_said)));
  }

 private:
  struct Level {
    bool list = false;
    std::string name = {};  // of the field being read
  };

  bool fail(std::string why) {
    fault = std::move(why);
    return false;
  }
  bool value() {
    if (in_cells()) return fail("a pixel that is neither true nor false");
    if (in_list_of("counts") || in_list_of("size")) return fail("a count that is no whole number");
    return true;
  }
  bool whole(number_integer_t number) {
    if (in_cells()) return cell(number != 0);
    if (in_list_of("size")) size_.push_back(number);
    if (in_list_of("counts")) counts_.push_back(number);
    if (size_.size() > 2 || std::cmp_greater(counts_.size(), width_ * height_ + 1))
      return fail("run lengths beyond the picture");
    return true;
  }

  // The document, its list of masks, one of them, its segmentation, a row of it.
  bool in_masks() const {
    return levels_.size() >= 2 && levels_[0].name == "masks" && levels_[1].list;
  }
  bool in_segmentation() const {
    return in_masks() && levels_.size() >= 4 && !levels_[2].list &&
           levels_[2].name == "segmentation";
  }
  bool in_cells() const {
    return levels_.size() == 5 && in_segmentation() && levels_[3].list && levels_[4].list;
  }
  bool in_list_of(std::string_view field) const {
    return levels_.size() == 5 && in_segmentation() && levels_[3].name == field && levels_[4].list;
  }
  bool in_packed_counts() const {
    return levels_.size() == 4 && in_segmentation() && levels_[3].name == "counts";
  }

  bool begin(bool list) {
    levels_.push_back({list});
    if (levels_.size() == 2 && in_masks()) listed = true;
    if (levels_.size() == 3 && in_masks()) mask_ = {}, counts_.clear(), size_.clear(), row_ = 0;
    return levels_.size() <= max_levels || fail("nested too deeply");
  }

  bool cell(bool set) {
    if (row_ >= height_ || column_ >= width_)
      return fail(fmt::format("a mask larger than the picture, which is {} x {}", width_, height_));
    if (set && !add(column_, row_)) return false;
    ++column_;
    return true;
  }
  bool add(std::int64_t column, std::int64_t row) {
    if (++pixels_ > max_mask_pixels) return fail("masks of too many pixels");
    mask_.pixels.push_back(static_cast<std::uint32_t>(row * width_ + column));
    return true;
  }

  bool finish_mask() {
    if (!counts_.empty() && row_ > 0) return fail("a mask in two forms");
    if (!counts_.empty() && !add_runs()) return false;
    if (counts_.empty() && row_ != 0 && row_ != height_)
      return fail(fmt::format("a mask of {} rows of a picture {} high", row_, height_));
    if (!mask_.pixels.empty()) masks.push_back(std::move(mask_));
    mask_ = {};
    return true;
  }
  bool add_runs() {
    if (size_.size() != 2 || size_[0] != height_ || size_[1] != width_)
      return fail(fmt::format("run lengths without \"size\": [{}, {}]", height_, width_));
    std::int64_t at = 0;
    const std::int64_t all = std::int64_t{width_} * height_;
    bool set = false;
    for (const std::int64_t count : counts_) {
      if (count < 0 || count > all - at) return fail("run lengths beyond the picture");
      for (std::int64_t i = set ? at : at + count; i < at + count; ++i)
        if (!add(i / height_, i % height_)) return false;
      at += count;
      set = !set;
    }
    std::ranges::sort(mask_.pixels);
    return true;
  }

  static constexpr std::size_t max_levels = 32;
  std::int64_t width_, height_;
  std::vector<Level> levels_;
  Mask mask_;
  std::vector<std::int64_t> counts_, size_;
  std::int64_t row_ = 0, column_ = 0;
  std::size_t pixels_ = 0;
};

}  // namespace

Result<std::vector<Mask>> read_masks(const std::string& answer, int width, int height) {
  MaskReader reader(width, height);
  if (!Json::sax_parse(answer, &reader)) return bad_masks(reader.fault);
  if (!reader.listed) return bad_masks("no list \"masks\"");
  return std::move(reader.masks);
}

}  // namespace marketgen::perception
