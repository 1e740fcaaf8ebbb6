#include "evaluation/decision_record.h"

#include "io/file.h"
#include "io/gzip.h"
#include "io/json.h"

namespace marketgen::evaluation {

std::filesystem::path decisions_file(const std::filesystem::path& results,
                                     const std::string& episode) {
  return results / "decisions" / (episode + ".json.gz");
}

Result<EpisodeDecisions> read_decisions(const std::filesystem::path& results,
                                        const std::string& episode) {
  const std::filesystem::path file = decisions_file(results, episode);
  std::error_code failed;
  if (!std::filesystem::exists(file, failed))
    return Error{"results.no_decisions",
                 file.string(),
                 "no decisions were kept: run the episodes again with eval --record-decisions"};
  MARKETGEN_TRY(const std::string packed, io::read_file(file));
  MARKETGEN_TRY(const std::string text, io::gunzip(packed, file.string()));
  return io::read_json<EpisodeDecisions>(text, file.string());
}

}  // namespace marketgen::evaluation
