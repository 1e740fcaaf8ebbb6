// Which of two wishes says the same as the other, or says it less tellingly.
#pragma once
#include "intake/exclusions.h"

namespace marketgen::intake {

// Two words for one wish: "a small shop, please keep it small".
bool is_same(const plan::Requirement& a, const plan::Requirement& b);

// Whether `b` says what `a` says more tellingly: "2700 K" beside "warm light", "discounter" beside
// "supermarket".
bool is_vaguer(const plan::Requirement& a, const plan::Requirement& b, const Surroundings& around);

// A word for light means what lies within a fifth of its number. True of wishes for other
// properties of light, too.
bool may_be_one_light(const plan::Requirement& a, const plan::Requirement& b);

}  // namespace marketgen::intake
