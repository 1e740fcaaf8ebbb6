#include "io/model_file.h"

#include <algorithm>

#include "base/text.h"
#include "io/file.h"
#include "io/model_parts.h"

namespace marketgen::io {
namespace fs = std::filesystem;

Result<fs::path> path_within(const fs::path& folder,
                             const std::string& name,
                             const std::string& where) {
  std::error_code failed;
  const fs::path root = fs::weakly_canonical(folder.empty() ? fs::path(".") : folder, failed);
  const bool printable = name.find('\0') == std::string::npos && !name.empty();
  const fs::path target = printable ? fs::weakly_canonical(root / name, failed) : fs::path();
  const auto [end, _] = std::mismatch(root.begin(), root.end(), target.begin(), target.end());
  if (!failed && printable && end == root.end() && target != root) return target;
  return Error{"input.outside_folder",
               where,
               "names " + quoted_name(name) + ", which is not in the folder " + root.string() +
                   "; put both into one folder and name it without .. or /"};
}

Result<OutsideModel> read_model_file(const fs::path& file) {
  const std::string ending = lower_ascii(file.extension().string());
  const std::string source = file.string();
  if (ending != ".glb" && ending != ".obj") {
    return bad_model(
        source,
        ending == ".gltf"
            ? "is a glTF text file; export it as binary glTF (.glb) with its data inside"
            : "is neither .glb nor .obj; export the model as binary glTF (.glb)");
  }
  MARKETGEN_TRY(const std::string bytes, read_file(file, max_model_bytes));
  if (ending == ".glb") return parse_glb(bytes, source);
  return parse_obj(bytes, source, [&](const std::string& name) -> Result<std::string> {
    MARKETGEN_TRY(const fs::path path, path_within(file.parent_path(), name, source));
    return read_file(path, max_model_bytes);
  });
}

}  // namespace marketgen::io
