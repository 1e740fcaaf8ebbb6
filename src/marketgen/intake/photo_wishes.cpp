#include "intake/photo_wishes.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <utility>

#include "intake/fixture_wishes.h"
#include "intake/materials.h"
#include "intake/settled_look.h"
#include "plan/style_look.h"

namespace marketgen::intake {
namespace {

using Kind = plan::RequirementKind;
using photo::AttributeReading;

struct NamedNumber {
  std::string_view name;
  int value;
};
// In the middle of what the classes of the bank stand for (tools/shop_photos).
constexpr std::array light_kelvins = {
    NamedNumber{"warm", 3000}, NamedNumber{"neutral", 4000}, NamedNumber{"cool", 5500}};
constexpr std::array aisle_widths_mm = {
    NamedNumber{"narrow", 1300}, NamedNumber{"medium", 1800}, NamedNumber{"wide", 2500}};

template <std::size_t N>
std::optional<int> number_named(const std::array<NamedNumber, N>& numbers, std::string_view name) {
  const auto found = std::ranges::find(numbers, name, &NamedNumber::name);
  return found == numbers.end() ? std::nullopt : std::optional(found->value);
}

// The name of the number that is nearest to `value`.
template <std::size_t N>
std::string_view name_near(const std::array<NamedNumber, N>& numbers, double value) {
  return std::ranges::min_element(
             numbers, {}, [&](const NamedNumber& one) { return std::abs(one.value - value); })
      ->name;
}

std::optional<int> whole_of(std::string_view text) {
  int value = 0;
  const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), value);
  return fault == std::errc{} && end == text.data() + text.size() ? std::optional(value)
                                                                  : std::nullopt;
}

const std::string& material_of(const plan::Look& look, std::string_view part) {
  if (part == "floor") return look.floor;
  if (part == "wall") return look.wall;
  if (part == "ceiling") return look.ceiling;
  return look.fixture;
}

// Whether a number may be what a wish asks for.
bool allows(const plan::Requirement& wish, double value) {
  if (wish.comparison == plan::Comparison::at_least) return value >= wish.value;
  if (wish.comparison == plan::Comparison::at_most) return value <= wish.value;
  return value == wish.value;
}

// What somebody said of a thing that photos show, too.
struct SaidOfPhotos {
  std::string text;
  std::string_view who;  // wins over a photo
  bool same = false;     // as the photos have it
};

constexpr std::string_view flag_wins = "a flag wins over a photo";
constexpr std::string_view words_win = "words win over a photo";
constexpr std::string_view style_wins = "a style that was asked for wins over a photo";

// The style whose look was asked for.
struct SaidStyle {
  std::string text;
  plan::Look look;
};

class PhotoReader {
 public:
  PhotoReader(const Brief& brief, const catalog::Catalog& catalog, Understanding& found)
      : brief_(brief),
        catalog_(catalog),
        found_(found),
        wishes_(found.photographed),
        look_(settled_look(brief.photos, brief.seen)),
        readings_(look_.readings),
        skin_(skin_of()),
        style_(style_of()) {}

  void run() {
    read_material("floor", wishes_.floor);
    read_material("wall", wishes_.wall);
    read_material("ceiling", wishes_.ceiling);
    read_material("fixture", wishes_.fixture);
    read_lamps();
    read_light();
    read_profile();
    read_levels();
    read_aisle();
    read_direction();
  }

 private:
  const AttributeReading* sure_reading(std::string_view attribute) const {
    const auto reading = std::ranges::find(readings_, attribute, &AttributeReading::attribute);
    const bool sure = reading != readings_.end() && reading->confidence >= photo::sure;
    return sure ? &*reading : nullptr;
  }

  // The photo that shows it most surely.
  std::string file_of(const AttributeReading& reading) const {
    const bool seen = look_.source_of(reading.attribute) == plan::Source::llm;
    const std::vector<photo::PhotoReading>& photos = seen ? brief_.seen : brief_.photos;
    const photo::PhotoReading* best = &photos.front();
    double most = -1;
    for (const photo::PhotoReading& photo : photos) {
      const AttributeReading* own = photo.find(reading.attribute);
      if (own == nullptr || own->value != reading.value || own->confidence <= most) continue;
      best = &photo;
      most = own->confidence;
    }
    return best->file;
  }

  // The photos' value becomes a wish, unless somebody said something.
  template <class T>
  void settle(const AttributeReading& reading,
              std::optional<Photographed<T>>& wish,
              T value,
              const std::optional<SaidOfPhotos>& said) {
    if (!said) {
      wish =
          Photographed<T>{std::move(value), reading.confidence, look_.source_of(reading.attribute)};
    } else if (!said->same) {
      found_.conflicts.push_back(
          {reading.attribute,
           said->text,
           fmt::format("{}: {} {}", file_of(reading), reading.attribute, reading.value),
           std::string(said->who)});
    }
  }

  // ---- Looks ----

  std::optional<SaidStyle> style_named(const std::string& name, std::string text) const {
    const catalog::StyleRow* row = catalog_.style(name);
    return row != nullptr ? std::optional(SaidStyle{std::move(text), plan::look_of(*row)})
                          : std::nullopt;
  }

  std::optional<SaidStyle> skin_of() const {
    return brief_.skin ? style_named(*brief_.skin, "--skin " + *brief_.skin) : std::nullopt;
  }

  std::optional<SaidStyle> style_of() const {
    if (brief_.style) return style_named(*brief_.style, "--style " + *brief_.style);
    const plan::Requirement* wish = found_.find(Kind::style);
    return wish != nullptr ? style_named(wish->object, wish->text) : std::nullopt;
  }

  // What the style that was asked for says of a part of the look; `wish`: what words say of that
  // part alone, or null. A skin beats words, words beat a style.
  template <class OfLook, class OfWish>
  std::optional<SaidOfPhotos> said_of_look(const plan::Requirement* wish,
                                           const OfLook& look_agrees,
                                           const OfWish& wish_agrees) const {
    if (skin_) return SaidOfPhotos{skin_->text, flag_wins, look_agrees(skin_->look)};
    if (wish != nullptr) return SaidOfPhotos{wish->text, words_win, wish_agrees(*wish)};
    if (style_) return SaidOfPhotos{style_->text, style_wins, look_agrees(style_->look)};
    return std::nullopt;
  }

  // Oak planks and walnut planks are both the wood that a photo shows; where it is sure of the
  // colour alone, what has that colour is like it.
  bool is_like(const std::string& material, const AttributeReading& reading) const {
    const catalog::MaterialRow* said = catalog_.material(material);
    const catalog::MaterialRow* shown = catalog_.material(reading.material);
    const std::string_view kind =
        std::string_view(reading.value).substr(0, reading.value.find_last_not_of('s') + 1);
    if (said == nullptr || shown == nullptr) return false;
    if (reading.attribute.ends_with("_color"))
      return color_distance(said->color, shown->color) <= same_color;
    return said->pattern == shown->pattern || said->id.starts_with(kind);
  }

  void read_material(std::string_view part, std::optional<Photographed<std::string>>& wish) {
    const AttributeReading* reading = photo::surface_of(readings_, part);
    if (reading == nullptr || catalog_.material(reading->material) == nullptr) return;
    const plan::Requirement* worded = found_.find(Kind::material, part);
    if (worded == nullptr) worded = found_.find(Kind::color, part);
    settle(*reading,
           wish,
           reading->material,
           said_of_look(
               worded,
               [&](const plan::Look& look) { return is_like(material_of(look, part), *reading); },
               [&](const plan::Requirement& said) {
                 return said.kind == Kind::material && is_like(said.object, *reading);
               }));
  }

  void read_lamps() {
    const AttributeReading* reading = sure_reading("lamps");
    const auto lamps =
        reading != nullptr ? value_named<catalog::LampFitting>(reading->value) : std::nullopt;
    if (!lamps) return;
    const auto agrees = [&](const plan::Look& look) {
      return look.lamps.value_or(catalog::LampFitting::panel) == *lamps;
    };
    settle(*reading, wishes_.lamps, *lamps, said_of_look(nullptr, agrees, [](const auto&) {
      return true;
    }));
  }

  void read_light() {
    const AttributeReading* reading = sure_reading("light");
    const auto kelvin =
        reading != nullptr ? number_named(light_kelvins, reading->value) : std::nullopt;
    if (!kelvin) return;
    const auto is_so = [&](double said) {
      return name_near(light_kelvins, said) == reading->value;
    };
    settle(*reading,
           wishes_.light_kelvin,
           *kelvin,
           said_of_look(
               found_.find(Kind::light, "light_kelvin"),
               [&](const plan::Look& look) { return is_so(look.light_kelvin); },
               [&](const plan::Requirement& wish) { return is_so(wish.value); }));
  }

  // ---- Shops and shelves ----

  void read_profile() {
    const AttributeReading* reading = sure_reading("shop");
    if (reading == nullptr || catalog_.profile(reading->value) == nullptr) return;
    settle(*reading, wishes_.profile, reading->value, said_profile(reading->value));
  }

  std::optional<SaidOfPhotos> said_profile(const std::string& shown) const {
    if (brief_.profile)
      return SaidOfPhotos{"--profile " + *brief_.profile, flag_wins, *brief_.profile == shown};
    if (const plan::Requirement* wish = found_.find(Kind::profile))
      return SaidOfPhotos{wish->text, words_win, wish->object == shown};
    // Such a shop has a profile of its own; that photos show another kind is no contradiction.
    if (wants_no_tills(found_)) return SaidOfPhotos{"", words_win, true};
    return std::nullopt;
  }

  void read_levels() {
    const AttributeReading* reading = sure_reading("levels");
    const auto levels = reading != nullptr ? whole_of(reading->value) : std::nullopt;
    if (!levels) return;
    std::optional<SaidOfPhotos> said;
    if (const plan::Requirement* wish = found_.find(Kind::levels, ""))
      said = SaidOfPhotos{wish->text, words_win, allows(*wish, *levels)};
    settle(*reading, wishes_.levels, *levels, said);
  }

  void read_aisle() {
    const AttributeReading* reading = sure_reading("aisle");
    const auto width =
        reading != nullptr ? number_named(aisle_widths_mm, reading->value) : std::nullopt;
    if (width) settle(*reading, wishes_.aisle_mm, *width, said_aisle(*reading, *width));
  }

  // So many aisles on so large a floor are as wide as they can be.
  std::optional<SaidOfPhotos> said_aisle(const AttributeReading& reading, int width_mm) const {
    if (const plan::Requirement* wish = found_.find(Kind::aisle_width)) {
      const bool same = wish->comparison == plan::Comparison::equal
                            ? name_near(aisle_widths_mm, wish->value) == reading.value
                            : allows(*wish, width_mm);
      return SaidOfPhotos{wish->text, words_win, same};
    }
    const plan::Requirement* count = found_.find(Kind::aisle_count);
    return count != nullptr ? std::optional(SaidOfPhotos{count->text, words_win, true})
                            : std::nullopt;
  }

  // Aisles that are counted lead away from the front: turned ones would be others.
  void read_direction() {
    const AttributeReading* reading = sure_reading("direction");
    if (reading == nullptr) return;
    const bool across = reading->value == "across";
    std::optional<SaidOfPhotos> said;
    if (const plan::Requirement* count = found_.find(Kind::aisle_count))
      said = SaidOfPhotos{count->text, words_win, !across};
    settle(*reading, wishes_.across, across, said);
  }

  const Brief& brief_;
  const catalog::Catalog& catalog_;
  Understanding& found_;
  PhotoWishes& wishes_;
  const SettledLook look_;
  const std::vector<AttributeReading>& readings_;
  std::optional<SaidStyle> skin_, style_;
};

}  // namespace

void apply_photos(const Brief& brief, const catalog::Catalog& catalog, Understanding& found) {
  found.photographed = {};
  if (!brief.photos.empty() || !brief.seen.empty()) PhotoReader(brief, catalog, found).run();
}

std::string not_sure_of(const photo::PhotoReading& photo) {
  std::string names;
  for (const AttributeReading& reading : photo.attributes) {
    if (reading.confidence >= photo::sure) continue;
    names += (names.empty() ? "" : ", ") + reading.attribute;
  }
  return names;
}

std::string words_of(const photo::PhotoReading& photo) {
  std::string words;
  for (const AttributeReading& reading : photo.attributes) {
    if (reading.confidence < photo::sure) continue;
    words += fmt::format("{}{} {} {:.2f}",
                         words.empty() ? "" : ", ",
                         reading.attribute,
                         reading.value,
                         reading.confidence);
  }
  if (words.empty()) words = "nothing sure";
  const std::string doubtful = not_sure_of(photo);
  return doubtful.empty() ? words : fmt::format("{} (not sure: {})", words, doubtful);
}

}  // namespace marketgen::intake
