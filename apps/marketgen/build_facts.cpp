#include "build_facts.h"

#include <cairo.h>
#include <fmt/format.h>
#include <pango/pango.h>

#include <Eigen/Core>
#include <opencv2/core/version.hpp>

#include "base/build_info.h"
#include "evaluation/run_record.h"
#include "physics/settle/settle.h"
#include "render/render.h"

namespace marketgen::app {

std::string build_in_words() {
  return fmt::format(
      "commit {}, {}, {} build", evaluation::commit_of_program(), compiler_name, build_type);
}

std::vector<BuildFact> deciding_libraries() {
  return {{"MuJoCo", physics::physics_version()},
          {"Embree", render::renderer_version()},
          {"Eigen",
           fmt::format("{}.{}.{}", EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION)},
          {"OpenCV", CV_VERSION},
          {"Pango", pango_version_string()},
          {"Cairo", cairo_version_string()}};
}

std::string version_text() {
  std::string text = fmt::format("marketgen {}\n", program_version);
  text += fmt::format("{:<10} {}\n", "commit", evaluation::commit_of_program());
  text += fmt::format("{:<10} {}\n", "build", build_type);
  text += fmt::format("{:<10} {}", "compiler", compiler_name);
  for (const BuildFact& library : deciding_libraries())
    text += fmt::format("\n{:<10} {}", library.name, library.value);
  return text;
}

}  // namespace marketgen::app
