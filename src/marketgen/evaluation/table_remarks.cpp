#include "evaluation/table_remarks.h"

#include <set>
#include <sstream>

#include <fmt/format.h>

namespace marketgen::evaluation {

std::string no_floor_remark() {
  return "No blind floor is among them: what chance scores here is not known; run random, stop or "
         "highest on the same episodes.";
}

std::string realism_remark(std::string_view realism) {
  if (realism == ranking_realism) return "";
  return fmt::format("Rankings use realism {}; these runs are of {}.", ranking_realism, realism);
}

std::vector<std::string> table_remarks(bool has_floor, std::string_view realism) {
  std::vector<std::string> remarks;
  if (!has_floor) remarks.push_back(no_floor_remark());
  if (const std::string remark = realism_remark(realism); !remark.empty())
    remarks.push_back(remark);
  return remarks;
}

std::vector<robots::SourceRow> cited_sources(const std::vector<robots::SourceRow>& sources,
                                             const std::vector<std::string>& keys) {
  std::set<std::string> cited;
  for (const std::string& of_row : keys) {
    std::istringstream words(of_row);
    for (std::string key; words >> key;)
      cited.insert(key);
  }
  std::vector<robots::SourceRow> found;
  for (const robots::SourceRow& source : sources)
    if (cited.contains(source.key)) found.push_back(source);
  return found;
}

}  // namespace marketgen::evaluation
