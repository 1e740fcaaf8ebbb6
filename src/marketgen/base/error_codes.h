// The list of error codes and what a process that ends with one of them returns.
#pragma once
#include <string_view>
#include <vector>

namespace marketgen {

struct ErrorCodeInfo {
  std::string_view code, meaning;
};
const std::vector<ErrorCodeInfo>& error_codes();  // error_codes.inc

// 2 for bad usage or input, 3 when the work could not be finished, 130 when it was interrupted, 1
// for a failed check.
int exit_status_of(std::string_view code);

}  // namespace marketgen
