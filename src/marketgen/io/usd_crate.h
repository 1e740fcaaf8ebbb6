// A binary layer of OpenUSD (.usdc, "crate") under construction: prims and their attributes, for
// bulk data. What people read and edit belongs into text layers.
//
// Version 0.8.0, which OpenUSD 20.11 and everything since reads. The format has no document of its
// own; it is OpenUSD's pxr/usd/sdf/crateFile.cpp. Of what it offers this writes the part that
// meshes need: no time samples, no references, no lists that are edited.
#pragma once
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "geometry/vector.h"

namespace marketgen::io {

using UsdValue = std::variant<std::string,  // a token
                              bool,
                              double,
                              std::vector<std::int32_t>,
                              std::vector<Vec2f>,
                              std::vector<Vec3f>>;

struct UsdAttribute {
  std::string name, type;  // "points", "point3f[]"
  UsdValue value;
  bool uniform = false;       // it cannot change over time
  std::string interpolation;  // of a primvar; empty: none is said
};

class UsdCrate {
 public:
  // Metres, Z up. `root` is the name of the default prim, an Xform; add_prim's 0 stands for it.
  explicit UsdCrate(const std::string& root);

  // A prim under `parent`; returns its number. Names are identifiers, unique below one parent.
  int add_prim(int parent, const std::string& name, const std::string& type);
  // Equal arrays are stored once.
  void add_attribute(int prim, const UsdAttribute& attribute);

  // The whole file.
  std::string finish();

 private:
  struct Field {
    std::uint32_t name = 0;  // token
    std::uint64_t value = 0;
  };
  struct Spec {
    std::uint32_t element = 0;  // token of its name
    bool is_property = false;
    std::int32_t kind = 0;
    std::vector<Field> fields;
    std::vector<std::size_t> children;  // prims, then attributes
    std::vector<std::uint32_t> prims, properties;
  };

  std::uint32_t token(const std::string& text);
  std::uint64_t stored(std::uint64_t kind, std::string_view bytes);
  std::uint64_t stored_tokens(const std::vector<std::uint32_t>& tokens);
  std::uint64_t stored_value(const UsdValue& value);
  void add_field(std::size_t spec, const std::string& name, std::uint64_t value);
  std::size_t add_spec(std::size_t parent, const std::string& name, std::int32_t kind);
  void close_children(Spec& spec);
  void write_paths(std::string& out) const;
  void write_specs(std::string& out, std::string& fields, std::string& field_sets) const;

  std::string bytes_;  // the file so far: its head's room, then values
  std::vector<std::string> tokens_;
  std::map<std::string, std::uint32_t> token_of_;
  std::map<std::string, std::uint64_t> known_;  // hash of a value's bytes -> its representation
  std::vector<Spec> specs_;                     // 0 the layer, 1 its default prim
};

}  // namespace marketgen::io
