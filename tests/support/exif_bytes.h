// JPEG files that say how the camera was held.
#pragma once
#include <string>

namespace marketgen {

// `jpeg` with an Exif segment behind its start; `little`: in Intel's byte order.
inline std::string with_orientation(const std::string& jpeg, int orientation, bool little) {
  const auto number = [&](unsigned value, int bytes) {
    std::string text;
    for (int i = 0; i < bytes; ++i)
      text += static_cast<char>(value >> 8U * (little ? i : bytes - 1 - i) & 0xffU);
    return text;
  };
  const auto entry = [&](unsigned tag, unsigned value) {  // one SHORT
    return number(tag, 2) + number(3, 2) + number(1, 4) + number(value, 2) + number(0, 2);
  };
  const std::string tiff = std::string(little ? "II" : "MM") + number(42, 2) + number(8, 4) +
                           number(2, 2) + entry(0x0103, 6) +
                           entry(0x0112, static_cast<unsigned>(orientation)) + number(0, 4);
  const std::string block = std::string("Exif\0\0", 6) + tiff;
  const auto length = static_cast<unsigned>(block.size() + 2);
  return jpeg.substr(0, 2) + "\xff\xe1" + static_cast<char>(length >> 8U) +
         static_cast<char>(length & 0xffU) + block + jpeg.substr(2);
}

}  // namespace marketgen
