#include <charconv>
#include <cmath>

#include "io/json.h"

namespace marketgen::io {
namespace {

constexpr std::size_t line_width = 110;

void append_string(std::string& out, std::string_view text) {
  static constexpr char hex[] = "0123456789abcdef";
  out += '"';
  for (const char c : text) {
    switch (c) {
      case '"':
        out += "\\\"";
        break;
      case '\\':
        out += "\\\\";
        break;
      case '\n':
        out += "\\n";
        break;
      case '\r':
        out += "\\r";
        break;
      case '\t':
        out += "\\t";
        break;
      default:
        if (static_cast<unsigned char>(c) < 0x20) {
          out += "\\u00";
          out += hex[(c >> 4) & 15];
          out += hex[c & 15];
        } else {
          out += c;
        }
    }
  }
  out += '"';
}

void append_integer(std::string& out, const TypeInfo& type, const void* value) {
  char text[24];
  const std::int64_t number = type.get_integer(value);
  const auto end =
      type.is_signed || number >= 0
          ? std::to_chars(text, text + sizeof text, number).ptr
          : std::to_chars(text, text + sizeof text, static_cast<std::uint64_t>(number)).ptr;
  out.append(text, end);
}

// Shortest text that reads back as the same float or double; always with a point or exponent left
// out for whole numbers, but for the zero below 0: readers take "-0" for the whole number 0.
void append_number(std::string& out, const TypeInfo& type, const void* value) {
  const double number = type.get_number(value);
  if (!std::isfinite(number)) {  // JSON has no such number; readers see a missing one
    out += "null";
    return;
  }
  if (number == 0 && std::signbit(number)) {
    out += "-0.0";
    return;
  }
  char text[40];
  const auto end = type.size == sizeof(float)
                       ? std::to_chars(text, text + sizeof text, static_cast<float>(number)).ptr
                       : std::to_chars(text, text + sizeof text, number).ptr;
  out.append(text, end);
}

class Writer {
 public:
  explicit Writer(bool one_line) : one_line_(one_line) {}

  std::string text(const TypeInfo& type, const void* value) {
    std::string out;
    append(out, type, value, 0);
    return out;
  }

 private:
  // Writes on one line when it fits, otherwise one entry a line.
  void append(std::string& out, const TypeInfo& type, const void* value, std::size_t indent) {
    switch (type.kind) {
      case TypeKind::boolean:
        out += type.get_integer(value) != 0 ? "true" : "false";
        return;
      case TypeKind::integer:
        append_integer(out, type, value);
        return;
      case TypeKind::number:
        append_number(out, type, value);
        return;
      case TypeKind::string:
        append_string(out, *static_cast<const std::string*>(value));
        return;
      case TypeKind::enumeration:
        append_string(out, type.names[static_cast<std::size_t>(type.get_integer(value))]);
        return;
      case TypeKind::optional:
        if (type.count(value) == 0)
          out += "null";
        else
          append(out, type.element(), type.at_const(value, 0), indent);
        return;
      case TypeKind::array:
      case TypeKind::object:
        append_group(out, type, value, indent);
        return;
    }
  }

  void append_group(std::string& out, const TypeInfo& type, const void* value, std::size_t indent) {
    const std::size_t start = out.size();
    const bool fits = append_entries(out, type, value, indent, true, start);
    if (fits) return;
    out.resize(start);
    append_entries(out, type, value, indent, false, start);
  }

  // False as soon as a line that should stay short does not.
  bool append_entries(std::string& out,
                      const TypeInfo& type,
                      const void* value,
                      std::size_t indent,
                      bool flat,
                      std::size_t start) {
    const bool object = type.kind == TypeKind::object;
    const std::size_t inner = indent + 2;
    bool first = true;
    out += object ? '{' : '[';
    const auto separate = [&] {
      if (!first) out += flat ? ", " : ",";
      if (!flat) out.append("\n").append(inner, ' ');
      first = false;
    };
    const auto too_long = [&] {
      return flat && !one_line_ && out.size() - start + indent > line_width;
    };
    if (object) {
      for (const FieldInfo& f : type.fields) {
        const TypeInfo& field_type = f.type();
        if (field_type.kind == TypeKind::optional && field_type.count(f.in(value)) == 0) continue;
        separate();
        append_string(out, f.name);
        out += ": ";
        append(out, field_type, f.in(value), inner);
        if (too_long()) return false;
      }
    } else {
      const std::size_t count = type.count(value);
      for (std::size_t i = 0; i < count; ++i) {
        separate();
        append(out, type.element(), type.at_const(value, i), inner);
        if (too_long()) return false;
      }
    }
    if (!flat && !first) out.append("\n").append(indent, ' ');
    out += object ? '}' : ']';
    return !too_long();
  }

  bool one_line_;
};

}  // namespace

std::string write_json_of(const TypeInfo& type, const void* object) {
  return Writer(false).text(type, object) + "\n";
}

std::string write_json_line_of(const TypeInfo& type, const void* object) {
  return Writer(true).text(type, object);
}

}  // namespace marketgen::io
