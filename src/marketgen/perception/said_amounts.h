// Amounts in what people say.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "catalog/net_content.h"

namespace marketgen::perception {

struct SaidWords {
  std::vector<std::string> words;  // lower case, singular, without the amounts
  std::vector<catalog::NetContent> amounts;
};

// Runs of letters and of numbers, lower case and singular: "1.5% Fat" is "1.5" and "fat".
std::vector<std::string> plain_words(std::string_view text);

// Takes a text apart. Amounts of mass and volume, also of several packs ("6 x 330 ml", "six times
// half a litre", "a kilo"), and numbers of things that `counted` names ("twenty bags"). A number
// with which it begins says how many are wanted, and is left out.
SaidWords said_words(std::string_view text, const std::vector<std::string>& counted);

}  // namespace marketgen::perception
