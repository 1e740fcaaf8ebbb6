// Rows that the stations of several tracks have.
#pragma once
#include <array>
#include <string>

#include "base/fields.h"
#include "robots/robot_row.h"

namespace marketgen::episodes {

using Pair = std::array<double, 2>;
constexpr FieldRules on_the_counter = range(-3, 3);

struct ToolChoiceRow {
  std::string slot, row;
  static constexpr auto fields =
      field_list(field("slot", &ToolChoiceRow::slot, "of the robot's row", identifier()),
                 field("row", &ToolChoiceRow::row, "of the tool", identifier()));
};

struct StationCameraRow {
  robots::Triple from_m{}, at_m{};
  double fov_deg = 60;
  int width = 640, height = 480;
  std::string source;
  static constexpr auto fields =
      field_list(field("from_m", &StationCameraRow::from_m, "where it stands", on_the_counter),
                 field("at_m", &StationCameraRow::at_m, "what it looks at", on_the_counter),
                 field("fov_deg", &StationCameraRow::fov_deg, "across the picture", range(10, 140)),
                 field("width", &StationCameraRow::width, "pixels", range(16, 4096)),
                 field("height", &StationCameraRow::height, "pixels", range(16, 4096)),
                 field("source", &StationCameraRow::source, "keys of the sources, by blanks"));
};

}  // namespace marketgen::episodes
