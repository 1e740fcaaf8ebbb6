#include "evaluation/evaluate.h"

#include <fstream>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <sstream>

#include "base/parallel.h"
#include "io/file.h"
#include "io/json.h"

namespace marketgen {
namespace {

constexpr char results_file[] = "results.jsonl";

// By episode. A line that was cut off is one that was not finished.
Result<std::map<std::string, EpisodeResult>> finished_results(const std::filesystem::path& file) {
  std::map<std::string, EpisodeResult> finished;
  if (!std::filesystem::exists(file)) return finished;
  MARKETGEN_TRY(const std::string text, read_file(file));
  std::istringstream lines(text.substr(0, text.rfind('\n') + 1));
  for (std::string line; std::getline(lines, line);) {
    MARKETGEN_TRY(EpisodeResult result, read_json<EpisodeResult>(line, file.string()));
    finished[result.episode] = std::move(result);
  }
  return finished;
}

std::string lines_of(const std::vector<EpisodeResult>& results) {
  std::string lines;
  for (const EpisodeResult& result : results)
    lines += write_json_line(result) + "\n";
  return lines;
}

Result<std::map<std::string, EpisodeResult>> begin_folder(const EvaluationOptions& options) {
  const std::filesystem::path file = options.folder / results_file;
  if (std::filesystem::exists(file) && !options.resume)
    return Error{"store.exists",
                 file.string(),
                 "there are results already: name another folder, or go on with --resume"};
  std::error_code failed;
  std::filesystem::create_directories(options.folder, failed);
  if (failed) return Error{"io.cannot_write", options.folder.string(), failed.message()};
  MARKETGEN_TRY(auto finished, finished_results(file));
  std::vector<EpisodeResult> kept;
  for (const auto& [id, result] : finished)
    kept.push_back(result);
  MARKETGEN_CHECK(write_file(file, lines_of(kept)));
  return finished;
}

}  // namespace

Result<std::vector<EpisodeResult>> evaluate(const std::filesystem::path& data,
                                            const EpisodeFile& file,
                                            const std::vector<FrictionRow>& frictions,
                                            const EvaluationOptions& options,
                                            Progress& progress) {
  MARKETGEN_TRY(const auto finished, begin_folder(options));
  std::ofstream kept(options.folder / results_file, std::ios::app);
  std::mutex writing;
  PictureLibrary library;
  progress.begin("episodes", file.episodes.size());
  const auto made = parallel_map(file.episodes.size(), [&](std::size_t i) {
    const EpisodeSpec& spec = file.episodes[i];
    const auto before = finished.find(spec.id);
    if (before != finished.end()) {
      progress.advance();
      return std::make_shared<Result<EpisodeResult>>(before->second);
    }
    auto result = run_episode(data, spec, file.header.products, frictions, options.policy, library);
    progress.advance();
    if (result.ok()) {
      const std::scoped_lock lock(writing);
      kept << write_json_line(*result) << "\n" << std::flush;
    }
    return std::make_shared<Result<EpisodeResult>>(std::move(result));
  });
  progress.end();
  std::vector<EpisodeResult> results;
  for (const auto& result : made) {
    if (!result->ok()) return result->error();
    results.push_back(result->value());
  }
  kept.close();
  MARKETGEN_CHECK(write_file(options.folder / results_file, lines_of(results)));
  MARKETGEN_CHECK(write_file(options.folder / "summary.json", write_json(summarize(results))));
  return results;
}

}  // namespace marketgen
