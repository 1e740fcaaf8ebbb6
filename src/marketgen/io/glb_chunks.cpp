#include "io/glb_chunks.h"

#include <cstring>

#include <fmt/format.h>

#include "base/text.h"
#include "io/glb_format.h"
#include "io/model_parts.h"

namespace marketgen::io {
namespace {

constexpr std::size_t header_bytes = 12, chunk_header_bytes = 8;
constexpr std::size_t max_json_bytes = 16U << 20;
constexpr int deepest_json = 64;

std::uint32_t uint_at(std::string_view bytes, std::size_t at) {
  std::uint32_t value = 0;
  std::memcpy(&value, bytes.data() + at, sizeof value);  // little-endian, as we are
  return value;
}

// Brackets within brackets, texts left aside.
int nesting_of(std::string_view json) {
  int depth = 0, deepest = 0;
  bool in_text = false;
  for (std::size_t i = 0; i < json.size(); ++i) {
    const char c = json[i];
    if (in_text && c == '\\')
      ++i;
    else if (c == '"')
      in_text = !in_text;
    else if (!in_text && (c == '[' || c == '{'))
      deepest = std::max(deepest, ++depth);
    else if (!in_text && (c == ']' || c == '}'))
      --depth;
  }
  return deepest;
}

Result<GlbJson> parse_json_chunk(std::string_view text, const std::string& source) {
  if (text.size() > max_json_bytes)
    return Error{"input.too_large", source, "its JSON chunk is larger than 16 MB"};
  if (nesting_of(text) > deepest_json)
    return bad_model(
        source,
        fmt::format("its JSON chunk nests more than {} deep; it is no model", deepest_json));
  GlbJson json = GlbJson::parse(text, nullptr, /*allow_exceptions=*/false);
  if (!json.is_object()) return bad_model(source, "its JSON chunk is not valid JSON");
  return json;
}

std::size_t size_of_component(std::size_t type) {
  switch (type) {
    case glb_component::int8:
    case glb_component::uint8:
      return 1;
    case glb_component::int16:
    case glb_component::uint16:
      return 2;
    case glb_component::uint32:
    case glb_component::f32:
      return 4;
    default:
      return 0;
  }
}

template <class T>
double read_as(const char* bytes) {
  T value{};
  std::memcpy(&value, bytes, sizeof value);
  return static_cast<double>(value);
}

double component_at(const char* bytes, std::size_t type) {
  switch (type) {
    case glb_component::int8:
      return read_as<std::int8_t>(bytes);
    case glb_component::uint8:
      return read_as<std::uint8_t>(bytes);
    case glb_component::int16:
      return read_as<std::int16_t>(bytes);
    case glb_component::uint16:
      return read_as<std::uint16_t>(bytes);
    case glb_component::uint32:
      return read_as<std::uint32_t>(bytes);
    default:
      return read_as<float>(bytes);
  }
}

// 3.11: what a normalised integer of this type is divided by.
double full_scale(std::size_t type) {
  switch (type) {
    case glb_component::int8:
      return 127;
    case glb_component::uint8:
      return 255;
    case glb_component::int16:
      return 32767;
    default:
      return 65535;
  }
}

// An accessor whose elements all lie in its view.
struct Elements {
  const char* first = nullptr;
  std::size_t count = 0, stride = 0, component = 0, component_bytes = 0;
  bool normalized = false;
};

Result<Elements> elements_of(const GlbChunks& glb,
                             std::size_t accessor,
                             std::size_t width,
                             std::size_t most,
                             const std::string& source) {
  MARKETGEN_TRY(const GlbJson* row, glb_row(glb, "accessors", accessor, source));
  const auto fault = [&](std::string_view what) {
    return bad_model(source, fmt::format("/accessors/{}: {}", accessor, what));
  };
  constexpr const char* names[] = {"", "SCALAR", "VEC2", "VEC3"};
  if (glb_text(*row, "type") != names[width])
    return fault(fmt::format("expected type {}", names[width]));
  if (row->contains("sparse")) return fault("is sparse, which is not read; export plain accessors");
  Elements elements;
  elements.component = glb_index(*row, "componentType").value_or(0);
  elements.component_bytes = size_of_component(elements.component);
  elements.count = glb_index(*row, "count").value_or(0);
  elements.normalized = row->contains("normalized") && (*row)["normalized"] == true;
  const auto view_index = glb_index(*row, "bufferView");
  if (elements.component_bytes == 0 || !view_index) return fault("has no data that can be read");
  if (elements.count > most) {
    return Error{"input.too_large",
                 source,
                 fmt::format("/accessors/{}: has {} elements; at most {} are read",
                             accessor,
                             elements.count,
                             with_thousands(static_cast<std::int64_t>(most)))};
  }
  MARKETGEN_TRY(const std::string_view view, glb_view(glb, *view_index, source));
  const std::size_t element_bytes = elements.component_bytes * width;
  elements.stride =
      glb_index(glb.json["bufferViews"][*view_index], "byteStride").value_or(element_bytes);
  const std::size_t offset = glb_index(*row, "byteOffset").value_or(0);
  constexpr std::size_t widest_stride = 252;  // 5.11.4
  if (elements.stride < element_bytes || elements.stride > widest_stride)
    return fault("has a stride outside its limits");
  const bool fits =
      elements.count == 0 ||
      (offset <= view.size() &&
       (elements.count - 1) * elements.stride + element_bytes <= view.size() - offset);
  if (!fits) return fault("reaches beyond its buffer view");
  elements.first = view.data() + std::min(offset, view.size());
  return elements;
}

}  // namespace

Result<GlbChunks> read_glb_chunks(std::string_view bytes, const std::string& source) {
  if (bytes.size() < header_bytes + chunk_header_bytes || uint_at(bytes, 0) != glb_magic)
    return bad_model(source, "is not a GLB file; export the model as binary glTF 2.0 (.glb)");
  if (uint_at(bytes, 4) != glb_version)
    return bad_model(source,
                     fmt::format("is glTF version {}; export version 2", uint_at(bytes, 4)));
  if (uint_at(bytes, 8) > bytes.size())
    return bad_model(source,
                     fmt::format("is cut off: {} bytes, its header says {}; copy it again",
                                 with_thousands(static_cast<std::int64_t>(bytes.size())),
                                 with_thousands(uint_at(bytes, 8))));
  GlbChunks glb;
  bool described = false;
  for (std::size_t at = header_bytes; at + chunk_header_bytes <= bytes.size();) {
    const std::size_t size = uint_at(bytes, at);
    const std::uint32_t kind = uint_at(bytes, at + 4);
    at += chunk_header_bytes;
    if (size > bytes.size() - at)
      return bad_model(source, "a chunk reaches beyond the file; it is cut off: copy it again");
    if (kind == json_chunk && !described) {
      MARKETGEN_TRY(glb.json, parse_json_chunk(bytes.substr(at, size), source));
      described = true;
    } else if (kind == bin_chunk && glb.binary.empty()) {
      glb.binary = bytes.substr(at, size);
    }
    at += size;
  }
  if (!described) return bad_model(source, "has no JSON chunk; export it again");
  return glb;
}

std::optional<std::size_t> glb_index(const GlbJson& object, const char* key) {
  if (!object.is_object()) return std::nullopt;
  const auto found = object.find(key);
  if (found == object.end() || !found->is_number_unsigned()) return std::nullopt;
  const auto value = found->get<std::uint64_t>();
  constexpr std::uint64_t largest = 0xFFFFFFFF;  // a GLB is smaller: sums and products of two fit
  if (value > largest) return std::nullopt;
  return static_cast<std::size_t>(value);
}

std::optional<double> glb_number(const GlbJson& object, const char* key) {
  if (!object.is_object()) return std::nullopt;
  const auto found = object.find(key);
  if (found == object.end() || !found->is_number()) return std::nullopt;
  return found->get<double>();
}

std::string glb_text(const GlbJson& object, const char* key) {
  if (!object.is_object()) return {};
  const auto found = object.find(key);
  return found == object.end() || !found->is_string() ? std::string() : found->get<std::string>();
}

const GlbJson& glb_object(const GlbJson& object, const char* key) {
  static const GlbJson none = GlbJson::object();
  if (!object.is_object()) return none;
  const auto found = object.find(key);
  return found == object.end() || !found->is_object() ? none : *found;
}

const GlbJson& glb_list(const GlbJson& object, const char* key) {
  static const GlbJson none = GlbJson::array();
  if (!object.is_object()) return none;
  const auto found = object.find(key);
  return found == object.end() || !found->is_array() ? none : *found;
}

std::optional<std::vector<double>> glb_numbers(const GlbJson& object,
                                               const char* key,
                                               std::size_t count) {
  const GlbJson& list = glb_list(object, key);
  if (list.size() != count) return std::nullopt;
  std::vector<double> numbers;
  for (const GlbJson& value : list) {
    if (!value.is_number()) return std::nullopt;
    numbers.push_back(value.get<double>());
  }
  return numbers;
}

Result<const GlbJson*> glb_row(const GlbChunks& glb,
                               const char* key,
                               std::size_t index,
                               const std::string& source) {
  const GlbJson& rows = glb_list(glb.json, key);
  if (index < rows.size() && rows[index].is_object()) return &rows[index];
  return bad_model(source,
                   fmt::format("/{}/{} is named but is not there; export it again", key, index));
}

Result<std::string_view> glb_view(const GlbChunks& glb,
                                  std::size_t index,
                                  const std::string& source) {
  MARKETGEN_TRY(const GlbJson* view, glb_row(glb, "bufferViews", index, source));
  const std::size_t buffer = glb_index(*view, "buffer").value_or(0);
  MARKETGEN_TRY(const GlbJson* row, glb_row(glb, "buffers", buffer, source));
  if (row->contains("uri")) {
    return Error{"input.outside_folder",
                 source,
                 fmt::format("/buffers/{} is another file, {}; a GLB must hold everything itself: "
                             "export it with its data inside",
                             buffer,
                             quoted_name(glb_text(*row, "uri")))};
  }
  const std::size_t offset = glb_index(*view, "byteOffset").value_or(0);
  const std::size_t size = glb_index(*view, "byteLength").value_or(0);
  if (buffer != 0 || offset > glb.binary.size() || size > glb.binary.size() - offset)
    return bad_model(source,
                     fmt::format("/bufferViews/{} reaches beyond the file's binary chunk", index));
  return glb.binary.substr(offset, size);
}

Result<std::vector<float>> glb_floats(const GlbChunks& glb,
                                      std::size_t accessor,
                                      std::size_t width,
                                      std::size_t most,
                                      const std::string& source) {
  MARKETGEN_TRY(const Elements elements, elements_of(glb, accessor, width, most, source));
  std::vector<float> values;
  values.reserve(elements.count * width);
  const double scale = elements.normalized && elements.component != glb_component::f32
                           ? 1 / full_scale(elements.component)
                           : 1;
  for (std::size_t i = 0; i < elements.count; ++i) {
    for (std::size_t c = 0; c < width; ++c) {
      const char* at = elements.first + i * elements.stride + c * elements.component_bytes;
      values.push_back(static_cast<float>(component_at(at, elements.component) * scale));
    }
  }
  return values;
}

Result<std::vector<std::uint32_t>> glb_indices(const GlbChunks& glb,
                                               std::size_t accessor,
                                               std::size_t most,
                                               const std::string& source) {
  MARKETGEN_TRY(const Elements elements, elements_of(glb, accessor, 1, most, source));
  if (elements.component != glb_component::uint8 && elements.component != glb_component::uint16 &&
      elements.component != glb_component::uint32)
    return bad_model(source, fmt::format("/accessors/{}: indices must be unsigned", accessor));
  std::vector<std::uint32_t> values;
  values.reserve(elements.count);
  for (std::size_t i = 0; i < elements.count; ++i) {
    const char* at = elements.first + i * elements.stride;
    values.push_back(static_cast<std::uint32_t>(component_at(at, elements.component)));
  }
  return values;
}

}  // namespace marketgen::io
