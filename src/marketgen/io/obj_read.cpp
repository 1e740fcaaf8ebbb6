#include <charconv>
#include <cmath>
#include <map>
#include <optional>

#include <fmt/format.h>

#include "base/text.h"
#include "io/model_parts.h"

// parse_obj: Wavefront OBJ and the MTL library that it names.
namespace marketgen::io {
namespace {

constexpr std::size_t max_lines = 20'000'000, max_corners = 256, max_obj_materials = 256;

// The words of one line, cut at blanks.
class Line {
 public:
  explicit Line(std::string_view text) : rest_(text) {}
  std::string_view next() {
    const std::size_t start = rest_.find_first_not_of(" \t\r");
    if (start == std::string_view::npos) return {};
    const std::size_t end = std::min(rest_.find_first_of(" \t\r", start), rest_.size());
    const std::string_view word = rest_.substr(start, end - start);
    rest_.remove_prefix(end);
    return word;
  }
  // What is left, without blanks around it: names may hold blanks.
  std::string_view remainder() const { return trimmed(rest_); }

 private:
  std::string_view rest_;
};

std::optional<double> number_of(std::string_view word) {
  double value = 0;
  const auto [end, fault] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (fault != std::errc() || end != word.data() + word.size()) return std::nullopt;
  return value;
}

float unit_or(std::string_view word, float otherwise) {
  const auto value = number_of(word);
  return value && *value >= 0 && *value <= 1 ? static_cast<float>(*value) : otherwise;
}

// "7/3/2": position, UV, normal, each counted from 1, or from the end when negative; 0: none.
using Corner = std::array<std::int64_t, 3>;

std::optional<Corner> corner_of(std::string_view word) {
  Corner corner{};
  for (std::int64_t& part : corner) {
    const std::size_t end = std::min(word.find('/'), word.size());
    const std::string_view digits = word.substr(0, end);
    if (!digits.empty()) {
      const auto [at, fault] = std::from_chars(digits.data(), digits.data() + end, part);
      if (fault != std::errc() || at != digits.data() + end) return std::nullopt;
    }
    word.remove_prefix(std::min(end + 1, word.size()));
  }
  return word.empty() ? std::optional(corner) : std::nullopt;
}

class ObjReader {
 public:
  ObjReader(const std::string& source, const CompanionReader& companion)
      : source_(source), companion_(companion) {
    model_.materials.push_back({});  // of faces before any usemtl
  }

  Result<OutsideModel> read(std::string_view text) {
    std::size_t number = 0;
    while (!text.empty()) {
      const std::size_t end = std::min(text.find('\n'), text.size());
      if (++number > max_lines)
        return Error{"input.too_large", source_, "has more than 20,000,000 lines"};
      MARKETGEN_CHECK(read_line(Line(text.substr(0, end)), number));
      text.remove_prefix(std::min(end + 1, text.size()));
    }
    if (!all_normals_) make_normals(model_.mesh);
    return finished_model(std::move(model_), source_);
  }

 private:
  Error fault(std::size_t line, const std::string& what) const {
    return bad_model(fmt::format("{}:{}", source_, line), what);
  }

  Result<void> read_line(Line line, std::size_t number) {
    const std::string_view key = line.next();
    if (key == "v") return read_point(line, number, positions_);
    if (key == "vn") return read_point(line, number, normals_);
    if (key == "vt") return read_uv(line, number);
    if (key == "f") return read_face(line, number);
    if (key == "o" || key == "g") keep_name(model_, line.remainder());
    if (key == "usemtl") use_material(std::string(line.remainder()));
    if (key == "mtllib") return read_library(std::string(line.remainder()));
    return {};  // comments, smoothing groups, lines, curves
  }

  Result<void> read_point(Line& line, std::size_t number, std::vector<Vec3f>& list) {
    std::array<double, 3> values{};
    for (double& value : values) {
      const auto read = number_of(line.next());
      if (!read) return fault(number, "expected three numbers");
      value = *read;
    }
    list.push_back(to_float(Vec3{values[0], values[1], values[2]}));
    if (list.size() > 3 * max_model_triangles)
      return Error{"input.too_large", source_, "has more than 3,000,000 points"};
    return check_points({list.back()}, fmt::format("{}:{}", source_, number));
  }

  Result<void> read_uv(Line& line, std::size_t number) {
    const auto u = number_of(line.next()), v = number_of(line.next());
    if (!u || !v) return fault(number, "expected two numbers");
    uvs_.push_back({static_cast<float>(*u), static_cast<float>(1 - *v)});  // v grows upwards here
    if (uvs_.size() > 3 * max_model_triangles)
      return Error{"input.too_large", source_, "has more than 3,000,000 UVs"};
    return {};
  }

  Result<void> read_face(Line& line, std::size_t number) {
    std::vector<std::uint32_t> corners;
    for (std::string_view word = line.next(); !word.empty(); word = line.next()) {
      if (corners.size() >= max_corners) return fault(number, "a face has more than 256 corners");
      const auto corner = corner_of(word);
      if (!corner) return fault(number, "a corner is not of the form 1, 1/2, 1//3 or 1/2/3");
      MARKETGEN_TRY(const std::uint32_t vertex, vertex_of(*corner, number));
      corners.push_back(vertex);
    }
    for (std::size_t i = 1; i + 1 < corners.size(); ++i)
      model_.mesh.add_triangle(corners[0], corners[i], corners[i + 1], material_);
    if (model_.mesh.triangles.size() > max_model_triangles)
      return Error{"input.too_large",
                   source_,
                   "has more than 1,000,000 triangles; export it with fewer (1,000 to 20,000 are "
                   "right for a pack)"};
    return {};
  }

  // Row of a list by its number in a corner; -1: none was given.
  Result<std::int64_t> row_of(std::int64_t given, std::size_t count, std::size_t number) const {
    if (given == 0) return std::int64_t{-1};
    const auto rows = static_cast<std::int64_t>(count);
    const std::int64_t row = given > 0 ? given - 1 : (given < -rows ? rows : rows + given);
    if (row < rows) return row;
    return fault(number, fmt::format("a face names row {} of {}", given, count));
  }

  Result<std::uint32_t> vertex_of(const Corner& corner, std::size_t number) {
    MARKETGEN_TRY(const std::int64_t position, row_of(corner[0], positions_.size(), number));
    MARKETGEN_TRY(const std::int64_t uv, row_of(corner[1], uvs_.size(), number));
    MARKETGEN_TRY(const std::int64_t normal, row_of(corner[2], normals_.size(), number));
    if (position < 0) return fault(number, "a corner names no vertex");
    const auto [entry, is_new] = vertices_.try_emplace(
        {position, uv, normal}, static_cast<std::uint32_t>(model_.mesh.positions.size()));
    if (!is_new) return entry->second;
    all_normals_ = all_normals_ && normal >= 0;
    const auto at = [](const auto& list, std::int64_t row) {
      return row < 0 ? typename std::decay_t<decltype(list)>::value_type{}
                     : list[static_cast<std::size_t>(row)];
    };
    model_.mesh.add_vertex(at(positions_, position), at(normals_, normal), at(uvs_, uv));
    return entry->second;
  }

  void use_material(const std::string& name) {
    const auto [entry, is_new] =
        material_rows_.try_emplace(name, static_cast<std::uint16_t>(model_.materials.size()));
    if (is_new) {
      if (model_.materials.size() >= max_obj_materials) {
        material_rows_.erase(entry);
        return;
      }
      model_.materials.push_back({});
      model_.materials.back().name = name.substr(0, 80);
    }
    material_ = material_rows_[name];
  }

  Result<void> read_library(const std::string& name) {
    if (libraries_read_++ >= 8) return {};  // real files name one
    const Result<std::string> text = companion_(name);
    if (!text.ok() && text.error().code == "input.not_found") {
      model_.remarks.push_back("its material library " + quoted_name(name) + " is not there");
      return {};
    }
    if (!text.ok()) return text.error();
    std::string_view rest = *text;
    const std::uint16_t before = material_;
    while (!rest.empty()) {
      const std::size_t end = std::min(rest.find('\n'), rest.size());
      MARKETGEN_CHECK(read_material_line(Line(rest.substr(0, end))));
      rest.remove_prefix(std::min(end + 1, rest.size()));
    }
    material_ = before;
    return {};
  }

  Result<void> read_material_line(Line line) {
    const std::string_view key = line.next();
    if (key == "newmtl") use_material(std::string(line.remainder()));
    ModelMaterial& material = model_.materials[material_];
    if (key == "Kd") {
      for (float* channel : {&material.color.x, &material.color.y, &material.color.z})
        *channel = unit_or(line.next(), *channel);
    }
    if (key == "Pr") material.roughness = unit_or(line.next(), material.roughness);
    if (key == "Pm") material.metallic = unit_or(line.next(), material.metallic);
    if (key == "d") material.clear = unit_or(line.next(), 1) < 1;
    if (key == "map_Kd") return read_picture(std::string(line.remainder()), material);
    return {};
  }

  Result<void> read_picture(const std::string& name, ModelMaterial& material) {
    constexpr std::size_t max_pictures = 8;
    const auto known = pictures_.find(name);
    if (known != pictures_.end()) {
      material.picture = known->second;
      return {};
    }
    if (pictures_.size() >= max_pictures)
      return Error{"input.too_large", source_, "has more than 8 pictures"};
    const Result<std::string> bytes = companion_(name);
    if (!bytes.ok() && bytes.error().code == "input.not_found") {
      model_.remarks.push_back("its picture " + quoted_name(name) + " is not there");
      return {};
    }
    if (!bytes.ok()) return bytes.error();
    MARKETGEN_TRY(Image picture, decode_picture(*bytes, source_ + ":" + quoted_name(name)));
    model_.pictures.push_back(std::move(picture));
    material.picture = static_cast<int>(model_.pictures.size()) - 1;
    material.color = {1, 1, 1};  // the picture is the colour
    pictures_.emplace(name, material.picture);
    return {};
  }

  const std::string& source_;
  const CompanionReader& companion_;
  OutsideModel model_;
  std::vector<Vec3f> positions_, normals_;
  std::vector<Vec2f> uvs_;
  std::map<Corner, std::uint32_t> vertices_;
  std::map<std::string, std::uint16_t> material_rows_;
  std::map<std::string, int> pictures_;
  std::uint16_t material_ = 0;
  int libraries_read_ = 0;
  bool all_normals_ = true;
};

}  // namespace

Result<OutsideModel> parse_obj(std::string_view bytes,
                               const std::string& source,
                               const CompanionReader& companion) {
  return ObjReader(source, companion).read(bytes);
}

}  // namespace marketgen::io
