// Where the program, or Python's module, lies, and what belongs to it: shared files, Python
// packages.
//
// A wheel, `cmake --install` and a build folder of the source tree all hold the same code. Only the
// place of the file that this code was loaded from tells them apart.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace marketgen::io {

// The folder of the program or of Python's module marketgen._core, whichever this code is part of.
std::filesystem::path own_folder();

// Folders that may hold `data/`, `schemas/`, `fonts/` and `python/`, likeliest first: those of the
// installation, then the source tree that a build folder belongs to.
std::vector<std::filesystem::path> share_folders();

// Folders of Python packages: the one that this is installed into, then those of the source tree's
// .venv.
std::vector<std::filesystem::path> site_packages();

// The interpreter of the environment that `package_folder` is one of
// (…/lib/python3.12/site-packages); empty when there is none.
std::filesystem::path python_of(const std::filesystem::path& package_folder);

}  // namespace marketgen::io
