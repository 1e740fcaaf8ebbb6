#include "robots/placed_robot.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numbers>
#include <optional>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/text.h"
#include "robots/row_file.h"

namespace marketgen::robots {
namespace {

constexpr double radians_per_degree = std::numbers::pi / 180;
constexpr double limit_slack = 1e-9;  // rounding of degrees
constexpr std::string_view degree_suffix = "deg";
constexpr const char* spec_example =
    "write ROW@X,Y,HEADING and settings, as panda@4.2,3.1,90,z=0.9,posture=ready";

// The whole of `text` as a finite number.
std::optional<double> finite_number(std::string_view text) {
  double value = 0;
  const auto [end, failed] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (failed != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) return {};
  return value;
}

// A joint's value, in radians and metres or in degrees.
std::optional<RobotSpec::JointSetting> joint_setting(const std::string& key,
                                                     std::string_view text) {
  const bool degrees = text.ends_with(degree_suffix);
  if (degrees) text.remove_suffix(degree_suffix.size());
  const auto value = finite_number(text);
  if (!value) return {};
  return RobotSpec::JointSetting{key, *value, degrees ? JointUnit::deg : JointUnit::si};
}

class SpecReader {
 public:
  explicit SpecReader(const std::string& where) : where_(where) {}

  Result<RobotSpec> read(std::string_view text) {
    const std::size_t at = text.find('@');
    if (at == 0 || at == std::string_view::npos)
      return bad(fmt::format("there is no robot and place in \"{}\"", text));
    spec_.row = text.substr(0, at);
    const std::vector<std::string> words = split(text.substr(at + 1), ',');
    std::vector<double> numbers;
    for (const std::string& word : words) {
      if (const std::size_t equals = word.find('='); equals != std::string::npos) {
        MARKETGEN_CHECK(set(word.substr(0, equals), word.substr(equals + 1)));
        continue;
      }
      const auto number = finite_number(word);
      if (!number) return bad(fmt::format("\"{}\" is neither a number nor KEY=VALUE", word));
      if (!keys_.empty())
        return bad(fmt::format(
            "the number {} stands behind a setting; place and heading come first", word));
      numbers.push_back(*number);
    }
    if (numbers.size() < 2 || numbers.size() > 3)
      return bad(fmt::format("expected x, y and perhaps a heading; got {} number{}",
                             numbers.size(),
                             numbers.size() == 1 ? "" : "s"));
    spec_.position.x = numbers[0], spec_.position.y = numbers[1];
    if (numbers.size() == 3) spec_.heading_deg = numbers[2];
    return spec_;
  }

 private:
  Error bad(const std::string& what) const {
    return {"robot.bad_spec", where_, what + "; " + spec_example};
  }

  Result<void> set(const std::string& key, const std::string& value) {
    if (key.empty() || value.empty())
      return bad(fmt::format("\"{}={}\" lacks a name or a value", key, value));
    if (!keys_.insert(key).second) return bad(fmt::format("\"{}\" is given twice", key));
    if (key == "posture") {
      spec_.posture = value;
    } else if (key == "z") {
      const auto height = finite_number(value);
      if (!height) return bad(fmt::format("z: \"{}\" is no height in metres", value));
      spec_.position.z = *height;
    } else if (const auto joint = joint_setting(key, value)) {
      spec_.joints.push_back(*joint);
    } else {
      spec_.tools[key] = value;
    }
    return {};
  }

  const std::string& where_;
  RobotSpec spec_;
  std::set<std::string> keys_;
};

template <class Named>
std::vector<std::string_view> names_in(const std::vector<Named>& list) {
  std::vector<std::string_view> names;
  for (const Named& item : list)
    names.push_back(item.name);
  return names;
}

Error no_such(const std::string& where,
              std::string_view what,
              std::string_view wanted,
              const std::vector<std::string_view>& known) {
  std::string hint = did_you_mean(wanted, known);
  if (hint.empty())
    hint = known.empty() ? "; it has none" : fmt::format("; known are: {}", fmt::join(known, ", "));
  return {"robot.unknown", where, fmt::format("there is no {} \"{}\"{}", what, wanted, hint)};
}

std::vector<std::string_view> moving_joints(const Robot& robot) {
  std::vector<std::string_view> names;
  for (std::size_t dof = 0; dof < robot.dof_count(); ++dof) {
    if (robot.joint_of_dof(dof).follows < 0) names.push_back(robot.joint_of_dof(dof).name);
  }
  return names;
}

bool slides(const Joint& joint) {
  return joint.kind == JointType::prismatic;
}

// "-130 to 130 deg", "0 to 0.9 m".
std::string range_of(const Joint& joint) {
  if (slides(joint)) return fmt::format("{:.3g} to {:.3g} m", joint.lower, joint.upper);
  return fmt::format(
      "{:.3g} to {:.3g} deg", joint.lower / radians_per_degree, joint.upper / radians_per_degree);
}

Result<std::vector<double>> with_joint(const Robot& robot,
                                       const RobotSpec::JointSetting& setting,
                                       const std::string& where,
                                       std::vector<double> q) {
  const int dof = robot.find_dof(setting.joint);
  if (dof < 0) return no_such(where, "joint", setting.joint, moving_joints(robot));
  const Joint& joint = robot.joint_of_dof(static_cast<std::size_t>(dof));
  if (joint.follows >= 0) {
    return Error{"robot.bad_state",
                 where,
                 fmt::format("joint \"{}\" copies \"{}\"; set that one",
                             joint.name,
                             robot.joint_of_dof(static_cast<std::size_t>(joint.follows)).name)};
  }
  const bool degrees = setting.unit == JointUnit::deg;
  if (degrees && slides(joint))
    return Error{"robot.bad_state",
                 where,
                 fmt::format("joint \"{}\" slides: give metres, not degrees", joint.name)};
  const double value = degrees ? setting.value * radians_per_degree : setting.value;
  if (value < joint.lower - limit_slack || value > joint.upper + limit_slack) {
    return Error{"robot.bad_state",
                 where,
                 fmt::format("joint \"{}\" goes from {}; {:.4g} {} is outside",
                             joint.name,
                             range_of(joint),
                             slides(joint) ? value : value / radians_per_degree,
                             slides(joint) ? "m" : "deg (numbers without \"deg\" are radians)")};
  }
  q[static_cast<std::size_t>(dof)] = std::clamp(value, joint.lower, joint.upper);
  return q;
}

Result<std::vector<double>> state_of(const Robot& robot,
                                     const RobotSpec& spec,
                                     const std::string& where) {
  std::vector<double> q = neutral_state(robot);
  const Posture* posture = robot.postures.empty() ? nullptr : &robot.postures.front();
  if (!spec.posture.empty()) {
    posture = robot.find_posture(spec.posture);
    if (posture == nullptr)
      return no_such(where, "posture", spec.posture, names_in(robot.postures));
  }
  if (posture != nullptr) q = with_posture(*posture, std::move(q));
  for (const RobotSpec::JointSetting& setting : spec.joints) {
    MARKETGEN_TRY(q, with_joint(robot, setting, where, std::move(q)));
  }
  return with_followers(robot, std::move(q));
}

Result<void> check_row(const std::filesystem::path& data,
                       const std::string& id,
                       std::string_view what,
                       const std::string& where) {
  if (is_row_file(id)) return {};  // whoever reads it says whether it is there
  MARKETGEN_TRY(const std::vector<std::string> ids, robot_ids(data));
  if (std::find(ids.begin(), ids.end(), id) != ids.end()) return {};
  return no_such(where, what, id, {ids.begin(), ids.end()});
}

}  // namespace

Result<RobotSpec> parse_robot_spec(std::string_view text, const std::string& where) {
  return SpecReader(where).read(text);
}

Result<PlacedRobot> place_robot(const std::filesystem::path& data,
                                const RobotSpec& spec,
                                const std::string& where) {
  MARKETGEN_CHECK(check_row(data, spec.row, "robot", where));
  for (const auto& [slot, tool] : spec.tools)
    MARKETGEN_CHECK(check_row(data, tool, "tool", where));
  Result<Robot> robot = load_robot(data, spec.row, spec.tools);
  if (!robot.ok() && robot.error().code == "robot.unknown")  // a slot
    return Error{robot.error().code, where, robot.error().message};
  if (!robot.ok()) return robot.error();
  MARKETGEN_TRY(std::vector<double> q, state_of(*robot, spec, where));
  const Pose world_from_base{spec.position,
                             rotation_about({0, 0, 1}, spec.heading_deg * radians_per_degree)};
  return PlacedRobot{where, std::move(robot).value(), std::move(q), world_from_base};
}

}  // namespace marketgen::robots
