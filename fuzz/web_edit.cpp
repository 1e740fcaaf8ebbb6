// Bodies of /edit/VERB: whatever a page sends, what is taken of it is within its limits, says the
// same when it is written and read again, and a folder's name leads nowhere else.
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "io/json.h"
#include "web/edit_asks.h"
#include "web/folder_name.h"

namespace {

using namespace marketgen;

constexpr std::size_t longest_token = 64, longest_words = 20000, longest_name = 100;

void require(bool holds) {
  if (!holds) std::abort();
}

template <class Ask>
std::optional<Ask> taken(std::string_view body) {
  const auto ask = io::read_json<Ask>(body, "request");
  if (!ask.ok()) {
    require(ask.error().where.starts_with("request"));
    return std::nullopt;
  }
  require(ask->token.size() <= longest_token);
  const std::string text = io::write_json(*ask);
  const auto again = io::read_json<Ask>(text, "request");
  require(again.ok() && io::write_json(*again) == text);
  return *ask;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view body(reinterpret_cast<const char*>(data), size);
  taken<web::EditorAsk>(body);
  if (const auto ask = taken<web::PatchesAsk>(body))
    require(ask->patches.size() <= plan::max_patches);
  if (const auto ask = taken<web::WordsAsk>(body)) require(ask->words.size() <= longest_words);
  if (const auto ask = taken<web::SaveAsk>(body)) {
    require(ask->name.size() <= longest_name);
    const std::filesystem::path stores = "/stores";
    const std::filesystem::path folder = (stores / ask->name).lexically_normal();
    if (web::check_folder_name(ask->name).ok())
      require(folder.parent_path() == stores && folder.filename() == ask->name);
  }
  return 0;
}
