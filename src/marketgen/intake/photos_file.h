// market-photos/1: what was read of the photos that a store was made with, photos.json of its
// folder.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "base/fields.h"
#include "photo/read_photo.h"

namespace marketgen::intake {

struct PhotosFile {
  std::string schema = "market-photos/1";
  std::vector<photo::PhotoReading> photos;  // in the order in which they were given
  std::optional<std::vector<photo::PhotoReading>> seen;

  static constexpr auto fields =
      field_list(field("schema", &PhotosFile::schema, "schema tag", constant("market-photos/1")),
                 field("photos", &PhotosFile::photos, "each with all that was read"),
                 field("seen",
                       &PhotosFile::seen,
                       "the same photos as a language model read them; absent: none did"));
};

}  // namespace marketgen::intake
