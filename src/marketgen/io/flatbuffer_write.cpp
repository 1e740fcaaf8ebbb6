#include <cstring>
#include <vector>

#include <flatbuffers/flatbuffers.h>

#include "io/flatbuffer.h"
#include "io/flatbuffer_layout.h"

namespace marketgen::io {
namespace {

using flatbuffers::uoffset_t;
using flatbuffers::voffset_t;

voffset_t slot_of(std::size_t field) {
  return static_cast<voffset_t>(flatbuffers::FieldIndexToOffset(static_cast<voffset_t>(field)));
}

// Copies member by member, so that padding bytes stay zero whatever was in memory.
void copy_plain(const TypeInfo& type, const void* from, std::byte* to) {
  if (type.kind == TypeKind::object) {
    for (const FieldInfo& f : type.fields)
      copy_plain(f.type(), f.in(from), to + f.offset);
  } else if (type.kind == TypeKind::array) {
    const TypeInfo& element = type.element();
    for (std::size_t i = 0; i < type.fixed_count; ++i)
      copy_plain(element, type.at_const(from, i), to + i * element.size);
  } else {
    std::memcpy(to, from, type.size);
  }
}

class Encoder {
 public:
  std::string encode(const TypeInfo& type, const void* object, std::string_view file_identifier) {
    builder_.ForceDefaults(true);
    const uoffset_t root = add_table(type, object);
    builder_.FinishSizePrefixed(flatbuffers::Offset<flatbuffers::Table>(root),
                                std::string(file_identifier).c_str());
    return {reinterpret_cast<const char*>(builder_.GetBufferPointer()), builder_.GetSize()};
  }

 private:
  uoffset_t add_outlined(const TypeInfo& type, const void* value) {
    if (type.kind == TypeKind::string)
      return builder_.CreateString(*static_cast<const std::string*>(value)).o;
    if (type.kind == TypeKind::array) return add_vector(type, value);
    return add_table(type, value);
  }

  uoffset_t add_vector(const TypeInfo& type, const void* value) {
    const TypeInfo& element = type.element();
    const std::size_t count = type.count(value);
    if (flat::is_inline(element)) {
      std::vector<std::byte> rows(count * element.size);
      for (std::size_t i = 0; i < count; ++i)
        copy_plain(element, type.at_const(value, i), rows.data() + i * element.size);
      builder_.ForceVectorAlignment(count, element.size, flat::alignment_of(element));
      builder_.StartVector(count, element.size);
      builder_.PushBytes(reinterpret_cast<const std::uint8_t*>(rows.data()), rows.size());
      return builder_.EndVector(count);
    }
    std::vector<flatbuffers::Offset<void>> offsets;
    for (std::size_t i = 0; i < count; ++i)
      offsets.emplace_back(add_outlined(element, type.at_const(value, i)));
    return builder_.CreateVector(offsets).o;
  }

  uoffset_t add_table(const TypeInfo& type, const void* object) {
    struct Slot {
      const TypeInfo* type;  // null: absent
      const void* value;
      uoffset_t offset;  // of what is stored elsewhere
    };
    std::vector<Slot> slots;
    for (const FieldInfo& f : type.fields) {
      const TypeInfo* field_type = &f.type();
      const void* value = f.in(object);
      if (field_type->kind == TypeKind::optional) {
        const bool present = field_type->count(value) != 0;
        value = present ? field_type->at_const(value, 0) : nullptr;
        field_type = present ? &field_type->element() : nullptr;
      }
      const bool elsewhere = field_type != nullptr && !flat::is_inline(*field_type);
      slots.push_back({field_type, value, elsewhere ? add_outlined(*field_type, value) : 0});
    }
    const uoffset_t start = builder_.StartTable();
    for (std::size_t i = 0; i < slots.size(); ++i) {
      if (slots[i].type == nullptr) continue;
      if (slots[i].offset != 0)
        builder_.AddOffset(slot_of(i), flatbuffers::Offset<void>(slots[i].offset));
      else
        add_inline(slot_of(i), *slots[i].type, slots[i].value);
    }
    return builder_.EndTable(start);
  }

  void add_inline(voffset_t slot, const TypeInfo& type, const void* value) {
    std::vector<std::byte> bytes(type.size);
    copy_plain(type, value, bytes.data());
    builder_.Align(flat::alignment_of(type));
    builder_.PushBytes(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
    builder_.AddStructOffset(slot, builder_.GetSize());
  }

  flatbuffers::FlatBufferBuilder builder_{1 << 20};
};

}  // namespace

std::string write_flatbuffer_of(const TypeInfo& type,
                                const void* object,
                                std::string_view file_identifier) {
  return Encoder().encode(type, object, file_identifier);
}

}  // namespace marketgen::io
