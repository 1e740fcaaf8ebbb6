// Golden hashes: tests/golden/scene_hashes.json, one entry a scene. They change when stores change
// on purpose; then
//
//   tools/refresh_golden
//
// writes the new ones (it runs the tests below with MARKETGEN_REFRESH_GOLDEN=1), and the commit
// says why they changed.
#pragma once
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

namespace marketgen {

inline void expect_golden(const std::string& name, const std::string& found) {
  const std::filesystem::path file =
      std::filesystem::path(MARKETGEN_SOURCE_DIR) / "tests/golden/scene_hashes.json";
  std::ifstream in(file);
  nlohmann::ordered_json hashes = nlohmann::ordered_json::parse(in, nullptr, false);
  if (std::getenv("MARKETGEN_REFRESH_GOLDEN") != nullptr) {
    if (hashes.is_discarded()) hashes = nlohmann::ordered_json::object();
    hashes[name] = found;
    std::ofstream(file) << hashes.dump(2) << "\n";
    return;
  }
  ASSERT_FALSE(hashes.is_discarded()) << file << " cannot be read; see tests/support/golden.h";
  EXPECT_EQ(hashes.value(name, "no entry"), found)
      << name << " changed; if that was meant, run tools/refresh_golden and say why in the commit";
}

}  // namespace marketgen
