#include <cmath>
#include <cstring>

#include <flatbuffers/flatbuffers.h>
#include <fmt/format.h>

#include "base/text.h"
#include "io/flatbuffer.h"
#include "io/flatbuffer_layout.h"

namespace marketgen::io {
namespace {

using flatbuffers::uoffset_t;
using flatbuffers::voffset_t;

constexpr std::size_t prefix_bytes = sizeof(uoffset_t);

// Verifies and copies in one walk. Every pointer is checked before it is read.
class Decoder {
 public:
  Decoder(std::span<const std::byte> bytes, const std::string& source)
      : start_(reinterpret_cast<const std::uint8_t*>(bytes.data())),
        verifier_(start_, bytes.size(), 64, 10'000'000),
        source_(source),
        budget_(bytes.size() * 16 + (std::size_t{64} << 20)) {}

  Result<void> decode(const TypeInfo& type, void* object) {
    const std::uint8_t* at = start_ + prefix_bytes;
    const uoffset_t offset = verifier_.VerifyOffset(prefix_bytes);
    if (offset == 0) return corrupt("root");
    return read_table(type, at + offset, object, "");
  }

 private:
  Error corrupt(const std::string& path) const {
    return {
        "scene.corrupt",
        source_,
        fmt::format("fails verification at \"{}\"; restore the file or generate the store again",
                    path)};
  }

  // False when the file would unfold into far more memory than its size explains (shared offsets).
  bool spend(std::size_t bytes) {
    if (bytes > budget_) return false;
    budget_ -= bytes;
    return true;
  }

  Result<void> read_table(const TypeInfo& type,
                          const std::uint8_t* at,
                          void* object,
                          const std::string& path) {
    if (!spend(type.size) || !verifier_.VerifyTableStart(at)) return corrupt(path);
    const auto* table = reinterpret_cast<const flatbuffers::Table*>(at);
    for (std::size_t i = 0; i < type.fields.size(); ++i) {
      const FieldInfo& f = type.fields[i];
      const voffset_t offset =
          table->GetOptionalFieldOffset(flatbuffers::FieldIndexToOffset(static_cast<voffset_t>(i)));
      const std::string field_path = path + "/" + std::string(f.name);
      if (offset == 0) {
        if (f.type().kind != TypeKind::optional) return corrupt(field_path);
        f.type().resize(f.in(object), 0);
        continue;
      }
      MARKETGEN_CHECK(read_field(f.type(), f.rules, at, offset, f.in(object), field_path));
    }
    return verifier_.EndTable() ? Result<void>() : Result<void>(corrupt(path));
  }

  Result<void> read_field(const TypeInfo& type,
                          const FieldRules& rules,
                          const std::uint8_t* table,
                          voffset_t offset,
                          void* out,
                          const std::string& path) {
    if (type.kind == TypeKind::optional) {
      type.resize(out, 1);
      return read_field(type.element(), rules, table, offset, type.at(out, 0), path);
    }
    if (flat::is_inline(type)) {
      if (!verifier_.Verify(static_cast<std::size_t>(table + offset - start_), type.size))
        return corrupt(path);
      return read_plain(type, rules, table + offset, out, path);
    }
    const uoffset_t step = verifier_.VerifyOffset(table, offset);
    if (step == 0) return corrupt(path);
    return read_outlined(type, rules, table + offset + step, out, path);
  }

  Result<void> read_outlined(const TypeInfo& type,
                             const FieldRules& rules,
                             const std::uint8_t* at,
                             void* out,
                             const std::string& path) {
    if (type.kind == TypeKind::string)
      return read_string(at, *static_cast<std::string*>(out), path);
    if (type.kind == TypeKind::array) return read_vector(type, rules, at, out, path);
    return read_table(type, at, out, path);
  }

  Result<void> read_string(const std::uint8_t* at, std::string& out, const std::string& path) {
    const auto* text = reinterpret_cast<const flatbuffers::String*>(at);
    if (!verifier_.VerifyString(text) || !spend(text->size())) return corrupt(path);
    out.assign(text->c_str(), text->size());
    return is_utf8(out) ? Result<void>() : Result<void>(corrupt(path));
  }

  Result<void> read_vector(const TypeInfo& type,
                           const FieldRules& rules,
                           const std::uint8_t* at,
                           void* out,
                           const std::string& path) {
    const TypeInfo& element = type.element();
    const bool inline_rows = flat::is_inline(element);
    if (!verifier_.VerifyVectorOrString(at, inline_rows ? element.size : sizeof(uoffset_t)))
      return corrupt(path);
    const std::size_t count = flatbuffers::ReadScalar<uoffset_t>(at);
    if (!spend(count * element.size)) return corrupt(path);
    type.resize(out, count);
    const std::uint8_t* rows = at + sizeof(uoffset_t);
    for (std::size_t i = 0; i < count; ++i) {
      if (inline_rows) {
        MARKETGEN_CHECK(read_plain(element, rules, rows + i * element.size, type.at(out, i), path));
        continue;
      }
      const std::uint8_t* slot = rows + i * sizeof(uoffset_t);
      const uoffset_t step = verifier_.VerifyOffset(static_cast<std::size_t>(slot - start_));
      if (step == 0) return corrupt(path);
      MARKETGEN_CHECK(read_outlined(element, rules, slot + step, type.at(out, i), path));
    }
    return {};
  }

  // Numbers must be finite and within their field's limits, enum values known, booleans 0 or 1:
  // anything else is memory that a writer of ours never made.
  Result<void> read_plain(const TypeInfo& type,
                          const FieldRules& rules,
                          const std::uint8_t* at,
                          void* out,
                          const std::string& path) {
    switch (type.kind) {
      case TypeKind::object:
        for (const FieldInfo& f : type.fields)
          MARKETGEN_CHECK(read_plain(f.type(), f.rules, at + f.offset, f.in(out), path));
        return {};
      case TypeKind::array:
        for (std::size_t i = 0; i < type.fixed_count; ++i) {
          MARKETGEN_CHECK(read_plain(
              type.element(), rules, at + i * type.element().size, type.at(out, i), path));
        }
        return {};
      case TypeKind::boolean:
        if (*at > 1) return corrupt(path);
        break;
      case TypeKind::enumeration: {
        std::int32_t value = 0;
        std::memcpy(&value, at, sizeof value);
        if (value < 0 || static_cast<std::size_t>(value) >= type.names.size()) return corrupt(path);
        break;
      }
      default:
        break;
    }
    std::memcpy(out, at, type.size);
    if (type.kind == TypeKind::number) {
      const double value = type.get_number(out);
      if (!std::isfinite(value) || value < rules.min || value > rules.max) return corrupt(path);
    }
    if (type.kind == TypeKind::integer) {
      const auto value = static_cast<double>(type.get_integer(out));
      if (value < rules.min || value > rules.max) return corrupt(path);
    }
    return {};
  }

  const std::uint8_t* start_;
  flatbuffers::Verifier verifier_;
  const std::string& source_;
  std::size_t budget_;
};

Result<void> check_header(std::span<const std::byte> bytes,
                          const std::string& source,
                          std::string_view identifier) {
  constexpr std::size_t header_bytes = prefix_bytes + sizeof(uoffset_t) + 4;
  if (bytes.size() < header_bytes) {
    return Error{
        "scene.truncated",
        source,
        fmt::format(
            "{} bytes are too few for a header; restore the file or generate the store again",
            bytes.size())};
  }
  const std::string_view found(
      reinterpret_cast<const char*>(bytes.data()) + prefix_bytes + sizeof(uoffset_t), 4);
  if (found != identifier) {
    const bool other_version = found.substr(0, 3) == identifier.substr(0, 3);
    return other_version
               ? Error{"scene.wrong_version",
                       source,
                       fmt::format("has format {}; this program reads {}", found, identifier)}
               : Error{"scene.corrupt",
                       source,
                       fmt::format("is not such a file: \"{}\" is missing at byte 8", identifier)};
  }
  uoffset_t size = 0;
  std::memcpy(&size, bytes.data(), sizeof size);
  const std::size_t whole = std::size_t{size} + prefix_bytes;
  if (whole == bytes.size()) return {};
  const bool short_file = bytes.size() < whole;
  return Error{short_file ? "scene.truncated" : "scene.corrupt",
               source,
               fmt::format("{} bytes, header says {}; restore the file or generate the store again",
                           with_thousands(static_cast<std::int64_t>(bytes.size())),
                           with_thousands(static_cast<std::int64_t>(whole)))};
}

}  // namespace

Result<void> read_flatbuffer_into(std::span<const std::byte> bytes,
                                  const std::string& source,
                                  std::string_view file_identifier,
                                  const TypeInfo& type,
                                  void* object) {
  MARKETGEN_CHECK(check_header(bytes, source, file_identifier));
  return Decoder(bytes, source).decode(type, object);
}

}  // namespace marketgen::io
