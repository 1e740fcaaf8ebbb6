// What belongs to the program is found from the place it lies in; Python's environments from their
// folders.
#include "io/installation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>

#include "io/file.h"
#include "io/program.h"

namespace marketgen {
namespace {

namespace fs = std::filesystem;

TEST(Installation, ABuildFolderHasItsSourceTree) {
  EXPECT_EQ(io::own_folder(), fs::read_symlink("/proc/self/exe").parent_path());
  const auto folders = io::share_folders();
  EXPECT_NE(std::ranges::find(folders, fs::path(MARKETGEN_SOURCE_DIR)), folders.end());
  EXPECT_EQ(io::data_folder().value(), fs::path(MARKETGEN_SOURCE_DIR) / "data");
}

TEST(Installation, AnEnvironmentIsKnownByItsFolders) {
  const fs::path root = fs::temp_directory_path() / "marketgen-installation-test";
  fs::remove_all(root);
  const fs::path packages = root / "lib/python3.12/site-packages";
  fs::create_directories(packages);
  EXPECT_EQ(io::python_of(packages), fs::path());
  fs::create_directories(root / "bin");
  std::ofstream(root / "bin/python3") << "";
  EXPECT_EQ(io::python_of(packages), root / "bin/python3");
  std::ofstream(root / "bin/python3.12") << "";  // of several, the one whose packages they are
  EXPECT_EQ(io::python_of(packages), root / "bin/python3.12");
  fs::remove_all(root);
}

TEST(Installation, TheRunningPythonDoesTheWork) {
  const char* named = std::getenv("MARKETGEN_PYTHON");
  if (named != nullptr && *named != '\0') GTEST_SKIP() << "MARKETGEN_PYTHON names one";
  const std::string before = io::worker_python();
  io::use_python("/opt/env/bin/python");
  EXPECT_EQ(io::worker_python(), "/opt/env/bin/python");
  io::use_python("");
  EXPECT_EQ(io::worker_python(), before);
}

}  // namespace
}  // namespace marketgen
