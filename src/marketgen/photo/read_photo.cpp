#include "photo/read_photo.h"

#include <algorithm>

#include "photo/features.h"
#include "photo/palette.h"
#include "photo/parts.h"

namespace marketgen::photo {
namespace {

constexpr std::string_view subject_attribute = "subject", color_ending = "_color";

struct Read {
  const Attribute* attribute = nullptr;
  Vote vote;
};

std::vector<Read> votes_on(const Bank& bank, const Features& features) {
  std::vector<Read> all;
  for (const Attribute& attribute : bank.attributes)
    all.push_back({&attribute, vote_on(attribute, features.of(attribute.groups))});
  return all;
}

// Of a part's colour the materials that are of its kind, too, and of its kind those of its colour,
// as far as there are such.
void agree_on_materials(std::vector<Read>& reads) {
  for (Read& color : reads) {
    if (!color.attribute->name.ends_with(color_ending)) continue;
    const std::string part =
        color.attribute->name.substr(0, color.attribute->name.size() - color_ending.size());
    const auto kind =
        std::ranges::find_if(reads, [&](const Read& read) { return read.attribute->name == part; });
    if (kind == reads.end()) continue;
    std::vector<WeighedMaterial> both;
    const auto add = [&](const Read& from, const Read& also) {
      for (const WeighedMaterial& one : from.vote.materials)
        if (is_of_class(*also.attribute, also.vote.winner, one.material)) both.push_back(one);
    };
    add(color, *kind);
    add(*kind, color);
    if (!both.empty()) color.vote.materials = kind->vote.materials = both;
  }
}

AttributeReading reading_of(const Read& read) {
  return {read.attribute->name,
          read.attribute->classes[read.vote.winner],
          confidence_of(*read.attribute, read.vote.share),
          weightiest(read.vote.materials)};
}

PhotoReading reading_of(const Looked& photo, const std::string& file, const Bank& bank) {
  const Cells cells = cells_of(photo);
  const Features features = features_of(photo, cells, parts_of(cells, bank));
  PhotoReading reading;
  reading.file = file;
  std::vector<Read> votes = votes_on(bank, features);
  agree_on_materials(votes);
  for (const Read& vote : votes) {
    AttributeReading read = reading_of(vote);
    if (read.attribute == subject_attribute) {
      reading.subject = read.value;
      reading.subject_confidence = read.confidence;
    } else {
      reading.attributes.push_back(std::move(read));
    }
  }
  reading.palette = palette_of(photo);
  return reading;
}

const AttributeReading* find_in(const std::vector<AttributeReading>& readings,
                                std::string_view attribute) {
  const auto at = std::ranges::find(readings, attribute, &AttributeReading::attribute);
  return at != readings.end() ? &*at : nullptr;
}

// The sum of confidences in this value over all photos.
double belief_in(const std::vector<PhotoReading>& photos, const AttributeReading& reading) {
  double belief = 0;
  for (const PhotoReading& photo : photos) {
    const AttributeReading* other = photo.find(reading.attribute);
    if (other != nullptr && other->value == reading.value) belief += other->confidence;
  }
  return belief;
}

}  // namespace

const AttributeReading* PhotoReading::find(std::string_view attribute) const {
  return find_in(attributes, attribute);
}

Result<PhotoReading> read_photo_bytes(std::string_view bytes,
                                      const std::string& where,
                                      const Bank& bank) {
  MARKETGEN_TRY(const Looked photo, looked_at(bytes, where));
  return reading_of(photo, where, bank);
}

Result<PhotoReading> read_photo(const std::filesystem::path& path, const Bank& bank) {
  MARKETGEN_TRY(const Looked photo, looked_at(path));
  return reading_of(photo, path.string(), bank);
}

std::vector<AttributeReading> together(const std::vector<PhotoReading>& photos) {
  std::vector<AttributeReading> all;
  for (const PhotoReading& photo : photos) {
    for (const AttributeReading& reading : photo.attributes) {
      const auto known = std::ranges::find(all, reading.attribute, &AttributeReading::attribute);
      if (known == all.end()) {
        all.push_back(reading);
        continue;
      }
      const double belief = belief_in(photos, reading), held = belief_in(photos, *known);
      const bool surer = known->value == reading.value && reading.confidence > known->confidence;
      if (belief > held || surer) *known = reading;
    }
  }
  return all;
}

const AttributeReading* surface_of(const std::vector<AttributeReading>& readings,
                                   std::string_view part) {
  const AttributeReading* kind = find_in(readings, part);
  const AttributeReading* color = find_in(readings, std::string(part) + std::string(color_ending));
  const auto is_sure = [](const AttributeReading* reading) {
    return reading != nullptr && reading->confidence >= sure && !reading->material.empty();
  };
  if (is_sure(kind) && is_sure(color)) return kind->confidence >= color->confidence ? kind : color;
  if (is_sure(kind)) return kind;
  return is_sure(color) ? color : nullptr;
}

}  // namespace marketgen::photo
