// What a photo of a shop says of it: materials, light, aisles, shelves, kind of shop; each with a
// confidence.
//
// A photo is matched against a bank of renderings of shops whose look is known
// (data/photo_bank.json, made by tools/shop_photos/make_bank.py): numbers are taken of its parts
// (photo/features.h), and the renderings that are nearest by them vote (photo/bank.h). No network,
// no weights of others.
#pragma once
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "base/fields.h"
#include "base/result.h"
#include "photo/bank.h"

namespace marketgen::photo {

// From here on a reading is used: of the bank's own photos, each read with its shop left out, at
// least 88 in 100 that were so sure were right (Attribute::sure_vote).
constexpr double sure = 0.5;

struct AttributeReading {
  std::string attribute;  // "floor", "floor_color", "lamps", ...: those of the bank
  std::string value;      // one of the attribute's classes: "wood"
  double confidence = 0;  // 0 to 1; `sure` and above is relied upon
  std::string
      material;  // floor, wall, ceiling, fixture: the material of ours that looks most like it

  static constexpr auto fields = field_list(
      field("attribute", &AttributeReading::attribute, "what is read", required()),
      field("value", &AttributeReading::value, "what it is", required()),
      field("confidence", &AttributeReading::confidence, "from 0.5 on it is used", range(0, 1)),
      field("material", &AttributeReading::material, "material that looks most like it"));
};

struct PaletteColor {
  std::string color;  // "#rrggbb", as the photo has it
  double share = 0;   // of the picture

  static constexpr auto fields =
      field_list(field("color", &PaletteColor::color, "#rrggbb", at_most_bytes(7)),
                 field("share", &PaletteColor::share, "of the picture", range(0, 1)));
};

struct PhotoReading {
  std::string file;
  std::string subject = "room";  // "room", "drawing" or "other"
  double subject_confidence = 0;
  std::vector<AttributeReading> attributes;  // in the bank's order
  std::vector<PaletteColor> palette;         // at most 6, largest first

  static constexpr auto fields = field_list(
      field("file", &PhotoReading::file, "the photo"),
      field("subject", &PhotoReading::subject, "room, drawing or other"),
      field("subject_confidence", &PhotoReading::subject_confidence, "of that", range(0, 1)),
      field("attributes", &PhotoReading::attributes, "what it says of the shop"),
      field("palette", &PhotoReading::palette, "its colours, most frequent first"));

  const AttributeReading* find(std::string_view attribute) const;
};

// PNG or JPEG of at least 64 x 64 pixels. Errors: image.bad_file, input.too_large, image.too_small.
Result<PhotoReading> read_photo_bytes(std::string_view bytes,
                                      const std::string& where,
                                      const Bank& bank);
// Errors: those of the bytes; input.not_found.
Result<PhotoReading> read_photo(const std::filesystem::path& path, const Bank& bank);

// What several photos of one shop say together: of each attribute the value for which their
// confidences add up to most.
std::vector<AttributeReading> together(const std::vector<PhotoReading>& photos);

// The material of "floor", "wall", "ceiling" or "fixture", from what is sure of its kind and of its
// colour; null when nothing is.
const AttributeReading* surface_of(const std::vector<AttributeReading>& readings,
                                   std::string_view part);

}  // namespace marketgen::photo
