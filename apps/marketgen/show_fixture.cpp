#include "show_fixture.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/inherited_fields.h"
#include "io/json.h"
#include "io/picture_file.h"
#include "render/fixture_picture.h"
#include "scene/articulation.h"
#include "scene/fixture_stage.h"

namespace marketgen::app {
namespace {

constexpr std::string_view every_joint = "all";

// Its row in the catalogue, and what moves on it.
struct ShownFixture : catalog::FixtureKind {
  std::vector<scene::SceneJoint> joints;
  static constexpr auto fields = inherited_fields<ShownFixture>(
      catalog::FixtureKind::fields,
      field_list(field("joints", &ShownFixture::joints, "what moves on it")));
};

Result<std::size_t> joint_called(const scene::Scene& stage, const std::string& name) {
  std::vector<std::string_view> known{every_joint};
  for (std::size_t row = 0; row < stage.joints.size(); ++row) {
    if (stage.joints[row].name == name) return row;
    known.push_back(stage.joints[row].name);
  }
  return catalog::unknown_name("usage.bad_flag", "--joint", "joint", name, known);
}

bool has_state(const scene::SceneJoint& joint, const std::string& name) {
  return std::ranges::any_of(joint.states,
                             [&](const assets::JointState& s) { return s.name == name; });
}

Result<void> put_joint(const scene::Scene& stage,
                       const std::string& flag,
                       std::vector<double>& positions) {
  const std::size_t equals = flag.find('=');
  if (equals == std::string::npos)
    return Error{"usage.bad_flag",
                 "--joint",
                 fmt::format("\"{}\" has no position; write NAME=STATE or NAME=NUMBER", flag)};
  const std::string name = flag.substr(0, equals), where = flag.substr(equals + 1);
  if (name != every_joint) {
    MARKETGEN_TRY(const std::size_t row, joint_called(stage, name));
    MARKETGEN_TRY(positions[row], scene::joint_position(stage.joints[row], where));
    return {};
  }
  for (std::size_t row = 0; row < positions.size(); ++row) {
    if (!has_state(stage.joints[row], where)) continue;
    MARKETGEN_TRY(positions[row], scene::joint_position(stage.joints[row], where));
  }
  return {};
}

}  // namespace

Result<void> show_fixture(const catalog::FixtureKind& kind,
                          const catalog::Catalog& catalog,
                          const FixtureView& view,
                          io::Outputs& outputs) {
  MARKETGEN_TRY(scene::Scene stage, scene::stage_fixture(kind, catalog));
  std::vector<double> positions(stage.joints.size(), 0);
  for (const std::string& flag : view.joints)
    MARKETGEN_CHECK(put_joint(stage, flag, positions));
  fmt::print("{}", io::write_json(ShownFixture{{kind}, stage.joints}));
  if (view.picture.empty()) return {};
  MARKETGEN_TRY(const Image picture,
                render::draw_fixture(scene::scene_at(std::move(stage), positions), view.size_px));
  return outputs.put(view.picture,
                     [&](const auto& file) { return io::write_picture(file, picture); });
}

}  // namespace marketgen::app
