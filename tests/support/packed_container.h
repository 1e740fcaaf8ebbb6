// The binary files of the viewer's server (docs/viewer.md), as a page reads them.
#pragma once
#include <gtest/gtest.h>

#include <cstring>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace marketgen {

struct Container {
  nlohmann::json head;
  std::string data;

  template <class Number>
  std::vector<Number> numbers(const std::string& name) const {
    const nlohmann::json& section = head["sections"][name];
    const std::size_t count =
        section["count"].get<std::size_t>() * section["components"].get<std::size_t>();
    std::vector<Number> values(count);
    std::memcpy(
        values.data(), data.data() + section["offset"].get<std::size_t>(), count * sizeof(Number));
    return values;
  }
  std::size_t rows(const std::string& name) const { return head["sections"][name]["count"]; }
};

inline Container container_of(const std::string& bytes) {
  EXPECT_EQ(bytes.substr(0, 4), "MGV1");
  std::uint32_t length = 0;
  std::memcpy(&length, bytes.data() + 4, sizeof length);
  EXPECT_EQ((8 + length) % 8, 0U);
  return {nlohmann::json::parse(bytes.substr(8, length)), bytes.substr(8 + length)};
}

}  // namespace marketgen
