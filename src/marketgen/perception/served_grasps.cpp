#include "perception/served_grasps.h"

#include <cmath>

#include <nlohmann/json.hpp>

#include "perception/grasp_answer.h"
#include "perception/picture_part.h"

namespace marketgen::perception {
namespace {

using Json = nlohmann::json;

constexpr double round_product_m = 0.08;  // that is sent with it
constexpr double near_product_m = 0.03;   // of its bounds; what is proposed farther off is not its
constexpr double depth_units_a_m = 1000;  // millimetres, as the published client sends them
constexpr std::size_t max_proposals = 64, max_served = 8;  // checked; taken

// A ball that holds the product, in the views' frame.
struct Ball {
  Vec3 middle;
  double radius_m = 0;
};

Ball ball_round(const agent::KnownProduct& known, const Pose& views_from_product) {
  double radius_m = 0;
  for (const int size_mm : known.product.size_mm)
    radius_m += 0.25e-6 * size_mm * size_mm;
  return {views_from_product * to_double(known.body.center_of_mass), std::sqrt(radius_m)};
}

// What a picture shows of it and of what is round it.
struct ShownPart {
  const ViewCloud* view = nullptr;
  PicturePart part;
  std::size_t pixels = 0;  // of the product, about
};

ShownPart part_of_view(const ViewCloud& view, const Ball& ball) {
  ShownPart shown{&view, {}, 0};
  for (std::size_t i = 0; i < view.size(); ++i) {
    if (!view.has(i)) continue;
    const double off = length(to_double(view.point(i)) - ball.middle);
    if (off > ball.radius_m + round_product_m) continue;
    shown.part.add(static_cast<int>(i) % view.width(), static_cast<int>(i) / view.width());
    if (off < ball.radius_m) ++shown.pixels;
  }
  return shown;
}

// The picture that shows most of it; `pixels` is 0 when none does.
ShownPart best_shown(const std::vector<ViewCloud>& views, const Ball& ball) {
  ShownPart best;
  for (const ViewCloud& view : views) {
    const ShownPart shown = part_of_view(view, ball);
    if (shown.pixels > best.pixels) best = shown;
  }
  return best;
}

PartServer::Question question_of(const ShownPart& shown) {
  const auto& [view, part, pixels] = shown;
  const agent::View& whole = view->view();
  Json colors = Json::array(), depths = Json::array();
  for (int y = part.top; y <= part.bottom; ++y) {
    Json color_row = Json::array(), depth_row = Json::array();
    for (int x = part.left; x <= part.right; ++x) {
      const std::uint8_t* at = whole.color.at(x, y);
      color_row.push_back({at[0], at[1], at[2]});
      const double depth_m = whole.depth_m[view->index(x, y)];
      depth_row.push_back(std::round(depth_m * depth_units_a_m * 10) / 10);
    }
    colors.push_back(std::move(color_row));
    depths.push_back(std::move(depth_row));
  }
  const Json body{{"colors", std::move(colors)},
                  {"depths", std::move(depths)},
                  {"fx", whole.lens.fx},
                  {"fy", whole.lens.fy},
                  {"cx", whole.lens.cx - part.left},
                  {"cy", whole.lens.cy - part.top},
                  {"scale", depth_units_a_m},
                  {"dense_mode", true}};
  return {"application/json", body.dump()};
}

// In the product's frame, best first; empty when the server says nothing of use.
std::vector<motion::PinchProposal> proposals_of(PartServer& server,
                                                const robots::GraspTool& tool,
                                                const agent::KnownProduct& known,
                                                const Pose& base_from_product,
                                                const SeenIn& seen_in) {
  if (seen_in.views == nullptr) return {};
  const Pose views_from_product = inverse(seen_in.base_from_views) * base_from_product;
  const Ball ball = ball_round(known, views_from_product);
  const ShownPart shown = best_shown(*seen_in.views, ball);
  if (shown.pixels == 0) return {};
  std::vector<NetworkGrasp> grasps;
  server.ask(question_of(shown), [&](const std::string& answer) -> Result<void> {
    MARKETGEN_TRY(grasps, read_grasps(answer));
    return {};
  });
  const Pose product_from_camera =
      inverse(views_from_product) * shown.view->view().base_from_camera;
  std::vector<motion::PinchProposal> proposals;
  for (const NetworkGrasp& grasp : grasps) {
    // Fingers' ends lie where it says.
    const Vec3 pads = grasp.center + grasp.approach * (grasp.depth_m - tool.pad_z_m);
    const Vec3 center = product_from_camera * pads;
    const double off = length(views_from_product * center - ball.middle);
    if (!(off <= ball.radius_m + near_product_m) || proposals.size() >= max_proposals) continue;
    proposals.push_back({center,
                         rotate(product_from_camera.rotation, grasp.approach),
                         rotate(product_from_camera.rotation, grasp.closing)});
  }
  return proposals;
}

// The server's few, then the program's own.
template <class Worth>
Result<std::vector<SeenGrasp>> before_own(Result<std::vector<motion::CheckedPinch>> checked,
                                          Result<std::vector<SeenGrasp>> own,
                                          const Worth& worth) {
  MARKETGEN_CHECK(own);
  MARKETGEN_CHECK(checked);
  std::vector<SeenGrasp> grasps;
  for (const motion::CheckedPinch& pinch : *checked) {
    if (grasps.size() >= max_served) break;
    grasps.push_back(worth(pinch.candidate));
    grasps.back().proposed = true;
  }
  grasps.insert(grasps.end(), own->begin(), own->end());
  return grasps;
}

}  // namespace

Result<std::vector<SeenGrasp>> ServedGrasps::grasps(const GraspQuestion& question) const {
  agent::Workplace place = place_;
  place.base_from_basket = question.base_from_basket;
  const skills::LyingPack pack = lying_pack(question, place);
  const auto proposals =
      proposals_of(*server_, tool_, question.known, question.base_from_product, question.seen_in);
  return before_own(
      skills::checked_from_above(pack, tool_, skills::wall_obstacles(place), proposals),
      offline_.grasps(question),
      [&](const motion::GraspCandidate& candidate) {
        return with_intrusion({skills::lifting_grasp(pack, candidate)}, tool_, question.others);
      });
}

Result<std::vector<SeenGrasp>> ServedShelfGrasps::grasps(const ShelfGraspQuestion& question) const {
  const auto proposals =
      proposals_of(*server_, tool_, question.known, question.base_from_product, question.seen_in);
  motion::GraspQuery query = query_from_front(question);
  query.finger_gap_m = motion::wedge_gap_m;
  return before_own(
      motion::check_pinches(question.known.product, question.known.body, tool_, query, proposals),
      offline_.grasps(question),
      [&](const motion::GraspCandidate& candidate) {
        return shelf_grasp(question, candidate, tool_);
      });
}

}  // namespace marketgen::perception
