#include "base/error_codes.h"

namespace marketgen {

const std::vector<ErrorCodeInfo>& error_codes() {
  static const std::vector<ErrorCodeInfo> codes = {
#define ERROR_CODE(code, meaning) {code, meaning},
#include "base/error_codes.inc"
#undef ERROR_CODE
  };
  return codes;
}

int exit_status_of(std::string_view code) {
  if (code == "internal.interrupted") return 130;
  if (code == "layout.violation" || code == "store.changed" || code == "export.mismatch" ||
      code == "brief.contradiction")
    return 1;
  for (const std::string_view unfinished : {"net.unreachable",
                                            "net.timeout",
                                            "net.too_large",
                                            "net.redirected",
                                            "llm.refused",
                                            "llm.bad_answer"}) {
    if (code == unfinished) return 3;
  }
  for (const std::string_view family : {"io.", "internal.", "physics.", "program."}) {
    if (code.starts_with(family)) return 3;
  }
  return 2;
}

}  // namespace marketgen
