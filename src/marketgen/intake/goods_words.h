// What the words of a wish name, where zone types and fixture kinds are too coarse to tell.
#pragma once
#include <initializer_list>
#include <string>
#include <string_view>

namespace marketgen::intake {

// Any of the words, as in has_word (intake/clauses.h).
bool names_any(const std::string& text, std::initializer_list<std::string_view> words);

bool names_fish(const std::string& text);
bool names_meat(const std::string& text);
// A counter that is called after its goods: "meat counter", not "serve-over counter".
bool names_counter(const std::string& text);
// "Oat milk": milk that needs no dairy.
bool names_plant_drink(const std::string& text);

}  // namespace marketgen::intake
