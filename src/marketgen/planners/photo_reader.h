// What a language model reads of photos of shops: the attributes that the bank of renderings reads
// (photo/read_photo.h), each with the model's own confidence. Who wins: intake/settled_look.h.
#pragma once
#include <string>
#include <vector>

#include "base/fields.h"
#include "base/result.h"
#include "catalog/catalog.h"
#include "llm/language_model.h"
#include "photo/bank.h"
#include "photo/read_photo.h"
#include "planners/shown_pictures.h"

namespace marketgen::planners {

// What the photo reader answers.
struct PhotoAnswer {
  struct Photo {
    int picture = 1;
    std::vector<photo::AttributeReading> attributes;

    static constexpr auto fields =
        field_list(field("picture", &Photo::picture, "its number", range(1, 1000), required()),
                   field("attributes",
                         &Photo::attributes,
                         "what it shows; what it does not show is left out",
                         required(),
                         at_most_items(40)));
  };

  std::vector<Photo> photos;

  static constexpr auto fields = field_list(
      field("photos", &PhotoAnswer::photos, "each of them once", required(), at_most_items(100)));
};

// One question for all photos; the readings are in their order. An answer that names what the bank
// and the catalogue do not have goes back once with what is wrong. Errors: llm.bad_answer; those of
// LanguageModel. Precondition: pictures are photos, and there is one.
Result<std::vector<photo::PhotoReading>> seen_by(const llm::LanguageModel& model,
                                                 const std::vector<ShownPicture>& photos,
                                                 const photo::Bank& bank,
                                                 const catalog::Catalog& catalog);

// The same from an answer that has come. Errors: llm.bad_answer.
Result<std::vector<photo::PhotoReading>> readings_of(const PhotoAnswer& answer,
                                                     const std::vector<ShownPicture>& photos,
                                                     const photo::Bank& bank,
                                                     const catalog::Catalog& catalog);

}  // namespace marketgen::planners
