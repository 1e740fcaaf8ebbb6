// Chinese characters.
#pragma once
#include <string>
#include <string_view>

namespace marketgen::intake {

// Whether the Unicode code point is a character of Chinese script (kana and hangul are letters).
bool is_han(int code);

// One character as simplified Chinese writes it, so that 貨櫃 and 货柜 are one word; itself when
// the two scripts agree. Precondition: valid UTF-8.
std::string simplified(std::string_view character);

}  // namespace marketgen::intake
