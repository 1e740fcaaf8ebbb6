// An annotator that asks a vision-language model (llm/language_model.h) what an outside model is.
#pragma once
#include "assets/import/asset_annotator.h"
#include "llm/language_model.h"

namespace marketgen::assets {

// It sends the model's own pictures (at most four, at most 768 px a side), the names in its file,
// its size and colours, and the names that the catalogue has for categories, subcategories,
// materials and shapes; an answer with other names goes back once with what is wrong. The
// annotation's annotator is language_model.name. `catalog` must outlive the annotator. Errors:
// llm.bad_answer; those of LanguageModel::chat.
AssetAnnotator vlm_annotator(const catalog::Catalog& catalog, llm::LanguageModel language_model);

// `picture` with no side longer than `longest_px`, by the mean over what falls into each pixel;
// itself when it is small enough.
Image scaled_within(const Image& picture, int longest_px);

}  // namespace marketgen::assets
