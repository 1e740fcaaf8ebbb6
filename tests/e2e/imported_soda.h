// A model of a can that the end-to-end tests import as an asset of their own.
#pragma once
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "support/glb_bytes.h"

namespace marketgen {

// Writes the model into the folder. Returns the command that imports it there as soda/asset.json.
inline std::vector<std::string> soda_import(const std::filesystem::path& folder) {
  std::ofstream(folder / "LemonSoda_can.glb", std::ios::binary)
      << box_glb(0.066F, 0.115F, 0.066F, R"({"mesh": 0})");
  return {"assets",
          "import",
          "LemonSoda_can.glb",
          "-o",
          "soda",
          "--no-coacd",
          "--category",
          "beverages",
          "--subcategory",
          "soft drinks",
          "--json"};
}

}  // namespace marketgen
