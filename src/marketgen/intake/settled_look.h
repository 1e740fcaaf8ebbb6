// What photos show by both of their readers: the bank of renderings, and a language model where one
// looked at them.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "photo/read_photo.h"
#include "plan/plan.h"

namespace marketgen::intake {

struct SettledLook {
  std::vector<photo::AttributeReading> readings;  // one an attribute
  std::vector<std::string> by_model;              // attributes whose reading is the model's
  std::vector<std::string> disagreements;         // for a person; in the order of the readings

  plan::Source source_of(std::string_view attribute) const;  // photo or llm
};

// Each reader's photos say together what they say (photo::together). Of an attribute the bank's
// value holds where the bank is sure; the model's where the bank is not and the model is (at least
// photo::sure); the bank's, which nobody relies on, where neither is. Where both are sure of
// different values, that is a disagreement.
//
// A surface has one material. Where the bank says its colour and the model what it is, or the other
// way round, it is the model's material when the model agrees with what the bank is sure of;
// otherwise the model's word for that surface is left out, and that is a disagreement, too.
// Precondition: where the model says what a surface is, it says its colour.
SettledLook settled_look(const std::vector<photo::PhotoReading>& bank,
                         const std::vector<photo::PhotoReading>& model);

}  // namespace marketgen::intake
