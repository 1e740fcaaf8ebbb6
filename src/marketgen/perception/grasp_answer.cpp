#include "perception/grasp_answer.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

#include <nlohmann/json.hpp>

namespace marketgen::perception {
namespace {

using Json = nlohmann::json;

constexpr std::size_t row_numbers = 17, rotation_at = 4, translation_at = 13;
constexpr std::size_t max_answer_bytes = std::size_t{16} << 20;  // some 50,000 grasps
constexpr double max_off_unit = 0.02;                   // of axes, and of their right angle
constexpr double max_depth_m = 0.2, max_width_m = 0.5;  // of any hand

Error bad_grasps(std::string why) {
  return {"perception.bad_answer", "grasp server", std::move(why)};
}

// Numbers of a list, or of a list of lists; nothing when there are others than `count`.
std::optional<std::vector<double>> numbers_of(const Json& json, std::size_t count) {
  std::vector<double> numbers;
  const std::function<bool(const Json&, int)> add = [&](const Json& value, int depth) {
    if (value.is_number()) {
      numbers.push_back(value.get<double>());
      return numbers.size() <= count;
    }
    return value.is_array() && depth < 2 &&
           std::ranges::all_of(value, [&](const Json& each) { return add(each, depth + 1); });
  };
  if (!add(json, 0) || numbers.size() != count) return std::nullopt;
  return numbers;
}

double number_at(const Json& json, const char* name) {
  const auto at = json.find(name);
  return at != json.end() && at->is_number() ? at->get<double>() : 0;
}

// As a row of 17.
std::optional<std::vector<double>> row_of(const Json& json) {
  if (json.is_array()) return numbers_of(json, row_numbers);
  if (!json.is_object() || !json.contains("rotation_matrix") || !json.contains("translation"))
    return std::nullopt;
  const auto rotation = numbers_of(json["rotation_matrix"], 9);
  const auto translation = numbers_of(json["translation"], 3);
  if (!rotation || !translation) return std::nullopt;
  std::vector<double> row{number_at(json, "score"),
                          number_at(json, "width"),
                          number_at(json, "height"),
                          number_at(json, "depth")};
  row.insert(row.end(), rotation->begin(), rotation->end());
  row.insert(row.end(), translation->begin(), translation->end());
  row.push_back(0);
  return row;
}

// GraspNet's gripper: x ahead, y closing (columns of its rotation).
std::optional<NetworkGrasp> grasp_of(const std::vector<double>& row) {
  if (!std::ranges::all_of(row, [](double value) { return std::isfinite(value); }))
    return std::nullopt;
  const auto column = [&](std::size_t c) {
    return Vec3{row[rotation_at + c], row[rotation_at + 3 + c], row[rotation_at + 6 + c]};
  };
  const Vec3 ahead = column(0), closing = column(1);
  if (std::abs(length(ahead) - 1) > max_off_unit || std::abs(length(closing) - 1) > max_off_unit ||
      std::abs(dot(ahead, closing)) > max_off_unit)
    return std::nullopt;
  NetworkGrasp grasp;
  grasp.score = row[0], grasp.width_m = row[1], grasp.depth_m = row[3];
  grasp.center = {row[translation_at], row[translation_at + 1], row[translation_at + 2]};
  grasp.approach = normalized(ahead);
  grasp.closing = normalized(closing - grasp.approach * dot(closing, grasp.approach));
  const bool is_of_a_hand = grasp.depth_m >= 0 && grasp.depth_m < max_depth_m &&
                            grasp.width_m >= 0 && grasp.width_m < max_width_m;
  return is_of_a_hand ? std::optional(grasp) : std::nullopt;
}

}  // namespace

Result<std::vector<NetworkGrasp>> read_grasps(const std::string& answer) {
  if (answer.size() > max_answer_bytes) return bad_grasps("too large");
  const Json json = Json::parse(answer, nullptr, false);
  if (json.is_discarded()) return bad_grasps("no JSON");
  if (!json.is_object() || !json.contains("grasp_groups") || !json["grasp_groups"].is_array())
    return bad_grasps("no list \"grasp_groups\"");
  std::vector<NetworkGrasp> grasps;
  const Json& list = json["grasp_groups"];
  for (const Json& each : list) {
    const auto row = row_of(each);
    const auto grasp = row ? grasp_of(*row) : std::nullopt;
    if (grasp) grasps.push_back(*grasp);
  }
  if (grasps.empty() && !list.empty())
    return bad_grasps(
        "none of its grasps is one: 17 finite numbers, or translation and a rotation");
  std::ranges::stable_sort(grasps, std::greater<>{}, &NetworkGrasp::score);
  if (grasps.size() > max_network_grasps) grasps.resize(max_network_grasps);
  return grasps;
}

}  // namespace marketgen::perception
