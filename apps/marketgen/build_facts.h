// What this build is: for `--version` and `doctor`, and whoever wants to make its results again.
#pragma once
#include <string>
#include <vector>

namespace marketgen::app {

struct BuildFact {
  std::string name, value;
};

// "commit 0123456789ab, GNU 12.2.0, Release build"; the commit as run.json has it.
std::string build_in_words();

// The libraries whose version may change what is made, as they are in use: physics, pictures,
// kinematics, labels and drawings.
std::vector<BuildFact> deciding_libraries();

// All of it, one fact a line. The first line is "marketgen 0.1.0".
std::string version_text();

}  // namespace marketgen::app
