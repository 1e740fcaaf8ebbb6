// What photos of a shop give its plan.
#pragma once
#include <optional>
#include <string>

#include "catalog/rows.h"
#include "plan/plan.h"

namespace marketgen::intake {

// A value that photos show, how sure that is, and who read it: the bank of renderings (photo) or a
// language model (llm).
template <class T>
struct Photographed {
  T value;
  double confidence = 0;
  plan::Source source = plan::Source::photo;
};

// What photos show surely and neither flags nor words say (intake/photo_wishes.h).
struct PhotoWishes {
  std::optional<Photographed<std::string>> floor, wall, ceiling, fixture;  // materials
  std::optional<Photographed<catalog::LampFitting>> lamps;
  std::optional<Photographed<int>> light_kelvin;
  std::optional<Photographed<int>> levels;    // of gondolas
  std::optional<Photographed<int>> aisle_mm;  // between gondolas
  std::optional<Photographed<bool>> across;   // runs of gondolas lie along the front wall
  std::optional<Photographed<std::string>> profile;

  bool any() const {
    return floor || wall || ceiling || fixture || lamps || light_kelvin || levels || aisle_mm ||
           across || profile;
  }
};

}  // namespace marketgen::intake
