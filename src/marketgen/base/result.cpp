#include "base/result.h"

#include <cstdio>

#include "base/safe_line.h"

namespace marketgen {

std::string to_string(const Error& error) {
  constexpr std::size_t longest_where = 300, longest_message = 2000;
  std::string text = "error[" + error.code + "] ";
  if (!error.where.empty()) text += safe_line(error.where, longest_where) + ": ";
  return text + safe_line(error.message, longest_message);
}

void fatal(const char* message) {
  std::fprintf(stderr, "fatal: %s\n", message);
  std::abort();
}

}  // namespace marketgen
