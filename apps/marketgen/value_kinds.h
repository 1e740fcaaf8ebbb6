// What an option or an argument takes, by the word that its help shows for it (CLI11's type name):
// "STORE", "STYLE", "{csv,json}". Shells complete by it.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"

namespace marketgen::app {

enum class Paths { none, files, folders };

struct ValueKind {
  std::string name;                // "STYLE"
  Paths paths = Paths::none;       // whether a path may stand there
  std::vector<std::string> words;  // what else may, sorted; without blanks
};

// Every kind but choices, with the words of the program's own rows. One that ends with "@" or ":"
// is only the beginning of a value. Errors: those of data_folder() and load_catalog().
Result<std::vector<ValueKind>> value_kinds();

// The names of a choice, "{csv,json}" (also "TEXT:{csv,json}", as CLI11 shows a check); empty when
// it is none.
std::vector<std::string> choices_in(std::string_view shown);

}  // namespace marketgen::app
