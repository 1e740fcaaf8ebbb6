// Manual pages in the man macros, made of the program's own help.
#pragma once
#include <string>
#include <vector>

#include "command_tree.h"

namespace marketgen::app {

struct ManualPage {
  std::string file;  // "marketgen-export.1"
  std::string text;
};

// marketgen(1), and one page of every command, which has its actions. The same for every build of
// the same sources: they carry no date.
std::vector<ManualPage> manual_pages(const CommandFacts& program);

}  // namespace marketgen::app
