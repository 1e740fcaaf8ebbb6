// Files of a user's that rows need: kept under $MARKETGEN_CACHE by their content, and carried by
// the stores whose products show them.
//
// A kept file is called after its own digest, "<sha256>.glb", so that scenes depend on what it is
// and not on where it lay, and what was changed is told from what is whole.
#pragma once
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include "base/result.h"

namespace marketgen::catalog {

struct KeptKind {
  std::string_view what;                      // "mesh", in errors
  std::string_view folder;                    // "meshes": in the cache, and in a store
  std::span<const std::string_view> endings;  // ".glb"
  std::uint64_t max_bytes = 0;
  std::string_view fault;  // error code of a name that is none, and of a file that was changed
};

// A kept file as a row names it; `where` is the place in the row: "own-tea/mesh".
struct KeptName {
  const KeptKind* kind = nullptr;
  std::string name;
  std::string where;
};

// Keeps the bytes and returns their name. Errors: io.*.
Result<std::string> keep_bytes(const KeptKind& kind,
                               std::string_view bytes,
                               std::string_view ending);

// Whether the cache has the file, whole; whether a store's folder has one of its name.
bool is_kept(const KeptName& name);
bool is_saved(const KeptName& name, const std::filesystem::path& store);

// Errors: the kind's `fault` for a name that is none; input.not_found, with the remedy, when the
// cache no longer has it as it was.
Result<std::string> kept_bytes(const KeptName& name);

// Copies a file from the cache to a store's folder, or back, where that lacks it. Errors: the
// kind's `fault`, input.*, io.*.
Result<void> save_kept(const KeptName& name, const std::filesystem::path& store);
Result<void> restore_kept(const KeptName& name, const std::filesystem::path& store);

}  // namespace marketgen::catalog
