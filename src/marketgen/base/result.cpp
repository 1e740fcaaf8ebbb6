#include "base/result.h"

#include <cstdio>

namespace marketgen {

std::string to_string(const Error& error) {
  std::string text = "error[" + error.code + "] ";
  if (!error.where.empty()) text += error.where + ": ";
  return text + error.message;
}

void fatal(const char* message) {
  std::fprintf(stderr, "fatal: %s\n", message);
  std::abort();
}

}  // namespace marketgen
