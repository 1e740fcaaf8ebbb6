#include "io/usd_crate.h"

#include <iterator>
#include <utility>

#include "base/hash.h"

namespace marketgen::io {
namespace {

// Numbers of the format: crateDataTypes.h and SdfSpecType.
namespace type {
constexpr std::uint64_t boolean = 1, integer = 3, real = 9, token = 11, vec2f = 20, vec3f = 24,
                        token_vector = 41, specifier = 42, variability = 44;
}
constexpr std::int32_t attribute_spec = 1, prim_spec = 6, layer_spec = 7;
constexpr std::uint64_t array_bit = 1ULL << 63, inlined_bit = 1ULL << 62,
                        compressed_bit = 1ULL << 61;
constexpr int type_shift = 48;
constexpr std::size_t head_bytes = 88;  // identifier, version, offset of the table, reserved
constexpr std::size_t section_name_bytes = 16;
constexpr std::size_t min_compressed = 16;  // shorter arrays are never compressed
constexpr std::uint32_t end_of_set = 0xFFFFFFFF;

std::uint64_t inlined(std::uint64_t kind, std::uint64_t payload) {
  return inlined_bit | (kind << type_shift) | payload;
}

template <class T>
void put(std::string& out, T value) {  // little-endian, as every machine we build for
  out.append(reinterpret_cast<const char*>(&value), sizeof value);
}

template <class T>
std::string array_bytes(const std::vector<T>& values) {
  std::string out;
  put(out, static_cast<std::uint64_t>(values.size()));
  out.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));
  return out;
}

// One chunk, and in it a block of LZ4 that is one run of literals: readers unpack it as any other.
std::string as_compressed(std::string_view bytes) {
  constexpr std::size_t short_run = 15, most = 255;
  std::string out(1, '\0');
  if (bytes.size() < short_run)
    out += static_cast<char>(bytes.size() << 4U);
  else {
    out += static_cast<char>(short_run << 4U);
    std::size_t left = bytes.size() - short_run;
    for (; left >= most; left -= most)
      out += static_cast<char>(most);
    out += static_cast<char>(left);
  }
  return out.append(bytes);
}

// The commonest of the differences between neighbours.
std::int32_t commonest_step(const std::vector<std::int32_t>& values) {
  std::map<std::int32_t, std::size_t> counts;
  std::int32_t before = 0, common = 0;
  for (const std::int32_t v : values) {
    ++counts[static_cast<std::int32_t>(static_cast<std::uint32_t>(v) -
                                       static_cast<std::uint32_t>(before))];
    before = v;
  }
  std::size_t most = 0;
  for (const auto& [step, count] : counts) {
    if (count >= most) common = step, most = count;
  }
  return common;
}

// Differences, each by a code of two bits: the commonest, or one of 8, 16 or 32 bits that follows.
std::string compressed_integers(const std::vector<std::int32_t>& values) {
  if (values.empty()) return as_compressed({});
  const std::int32_t common = commonest_step(values);
  std::string codes((values.size() * 2 + 7) / 8, '\0'), rest;
  std::int32_t before = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const auto step = static_cast<std::int32_t>(static_cast<std::uint32_t>(values[i]) -
                                                static_cast<std::uint32_t>(before));
    before = values[i];
    unsigned code = 0;
    if (step == common)
      code = 0;
    else if (step == static_cast<std::int8_t>(step)) {
      code = 1;
      put(rest, static_cast<std::int8_t>(step));
    } else if (step == static_cast<std::int16_t>(step)) {
      code = 2;
      put(rest, static_cast<std::int16_t>(step));
    } else {
      code = 3;
      put(rest, step);
    }
    codes[i / 4] =
        static_cast<char>(static_cast<unsigned char>(codes[i / 4]) | code << 2 * (i % 4));
  }
  std::string encoded;
  put(encoded, common);
  return as_compressed(encoded + codes + rest);
}

void put_sized(std::string& out, const std::string& bytes) {
  put(out, static_cast<std::uint64_t>(bytes.size()));
  out += bytes;
}

std::string integers_array(const std::vector<std::int32_t>& values) {
  std::string out;
  put(out, static_cast<std::uint64_t>(values.size()));
  put_sized(out, compressed_integers(values));
  return out;
}

}  // namespace

UsdCrate::UsdCrate(const std::string& root) : bytes_(head_bytes, '\0') {
  token("");  // 0: an attribute's path is its negative token, and of 0 there is none
  specs_.emplace_back().kind = layer_spec;
  add_field(0, "defaultPrim", inlined(type::token, token(root)));
  add_field(0, "upAxis", inlined(type::token, token("Z")));
  add_field(0, "metersPerUnit", stored_value(1.0));
  add_field(0, "kilogramsPerUnit", stored_value(1.0));
  specs_[0].prims.push_back(token(root));
  const std::size_t prim = add_spec(0, root, prim_spec);
  add_field(prim, "specifier", inlined(type::specifier, 0));
  add_field(prim, "typeName", inlined(type::token, token("Xform")));
}

int UsdCrate::add_prim(int parent, const std::string& name, const std::string& type_name) {
  const std::size_t owner = static_cast<std::size_t>(parent) + 1;
  specs_[owner].prims.push_back(token(name));
  const std::size_t prim = add_spec(owner, name, prim_spec);
  add_field(prim, "specifier", inlined(type::specifier, 0));
  add_field(prim, "typeName", inlined(type::token, token(type_name)));
  return static_cast<int>(prim) - 1;
}

void UsdCrate::add_attribute(int prim, const UsdAttribute& attribute) {
  const std::size_t owner = static_cast<std::size_t>(prim) + 1;
  specs_[owner].properties.push_back(token(attribute.name));
  const std::size_t spec = add_spec(owner, attribute.name, attribute_spec);
  specs_[spec].is_property = true;
  add_field(spec, "typeName", inlined(type::token, token(attribute.type)));
  if (attribute.uniform) add_field(spec, "variability", inlined(type::variability, 1));
  if (!attribute.interpolation.empty())
    add_field(spec, "interpolation", inlined(type::token, token(attribute.interpolation)));
  add_field(spec, "default", stored_value(attribute.value));
}

std::uint32_t UsdCrate::token(const std::string& text) {
  const auto [entry, is_new] =
      token_of_.try_emplace(text, static_cast<std::uint32_t>(tokens_.size()));
  if (is_new) tokens_.push_back(text);
  return entry->second;
}

std::uint64_t UsdCrate::stored(std::uint64_t kind, std::string_view bytes) {
  const std::string key = Hasher().add(static_cast<std::int64_t>(kind)).add(bytes).hex();
  const auto [entry, is_new] = known_.try_emplace(key, 0);
  if (is_new) {
    bytes_.resize((bytes_.size() + 7) / 8 * 8, '\0');
    entry->second = kind | bytes_.size();
    bytes_ += bytes;
  }
  return entry->second;
}

std::uint64_t UsdCrate::stored_tokens(const std::vector<std::uint32_t>& tokens) {
  return stored(type::token_vector << type_shift, array_bytes(tokens));
}

std::uint64_t UsdCrate::stored_value(const UsdValue& value) {
  if (const auto* text = std::get_if<std::string>(&value))
    return inlined(type::token, token(*text));
  if (const auto* flag = std::get_if<bool>(&value)) return inlined(type::boolean, *flag ? 1 : 0);
  if (const auto* number = std::get_if<double>(&value)) {
    std::string bytes;
    put(bytes, *number);
    return stored(type::real << type_shift, bytes);
  }
  if (const auto* integers = std::get_if<std::vector<std::int32_t>>(&value)) {
    if (integers->empty()) return array_bit | (type::integer << type_shift);
    if (integers->size() < min_compressed)
      return stored(array_bit | (type::integer << type_shift), array_bytes(*integers));
    return stored(array_bit | compressed_bit | (type::integer << type_shift),
                  integers_array(*integers));
  }
  if (const auto* pairs = std::get_if<std::vector<Vec2f>>(&value))
    return pairs->empty() ? array_bit | (type::vec2f << type_shift)
                          : stored(array_bit | (type::vec2f << type_shift), array_bytes(*pairs));
  const auto& triples = std::get<std::vector<Vec3f>>(value);
  return triples.empty() ? array_bit | (type::vec3f << type_shift)
                         : stored(array_bit | (type::vec3f << type_shift), array_bytes(triples));
}

void UsdCrate::add_field(std::size_t spec, const std::string& name, std::uint64_t value) {
  specs_[spec].fields.push_back({token(name), value});
}

std::size_t UsdCrate::add_spec(std::size_t parent, const std::string& name, std::int32_t kind) {
  Spec& spec = specs_.emplace_back();
  spec.element = token(name);
  spec.kind = kind;
  specs_[parent].children.push_back(specs_.size() - 1);
  return specs_.size() - 1;
}

void UsdCrate::close_children(Spec& spec) {
  if (!spec.prims.empty())
    spec.fields.push_back({token("primChildren"), stored_tokens(spec.prims)});
  if (!spec.properties.empty())
    spec.fields.push_back({token("properties"), stored_tokens(spec.properties)});
}

// Paths, parents before children, as three columns: which path, its last element (negative: of an
// attribute), and where the next of the same parent stands: 0 after this one, -1 nowhere, -2 the
// same and it has no children, else so many rows on.
void UsdCrate::write_paths(std::string& out) const {
  struct Visit {
    std::size_t spec;
    bool is_last;
    bool is_done;
    std::size_t row;
  };
  std::vector<std::int32_t> paths, elements, jumps;
  std::vector<Visit> open{{0, true, false, 0}};
  while (!open.empty()) {
    Visit visit = open.back();
    open.pop_back();
    const Spec& spec = specs_[visit.spec];
    const bool has_child = !spec.children.empty();
    if (visit.is_done) {  // all below it is written
      jumps[visit.row] = static_cast<std::int32_t>(paths.size() - visit.row);
      continue;
    }
    visit.row = paths.size();
    paths.push_back(static_cast<std::int32_t>(visit.spec));
    const auto element = static_cast<std::int32_t>(spec.element);
    elements.push_back(spec.is_property ? -element : element);
    jumps.push_back(visit.is_last ? (has_child ? -1 : -2) : 0);
    if (has_child && !visit.is_last) open.push_back({visit.spec, false, true, visit.row});
    for (std::size_t i = spec.children.size(); i-- > 0;)
      open.push_back({spec.children[i], i + 1 == spec.children.size(), false, 0});
  }
  put(out, static_cast<std::uint64_t>(paths.size()));
  put(out, static_cast<std::uint64_t>(paths.size()));
  for (const auto* column : {&paths, &elements, &jumps})
    put_sized(out, compressed_integers(*column));
}

// A spec is its path, its set of fields and its kind; equal fields and sets are written once.
void UsdCrate::write_specs(std::string& out, std::string& fields, std::string& field_sets) const {
  std::map<std::pair<std::uint32_t, std::uint64_t>, std::int32_t> field_of;
  std::map<std::vector<std::int32_t>, std::int32_t> set_of;
  std::vector<std::int32_t> names, set_list, paths, sets, kinds;
  std::string values;
  for (std::size_t i = 0; i < specs_.size(); ++i) {
    std::vector<std::int32_t> set;
    for (const Field& field : specs_[i].fields) {
      const auto [entry, is_new] =
          field_of.try_emplace({field.name, field.value}, static_cast<std::int32_t>(names.size()));
      if (is_new) {
        names.push_back(static_cast<std::int32_t>(field.name));
        put(values, field.value);
      }
      set.push_back(entry->second);
    }
    set.push_back(static_cast<std::int32_t>(end_of_set));
    const auto [entry, is_new] =
        set_of.try_emplace(set, static_cast<std::int32_t>(set_list.size()));
    if (is_new) set_list.insert(set_list.end(), set.begin(), set.end());
    paths.push_back(static_cast<std::int32_t>(i));
    sets.push_back(entry->second);
    kinds.push_back(specs_[i].kind);
  }
  put(fields, static_cast<std::uint64_t>(names.size()));
  put_sized(fields, compressed_integers(names));
  put_sized(fields, as_compressed(values));
  field_sets = integers_array(set_list);
  put(out, static_cast<std::uint64_t>(specs_.size()));
  for (const auto* column : {&paths, &sets, &kinds})
    put_sized(out, compressed_integers(*column));
}

std::string UsdCrate::finish() {
  for (Spec& spec : specs_)
    close_children(spec);
  std::string texts, strings, fields, field_sets, paths, specs, token_list;
  write_paths(paths);
  write_specs(specs, fields, field_sets);
  put(strings, std::uint64_t{0});
  for (const std::string& text : tokens_)
    texts.append(text).push_back('\0');
  put(token_list, static_cast<std::uint64_t>(tokens_.size()));
  put(token_list, static_cast<std::uint64_t>(texts.size()));
  put_sized(token_list, as_compressed(texts));

  const std::pair<const char*, const std::string*> sections[] = {{"TOKENS", &token_list},
                                                                 {"STRINGS", &strings},
                                                                 {"FIELDS", &fields},
                                                                 {"FIELDSETS", &field_sets},
                                                                 {"PATHS", &paths},
                                                                 {"SPECS", &specs}};
  std::string table;
  put(table, static_cast<std::uint64_t>(std::size(sections)));
  for (const auto& [name, bytes] : sections) {
    std::string padded = name;
    padded.resize(section_name_bytes, '\0');
    table += padded;
    put(table, static_cast<std::uint64_t>(bytes_.size()));
    put(table, static_cast<std::uint64_t>(bytes->size()));
    bytes_ += *bytes;
  }
  std::string head = "PXR-USDC";
  head.append({0, 8, 0, 0, 0, 0, 0, 0});
  put(head, static_cast<std::uint64_t>(bytes_.size()));
  head.resize(head_bytes, '\0');
  bytes_.replace(0, head_bytes, head);
  bytes_ += table;
  return std::exchange(bytes_, {});
}

}  // namespace marketgen::io
