#include "export/usd_text.h"

#include <cctype>
#include <cmath>

namespace marketgen::exporters {

void UsdText::open(std::string_view head, const std::vector<std::string>& metadata) {
  if (metadata.empty())
    line("{}", head);
  else {
    line("{} (", head);
    ++depth_;
    for (const std::string& entry : metadata)
      line("{}", entry);
    --depth_;
    line(")");
  }
  line("{{");
  ++depth_;
}

void UsdText::close() {
  --depth_;
  line("}}");
}

std::string usd_head(std::string_view default_prim, const std::vector<std::string>& sublayers) {
  std::string text = fmt::format(
      "#usda 1.0\n(\n    defaultPrim = \"{}\"\n    kilogramsPerUnit = 1\n    metersPerUnit = 1\n",
      default_prim);
  if (!sublayers.empty()) {
    text += "    subLayers = [\n";
    for (const std::string& layer : sublayers)
      text += fmt::format("        @{}@{}\n", layer, &layer == &sublayers.back() ? "" : ",");
    text += "    ]\n";
  }
  return text + "    upAxis = \"Z\"\n)\n\n";
}

std::string usd_quoted(std::string_view text) {
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') quoted += '\\';
    quoted += c == '\n' ? ' ' : c;
  }
  return quoted + '"';
}

std::string usd_identifier(std::string_view id) {
  std::string name;
  for (const char c : id)
    name += std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '_';
  if (name.empty() || std::isdigit(static_cast<unsigned char>(name.front())) != 0)
    name.insert(0, "_");
  return name;
}

std::string UsdNames::of(std::string_view id) {
  const std::string name = usd_identifier(id);
  std::string free = name;
  for (int i = 2; !taken_.insert(free).second; ++i)
    free = fmt::format("{}_{}", name, i);
  return free;
}

std::string usd_vector(const Vec3& v) {
  return fmt::format(
      "({}, {}, {})", static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z));
}

namespace {

Quaternion unit(const Quaternion& q) {
  const double norm = std::sqrt(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
  return {q.w / norm, q.x / norm, q.y / norm, q.z / norm};
}

std::string quaternion_text(std::string_view w, const Quaternion& q) {
  return fmt::format("({}, {}, {}, {})",
                     w,
                     static_cast<float>(q.x),
                     static_cast<float>(q.y),
                     static_cast<float>(q.z));
}

}  // namespace

std::string usd_quaternion(const Quaternion& q) {
  const Quaternion one = unit(q);
  return quaternion_text(fmt::format("{}", static_cast<float>(one.w)), one);
}

std::string usd_orient(const Quaternion& q) {
  const Quaternion one = unit(q);
  return quaternion_text(fmt::format("{:.13g}", one.w), one);
}

std::string usd_extent(const Bounds3& bounds) {
  return fmt::format("[({}, {}, {}), ({}, {}, {})]",
                     bounds.low.x,
                     bounds.low.y,
                     bounds.low.z,
                     bounds.high.x,
                     bounds.high.y,
                     bounds.high.z);
}

void write_usd_pose(UsdText& out, const Pose& pose) {
  out.line("quatd xformOp:orient = {}", usd_orient(pose.rotation));
  out.line("double3 xformOp:translate = {}", usd_vector(pose.position));
  out.line("uniform token[] xformOpOrder = [\"xformOp:translate\", \"xformOp:orient\"]");
}

void write_usd_pose(UsdText& out, const Pose& pose, const Vec3& scale) {
  out.line("quatd xformOp:orient = {}", usd_orient(pose.rotation));
  out.line("float3 xformOp:scale = {}", usd_vector(scale));
  out.line("double3 xformOp:translate = {}", usd_vector(pose.position));
  out.line(
      "uniform token[] xformOpOrder = [\"xformOp:translate\", \"xformOp:orient\", "
      "\"xformOp:scale\"]");
}

std::string usd_label_schemas(const UsdLabels& labels) {
  std::string schemas;
  for (const auto& [name, text] : labels)
    schemas += fmt::format(", \"SemanticsLabelsAPI:{}\"", name);
  return schemas;
}

void write_usd_labels(UsdText& out, const UsdLabels& labels) {
  for (const auto& [name, text] : labels)
    out.line("token[] semantics:labels:{} = [{}]", name, usd_quoted(text));
}

}  // namespace marketgen::exporters
