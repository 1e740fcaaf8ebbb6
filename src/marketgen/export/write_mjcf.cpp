#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numbers>
#include <optional>

#include "base/text.h"
#include "export/exporter.h"
#include "export/licences.h"
#include "export/mjcf.h"
#include "export/mjcf_fixtures.h"
#include "export/mjcf_goods.h"
#include "export/mjcf_looks.h"
#include "export/mjcf_robot.h"
#include "export/mjcf_text.h"
#include "physics/goods/contact_shape.h"
#include "physics/world/shell_pieces.h"
#include "render/cameras/camera.h"
#include "scene/placements.h"

namespace marketgen::exporters {
namespace {

constexpr int lights_along = 4, lights_across = 2;  // MuJoCo's renderer takes eight
constexpr double flat_views_from = 20;              // times the room's longer side
constexpr int base_memory_mb = 64;  // measured: 20,000 still geoms, robot and contacts
constexpr std::string_view floor_color = "0.72 0.71 0.69 1", wall_color = "0.9 0.88 0.84 1",
                           door_color = "0.55 0.57 0.6 1";

class MjcfWriter {
 public:
  MjcfWriter(const scene::Scene& scene, const ExportOptions& options)
      : scene_(scene), options_(options), free_(products_in_free_region(scene, options)) {}

  Result<ExportFiles> write() {
    if (options_.looks) {
      MARKETGEN_TRY(looks_, MjcfLooks::make(scene_));
    }
    MARKETGEN_TRY(robots_, mjcf_robots(options_.robots));
    MARKETGEN_TRY(goods_, MjcfGoods::make(scene_, free_));
    out_.line(0, "<mujoco model=\"{}\">", escaped_markup(scene_.layout.name));
    write_header();
    write_assets();
    write_defaults();
    out_.line(1, "<worldbody>");
    write_lights();
    write_cameras();
    write_room();
    write_mjcf_fixtures(out_, scene_, options_);
    for (std::uint32_t row = 0; row < scene_.products.size(); ++row)
      write_product(row);
    write_robots();
    out_.line(1, "</worldbody>");
    write_hooks();
    write_mjcf_joint_numbers(out_, scene_, options_);
    write_start();
    out_.line(0, "</mujoco>");
    return files();
  }

 private:
  Vec3 room_size() const {
    const plan::Shell& shell = scene_.layout.shell;
    return {shell.width_mm * 1e-3, shell.depth_mm * 1e-3, shell.ceiling_mm * 1e-3};
  }

  void write_header() {
    const auto free = std::ranges::count(free_, true);
    const Vec3 room = room_size();
    out_.line(
        1,
        "<compiler angle=\"radian\" balanceinertia=\"true\"{}/>",
        options_.looks ? fmt::format(" assetdir=\"{}\"", escaped_markup(options_.beside)) : "");
    out_.line(1,
              "<option timestep=\"{}\" integrator=\"implicitfast\" cone=\"elliptic\" "
              "impratio=\"{}\" noslip_iterations=\"{}\"/>",
              physics::time_step_s,
              physics::friction_impedance_ratio,
              physics::noslip_iterations);
    out_.line(1, "<size memory=\"{}M\"/>", base_memory_mb + free);
    out_.line(1,
              "<statistic center=\"{}\" extent=\"{}\" meansize=\"0.1\"/>",
              xml_vector({room.x / 2, room.y / 2, 1}),
              static_cast<float>(std::max(room.x, room.y) * 0.6));
    out_.line(1, "<visual>");
    out_.line(2, "<global azimuth=\"60\" elevation=\"-40\" offwidth=\"1920\" offheight=\"1080\"/>");
    out_.line(
        2, "<headlight ambient=\"0.45 0.45 0.45\" diffuse=\"0.25 0.25 0.25\" specular=\"0 0 0\"/>");
    out_.line(2, "<map znear=\"0.005\" zfar=\"50\"/>");
    out_.line(1, "</visual>");
  }

  void write_assets() {
    out_.line(1, "<asset>");
    goods_->write_assets(out_);
    if (options_.looks) looks_.write_assets(out_);
    for (const MjcfRobot& robot : robots_)
      out_.line(2,
                "<model name=\"{0}\" file=\"{1}/{0}.xml\"/>",
                robot.name,
                escaped_markup(options_.beside));
    out_.line(1, "</asset>");
  }

  void write_defaults() {
    out_.line(1, "<default>");
    out_.line(2, "<mesh inertia=\"shell\"/>");  // looks have no mass; some enclose no volume either
    out_.line(2,
              "<geom friction=\"{} {} {}\" solref=\"{} 1\"/>",
              physics::still_friction,
              physics::torsional_friction_m,
              physics::plain_rolling_friction_m,
              physics::contact_time_s);
    out_.line(2,
              "<default class=\"shell\"><geom type=\"box\" group=\"{}\" rgba=\"{}\"/></default>",
              static_cast<int>(group_shell),
              wall_color);
    out_.line(2,
              "<default class=\"fixture\"><geom type=\"box\" group=\"{}\"/></default>",
              static_cast<int>(group_fixture));
    out_.line(2, "<default class=\"product\">");
    out_.line(
        3, "<geom group=\"{}\"/>", static_cast<int>(options_.looks ? group_solid : group_product));
    goods_->write_defaults(out_);
    out_.line(2, "</default>");
    if (options_.looks) looks_.write_defaults(out_);
    out_.line(1, "</default>");
  }

  void write_lights() {
    const Vec3 room = room_size();
    for (int x = 0; x < lights_along; ++x) {
      for (int y = 0; y < lights_across; ++y) {
        const Vec3 at{
            room.x * (x + 0.5) / lights_along, room.y * (y + 0.5) / lights_across, room.z - 0.05};
        out_.line(2,
                  "<light name=\"light-{}\" pos=\"{}\" dir=\"0 0 -1\" cutoff=\"85\" exponent=\"1\" "
                  "diffuse=\"0.25 0.25 0.24\" specular=\"0.05 0.05 0.05\" castshadow=\"false\"/>",
                  x * lights_across + y,
                  xml_vector(at));
      }
    }
  }

  // No word for an orthographic camera is known to all of MuJoCo 3.3 to 4 (orthographic=
  // before 3.5, projection= since): what is drawn flat is seen from far off, where a metre of
  // height moves what stands at the picture's edge by less than 3 % of a metre.
  void write_cameras() {
    const double widest = std::max(room_size().x, room_size().y);
    for (const render::Camera& camera : render::standard_cameras(scene_, 1280, 720)) {
      const Vec3 back = normalized(camera.from - camera.at);
      const Vec3 up = std::abs(back.z) > 0.999 ? Vec3{0, 1, 0}
                                               : Vec3{0, 0, 1};  // north is up in views from above
      const Vec3 right = normalized(cross(up, back)), above = cross(back, right);
      const double flat_m = camera.ortho_height_m / 2, far_m = flat_views_from * widest;
      const bool flat = flat_m > 0;
      out_.line(2,
                "<camera name=\"{}\" pos=\"{}\" xyaxes=\"{} {}\" fovy=\"{}\"/>",
                escaped_markup(camera.name),
                xml_vector(flat ? camera.at + back * far_m : camera.from),
                xml_vector(right),
                xml_vector(above),
                static_cast<float>(flat ? 2 * std::atan2(flat_m, far_m) * 180 / std::numbers::pi
                                        : camera.fov_deg));
    }
  }

  void write_room() {
    const Vec3 room = room_size();
    const std::string ground =
        looks_.floor().empty() ? fmt::format("rgba=\"{}\"", floor_color)
                               : fmt::format("material=\"{}\" rgba=\"1 1 1 1\"", looks_.floor());
    out_.line(
        2,
        "<geom name=\"floor\" class=\"shell\" type=\"plane\" size=\"{} {} 0.1\" pos=\"{}\" {}/>",
        static_cast<float>(room.x / 2),
        static_cast<float>(room.y / 2),
        xml_vector({room.x / 2, room.y / 2, 0}),
        ground);
    for (const physics::ShellPiece& piece : physics::shell_pieces(scene_.layout.shell)) {
      const std::string look = piece.kind == physics::ShellPieceKind::door
                                   ? fmt::format(" rgba=\"{}\"", door_color)
                               : piece.kind == physics::ShellPieceKind::pane
                                   ? fmt::format(" rgba=\"0.8 0.9 0.9 {}\"", mjcf_glass_alpha)
                                   : "";
      out_.line(2,
                "<geom name=\"{}\" class=\"shell\"{} size=\"{}\"{}/>",
                piece.id,
                mjcf_pose(piece.pose),
                xml_vector(piece.half_size),
                look);
    }
  }

  void write_product(std::uint32_t row) {
    const scene::SceneProduct& item = scene_.products[row];
    const std::string& sku = scene_.catalog[item.sku].sku;
    const Pose world_from_item = scene::world_from_product(item);
    if (!free_[row]) {
      goods_->write_standing(out_, row);
      if (options_.looks)
        out_.line(2, "<geom class=\"look/{}\"{}/>", sku, mjcf_pose(world_from_item));
      return;
    }
    out_.line(
        2, "<body name=\"{}\"{}>", scene::product_id(scene_, row), mjcf_pose(world_from_item));
    goods_->write_free(out_, row);
    if (options_.looks) out_.line(3, "<geom class=\"look/{}\"/>", sku);
    out_.line(2, "</body>");
  }

  void write_robots() {
    for (const MjcfRobot& robot : robots_) {
      out_.line(2, "<frame{}>", mjcf_pose(robot.world_from_base));
      out_.line(3,
                "<attach model=\"{}\" body=\"{}\" prefix=\"{}\"/>",
                robot.name,
                robot.base,
                robot.prefix);
      out_.line(2, "</frame>");
    }
  }

  // Whose names are robots', for readers; and the drives' targets, without which every joint would
  // be driven to 0.
  void write_start() {
    if (robots_.empty()) return;
    std::string prefixes, targets;
    for (const MjcfRobot& robot : robots_) {
      prefixes += (prefixes.empty() ? "" : " ") + robot.prefix;
      for (const double target : robot.start)
        targets += fmt::format("{}{}", targets.empty() ? "" : " ", static_cast<float>(target));
    }
    out_.line(1, "<custom><text name=\"{}\" data=\"{}\"/></custom>", mjcf_robots_text, prefixes);
    out_.line(1, "<keyframe><key name=\"start\" ctrl=\"{}\"/></keyframe>", targets);
  }

  ExportFiles files() {
    ExportFiles files{out_.take(), looks_.files()};
    if (options_.looks) files.beside.push_back(licences_file(scene_));
    for (const MjcfRobot& robot : robots_)
      files.beside.insert(files.beside.end(), robot.files.begin(), robot.files.end());
    return files;
  }

  // Free goods on pegs hang from the middle of their upper edge; a robot takes one by switching its
  // constraint off.
  void write_hooks() {
    out_.line(1, "<equality>");
    for (std::uint32_t row = 0; row < scene_.products.size(); ++row) {
      const scene::SceneProduct& item = scene_.products[row];
      if (!free_[row] || !hangs_on_peg(scene_, row)) continue;
      const std::string id = scene::product_id(scene_, row);
      out_.line(2,
                "<connect name=\"hook/{0}\" body1=\"{0}\" anchor=\"{1}\"/>",
                id,
                xml_vector({0, 0, scene_.catalog[item.sku].height_m()}));
    }
    out_.line(1, "</equality>");
  }

  const scene::Scene& scene_;
  const ExportOptions& options_;
  std::vector<bool> free_;
  std::optional<MjcfGoods> goods_;  // from write() on
  MjcfLooks looks_;                 // none without options.looks
  std::vector<MjcfRobot> robots_;
  XmlText out_;
};

}  // namespace

Result<ExportFiles> write_mjcf(const scene::Scene& scene, const ExportOptions& options) {
  return MjcfWriter(scene, options).write();
}

}  // namespace marketgen::exporters
