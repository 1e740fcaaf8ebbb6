#include "planners/photo_reader.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <set>

#include "llm/structured_answer.h"

namespace marketgen::planners {
namespace {

constexpr int max_photo_tokens =
    8192;  // 14 attributes of six photos, at 40 tokens each, and thoughts
constexpr std::string_view subject_attribute = "subject", shop_attribute = "shop",
                           color_ending = "_color";

constexpr std::string_view photo_instructions =
    "You look at photos of shops and say what they look like, so that a store can be built that "
    "looks like them. For each photo name the attributes that it shows, with one of the values "
    "listed and how sure you are of it, from 0 to 1: a value counts from 0.5 on, and 0.5 means "
    "that "
    "you are as often wrong as right. Leave out what a photo does not show. `material` is, for "
    "what "
    "has a list of materials, the one that looks most like it, and empty for the rest; where you "
    "say what a floor, wall, ceiling or fixture is made of, say its colour with the same material, "
    "too.";

const photo::Attribute* attribute_of(const photo::Bank& bank, std::string_view name) {
  const auto found = std::ranges::find(bank.attributes, name, &photo::Attribute::name);
  return found != bank.attributes.end() ? &*found : nullptr;
}

// What a surface is made of has this attribute for its colour; null for others.
const photo::Attribute* color_of(const photo::Bank& bank, std::string_view name) {
  return attribute_of(bank, std::string(name) + std::string(color_ending));
}

// The class of a material in the bank's photos; empty when none of them has it.
std::string_view class_of(const photo::Attribute& attribute, std::string_view material) {
  for (std::size_t i = 0; i < attribute.classes.size(); ++i) {
    if (photo::is_of_class(attribute, static_cast<int>(i), material)) return attribute.classes[i];
  }
  return {};
}

// "wood, brown: parquet-chevron, wood-oak; …"
std::string materials_text(const photo::Attribute& kind, const photo::Attribute& color) {
  std::map<std::string, std::vector<std::string_view>> by_class;
  for (const std::string_view material :
       std::set<std::string_view>(kind.materials.begin(), kind.materials.end()))
    by_class[fmt::format("{}, {}", class_of(kind, material), class_of(color, material))].push_back(
        material);
  std::vector<std::string> groups;
  for (const auto& [classes, materials] : by_class)
    groups.push_back(fmt::format("{}: {}", classes, fmt::join(materials, ", ")));
  return fmt::format("{}", fmt::join(groups, "; "));
}

std::vector<std::string_view> values_of(const photo::Attribute& attribute,
                                        const catalog::Catalog& catalog) {
  std::vector<std::string_view> values(attribute.classes.begin(), attribute.classes.end());
  if (attribute.name == shop_attribute) {  // the bank has photos of some kinds only
    values.clear();
    for (const catalog::ProfileRow& profile : catalog.profiles)
      values.push_back(profile.id);
  }
  return values;
}

std::string photo_question(const std::vector<ShownPicture>& photos,
                           const photo::Bank& bank,
                           const catalog::Catalog& catalog) {
  std::string text = words_about(photos) + "\nAttributes:\n";
  for (const photo::Attribute& attribute : bank.attributes) {
    if (attribute.name == subject_attribute) continue;
    text +=
        fmt::format("  {}: {}\n", attribute.name, fmt::join(values_of(attribute, catalog), ", "));
  }
  text += "Materials:\n";
  for (const photo::Attribute& attribute : bank.attributes) {
    if (const photo::Attribute* color = color_of(bank, attribute.name))
      text += fmt::format("  {}: {}\n", attribute.name, materials_text(attribute, *color));
  }
  text +=
      "`aisle` is how wide aisles between shelves are: narrow below 1.5 m, wide above 2.2 m. "
      "`direction` is where they lead, as seen by the photographer. `levels` counts shelves above "
      "one another. `shop` is the kind of shop.";
  return text;
}

Error bad(std::size_t photo, std::string_view attribute, std::string what) {
  return {"llm.bad_answer", fmt::format("answer:/photos/{}/{}", photo, attribute), std::move(what)};
}

// One reading against what the bank and the catalogue have.
Result<void> check_reading(const photo::AttributeReading& reading,
                           std::size_t photo,
                           const photo::Bank& bank,
                           const catalog::Catalog& catalog) {
  const photo::Attribute* attribute = attribute_of(bank, reading.attribute);
  if (attribute == nullptr || reading.attribute == subject_attribute)
    return bad(photo, reading.attribute, "is none of the attributes");
  const std::vector<std::string_view> values = values_of(*attribute, catalog);
  if (std::ranges::find(values, reading.value) == values.end())
    return bad(photo,
               reading.attribute,
               fmt::format("\"{}\" is none of: {}", reading.value, fmt::join(values, ", ")));
  if (attribute->materials.empty()) return {};
  const std::string_view shown = class_of(*attribute, reading.material);
  if (shown == reading.value) return {};
  return bad(photo,
             reading.attribute,
             shown.empty()
                 ? fmt::format("\"{}\" is none of its materials", reading.material)
                 : fmt::format("{} is {}, not {}", reading.material, shown, reading.value));
}

// Whether what is said of a surface has its colour beside it, of the same material.
Result<void> check_surfaces(const PhotoAnswer::Photo& photo,
                            std::size_t index,
                            const photo::Bank& bank) {
  for (const photo::AttributeReading& kind : photo.attributes) {
    const photo::Attribute* of_color = color_of(bank, kind.attribute);
    if (of_color == nullptr) continue;
    const auto color =
        std::ranges::find(photo.attributes, of_color->name, &photo::AttributeReading::attribute);
    if (color == photo.attributes.end() || color->material != kind.material)
      return bad(
          index, of_color->name, fmt::format("must be there, with the material {}", kind.material));
  }
  return {};
}

}  // namespace

Result<std::vector<photo::PhotoReading>> readings_of(const PhotoAnswer& answer,
                                                     const std::vector<ShownPicture>& photos,
                                                     const photo::Bank& bank,
                                                     const catalog::Catalog& catalog) {
  std::vector<photo::PhotoReading> readings(photos.size());
  for (std::size_t i = 0; i < photos.size(); ++i)
    readings[i].file = photos[i].file;
  std::set<int> told;
  for (std::size_t i = 0; i < answer.photos.size(); ++i) {
    const PhotoAnswer::Photo& photo = answer.photos[i];
    if (photo.picture > static_cast<int>(photos.size()) || !told.insert(photo.picture).second)
      return bad(i, "picture", fmt::format("{} is no picture, or comes twice", photo.picture));
    std::set<std::string_view> named;
    for (const photo::AttributeReading& reading : photo.attributes) {
      MARKETGEN_CHECK(check_reading(reading, i, bank, catalog));
      if (!named.insert(reading.attribute).second) return bad(i, reading.attribute, "comes twice");
    }
    MARKETGEN_CHECK(check_surfaces(photo, i, bank));
    std::vector<photo::AttributeReading>& read = readings[photo.picture - 1].attributes;
    read = photo.attributes;
    for (photo::AttributeReading& reading : read)
      if (attribute_of(bank, reading.attribute)->materials.empty()) reading.material.clear();
  }
  return readings;
}

Result<std::vector<photo::PhotoReading>> seen_by(const llm::LanguageModel& model,
                                                 const std::vector<ShownPicture>& photos,
                                                 const photo::Bank& bank,
                                                 const catalog::Catalog& catalog) {
  llm::ChatRequest request;
  request.system = fmt::format("{}{}", photo_instructions, pictures_are_data);
  request.turns = {
      {llm::ChatRole::user, photo_question(photos, bank, catalog), png_bytes_of(photos)}};
  request.max_tokens = max_photo_tokens;
  std::vector<photo::PhotoReading> readings;
  const std::function<Result<void>(const PhotoAnswer&)> check =
      [&](const PhotoAnswer& answer) -> Result<void> {
    MARKETGEN_TRY(readings, readings_of(answer, photos, bank, catalog));
    return {};
  };
  MARKETGEN_CHECK(llm::ask<PhotoAnswer>(model, std::move(request), check));
  return readings;
}

}  // namespace marketgen::planners
