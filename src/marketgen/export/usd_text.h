// The text of an OpenUSD layer: prims that open and close, and values as its grammar writes them.
//
// Numbers are single precision in their shortest form that reads back the same.
#pragma once
#include <fmt/format.h>

#include <iterator>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "geometry/mesh.h"
#include "geometry/pose.h"

namespace marketgen::exporters {

// Appends to one growing text, indented by what is open.
class UsdText {
 public:
  explicit UsdText(int depth = 0) : depth_(depth) {}

  template <class... Args>
  void line(fmt::format_string<Args...> format, Args&&... args) {
    indent();
    fmt::format_to(std::back_inserter(text_), format, std::forward<Args>(args)...);
    text_ += '\n';
  }
  // `def Xform "name"` with its metadata in brackets; what follows is in it until close().
  void open(std::string_view head, const std::vector<std::string>& metadata = {});
  void close();
  void append(std::string_view lines) { text_ += lines; }
  std::string take() { return std::move(text_); }

 private:
  void indent() { text_.append(static_cast<std::size_t>(2 * depth_), ' '); }

  std::string text_;
  int depth_;
};

// The layer's head: metres, kilograms, Z up, and its default prim.
std::string usd_head(std::string_view default_prim, const std::vector<std::string>& sublayers = {});

// In quotes.
std::string usd_quoted(std::string_view text);
// An identifier: letters, digits and underscores.
std::string usd_identifier(std::string_view id);
// Identifiers of one parent's children, no two alike.
class UsdNames {
 public:
  std::string of(std::string_view id);

 private:
  std::set<std::string> taken_;
};

std::string usd_vector(const Vec3& v);            // (1, 2, 3)
std::string usd_quaternion(const Quaternion& q);  // (w, x, y, z)
// The value of an xformOp:orient: OpenUSD takes the angle from w's arc cosine, which single
// precision spoils for turns of less than a fiftieth of a degree.
std::string usd_orient(const Quaternion& q);
std::string usd_extent(const Bounds3& bounds);
// Translation and rotation, to be changed as others do. `scale`: sizes of a cube of 1 m, or none.
void write_usd_pose(UsdText& out, const Pose& pose);
void write_usd_pose(UsdText& out, const Pose& pose, const Vec3& scale);

// The schema of labels for segmentation: each name has its words.
using UsdLabels = std::vector<std::pair<std::string_view, std::string>>;
// Its entries for apiSchemas, each with a comma before it.
std::string usd_label_schemas(const UsdLabels& labels);
void write_usd_labels(UsdText& out, const UsdLabels& labels);

}  // namespace marketgen::exporters
