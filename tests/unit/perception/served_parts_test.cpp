// Parts of the manipulation system in servers: what they say is read as published, what they may
// say wrong is worth no more than nothing, and then the program's own part stands in.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "motion/grasp_surface.h"
#include "perception/grasp_answer.h"
#include "perception/mask_answer.h"
#include "perception/served_grasps.h"
#include "perception/served_masks.h"
#include "support/committed_robot.h"
#include "support/drawn_boxes.h"
#include "support/mock_server.h"

namespace marketgen {
namespace {

using nlohmann::json;

std::vector<std::vector<std::uint32_t>> pixels_of(
    const Result<std::vector<perception::Mask>>& read) {
  std::vector<std::vector<std::uint32_t>> all;
  if (!read.ok()) return {{4'000'000'000U}};
  for (const perception::Mask& mask : *read)
    all.push_back(mask.pixels);
  return all;
}

TEST(MaskAnswer, IsReadInEveryFormThatIsPublished) {
  // 4 x 3 pixels, of which (1, 0), (1, 1) and (2, 1) are set.
  const std::vector<std::vector<std::uint32_t>> expected{{1, 5, 6}};
  const std::vector<std::string> forms{
      R"({"masks": [{"segmentation": [[false,true,false,false],[false,true,true,false],
          [false,false,false,false]], "area": 3}]})",
      R"({"masks": [{"area": 3, "segmentation": [[0,1,0,0],[0,1,1.0,0],[0,0,0,0]], "point": [[1, 2]]}],
          "seconds": 0.2})",
      R"({"masks": [{"segmentation": {"size": [3, 4], "counts": [3, 2, 2, 1, 4]}}]})",
      // pycocotools.mask.encode of the same.
      R"({"masks": [{"bbox": [1,0,2,2], "segmentation": {"counts": "322O2", "size": [3, 4]}}]})"};
  for (const std::string& form : forms)
    EXPECT_EQ(pixels_of(perception::read_masks(form, 4, 3)), expected) << form;
}

TEST(MaskAnswer, NothingThereIsAnAnswer) {
  EXPECT_TRUE(pixels_of(perception::read_masks(R"({"masks": []})", 4, 3)).empty());
  EXPECT_TRUE(pixels_of(perception::read_masks(
                            R"({"masks": [{"segmentation": [[0,0],[0,0]]}, {"area": 7}]})", 2, 2))
                  .empty());
}

TEST(MaskAnswer, WhatIsNoneSaysWhy) {
  const std::vector<std::pair<std::string, std::string>> cases{
      {"", "no JSON"},
      {"[]", "no list"},
      {R"({"error": "out of memory"})", "no list"},
      {R"({"masks": 3})", "no list"},
      {R"({"masks": [{"segmentation": [[NaN]]}]})", "no JSON"},
      {R"({"masks": [{"segmentation": [[true]]}]})", "a row of 1"},
      {R"({"masks": [{"segmentation": [[true,true]]}]})", "1 rows"},
      {R"({"masks": [{"segmentation": [[true,true],[true,true],[true,true]]}]})", "larger than"},
      {R"({"masks": [{"segmentation": [["yes","no"],["no","no"]]}]})", "neither true nor false"},
      {R"({"masks": [{"segmentation": {"counts": [1, 1, 2]}}]})", "without \"size\""},
      {R"({"masks": [{"segmentation": {"size": [2, 2], "counts": [1, 9]}}]})", "beyond"},
      {R"({"masks": [{"segmentation": {"size": [2, 2], "counts": [-1, 2]}}]})", "beyond"},
      {R"({"masks": [{"segmentation": {"size": [2, 2], "counts": "~~~~~~~~~~~~~~"}}]})", "beyond"},
      {R"({"masks": [{"segmentation": {"size": [2, 2], "counts": [1, 1.0, 2]}}]})", "whole number"},
      {R"({"masks": [{"segmentation": {"size": [2, 2], "counts": [1, null]}}]})", "whole number"},
      {R"({"masks": [{"segmentation": {"size": [2, 2], "counts": [0,0,0,0,0,0,0]}}]})", "beyond"},
      {R"({"masks": [{"segmentation": {"size": [2, 2], "counts": "00000000"}}]})", "beyond"},
      {R"({"masks": [{"segmentation": {"size": [2, 2], "counts": "pppppppppppppppppppppp0"}}]})",
       "beyond"},
      {R"({"masks": [{"segmentation": [[1, 0]],
          "segmentation": {"size": [2, 2], "counts": [0, 4]}}]})",
       "two forms"},
      {std::string(100, '['), "nested"}};
  for (const auto& [text, why] : cases) {
    const auto read = perception::read_masks(text, 2, 2);
    ASSERT_FALSE(read.ok()) << text;
    EXPECT_EQ(read.error().code, "perception.bad_answer") << text;
    EXPECT_NE(read.error().message.find(why), std::string::npos) << read.error().message;
  }
}

TEST(GraspAnswer, RowsAndObjectsAreTheSame) {
  const json row = json::parse("[0.9, 0.05, 0.02, 0.03, 0,-1,0, 0,0,-1, 1,0,0, 0.1,0.2,0.5, 7]");
  const json object = json::parse(R"({"score": 0.8, "width": 0.05, "depth": 0.03,
      "rotation_matrix": [[0,-1,0],[0,0,-1],[1,0,0]], "translation": [0.1,0.2,0.5]})");
  const auto read = perception::read_grasps(json{{"grasp_groups", {object, row}}}.dump());
  ASSERT_TRUE(read.ok()) << to_string(read.error());
  ASSERT_EQ(read->size(), 2U);
  EXPECT_EQ((*read)[0].score, 0.9) << "best first";
  for (const perception::NetworkGrasp& grasp : *read) {
    EXPECT_LT(length(grasp.approach - Vec3{0, 0, 1}), 1e-9);
    EXPECT_LT(length(grasp.closing - Vec3{-1, 0, 0}), 1e-9);
    EXPECT_LT(length(grasp.center - Vec3{0.1, 0.2, 0.5}), 1e-9);
    EXPECT_EQ(grasp.depth_m, 0.03);
    EXPECT_EQ(grasp.width_m, 0.05);
  }
}

TEST(GraspAnswer, WhatIsNoGraspIsLeftOut) {
  const json good = json::parse("[0.9, 0.05, 0.02, 0.03, 0,-1,0, 0,0,-1, 1,0,0, 0.1,0.2,0.5, 7]");
  json skewed = good, long_hand = good, short_row = good;
  skewed[4] = 0.5;
  long_hand[3] = 7;
  short_row.erase(16);
  const json bad{skewed, long_hand, short_row, "grasp", nullptr, json::object(), 3};
  json mixed = bad;
  mixed.push_back(good);
  EXPECT_EQ(perception::read_grasps(json{{"grasp_groups", mixed}}.dump())->size(), 1U);
  for (const std::string& text : {json{{"grasp_groups", bad}}.dump(),
                                  std::string("{\"grasp_groups\": [[NaN]]}"),
                                  std::string("{}"),
                                  std::string("[]"),
                                  std::string("{\"grasp_groups\": {}}")}) {
    const auto read = perception::read_grasps(text);
    ASSERT_FALSE(read.ok()) << text;
    EXPECT_EQ(read.error().code, "perception.bad_answer");
  }
  EXPECT_FALSE(
      perception::read_grasps("{\"grasp_groups\": [" + std::string(17 << 20, ' ') + "]}").ok());
  EXPECT_TRUE(perception::read_grasps("{\"grasp_groups\": []}")->empty());
}

// ---- With a server ----

constexpr int picture_width = 160, picture_height = 120;

// A carton of 60 x 40 x 120 mm that stands on the origin, seen from above and before it.
agent::View carton_view() {
  const DrawnBox carton{{},
                        {0.06, 0.04, 0.12},
                        {{{200, 30, 30},
                          {30, 200, 30},
                          {30, 30, 200},
                          {200, 200, 30},
                          {30, 200, 200},
                          {200, 30, 200}}}};
  const DrawnBox table{{{0, 0, -0.1}, {}}, {0.5, 0.5, 0.1}, {}};
  const Vec3 ahead = normalized(Vec3{0, 0.35, -0.4});
  const Vec3 down = normalized(cross(ahead, Vec3{1, 0, 0}));
  return drawn_view({carton, table},
                    {{0, -0.35, 0.46}, rotation_with_axes(down, ahead)},
                    picture_width,
                    picture_height,
                    200);
}

std::vector<std::uint8_t> goods_over_table(const perception::ViewCloud& cloud) {
  std::vector<std::uint8_t> wanted(cloud.size());
  for (std::size_t i = 0; i < cloud.size(); ++i)
    wanted[i] = cloud.has(i) && cloud.point(i).z > 0.01F ? 1 : 0;
  return wanted;
}

std::shared_ptr<perception::PartServer> server_at(const std::string& url,
                                                  const char* path,
                                                  double total_s = 20) {
  net::HttpOptions options;
  options.limits.total_s = total_s;
  options.limits.attempts = 1;
  return std::make_shared<perception::PartServer>(
      url, path, std::make_shared<net::HttpClient>(net::HttpClient::open(options).value()));
}

perception::ServedMasks served_masks(const std::shared_ptr<perception::PartServer>& server) {
  return {server, std::make_unique<perception::GeometricMasks>()};
}

std::vector<std::vector<std::uint32_t>> pixels_of(const std::vector<perception::Mask>& masks) {
  std::vector<std::vector<std::uint32_t>> all;
  for (const perception::Mask& mask : masks)
    all.push_back(mask.pixels);
  return all;
}

// The part that is sent, with a margin of 24 pixels.
std::array<int, 4> part_of(const perception::ViewCloud& cloud,
                           const std::vector<std::uint8_t>& wanted) {
  int left = picture_width, right = 0, top = picture_height, bottom = 0;
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    if (wanted[i] == 0) continue;
    const int x = static_cast<int>(i) % cloud.width(), y = static_cast<int>(i) / cloud.width();
    left = std::min(left, x), right = std::max(right, x);
    top = std::min(top, y), bottom = std::max(bottom, y);
  }
  left = std::max(0, left - 24), top = std::max(0, top - 24);
  return {left,
          top,
          std::min(picture_width - 1, right + 24) - left + 1,
          std::min(picture_height - 1, bottom + 24) - top + 1};
}

TEST(ServedMasks, AreThoseOfTheServerAndItsOwnWhereItLeftOut) {
  const perception::ViewCloud cloud(carton_view());
  const std::vector<std::uint8_t> wanted = goods_over_table(cloud);
  const auto [left, top, width, height] = part_of(cloud, wanted);
  // Everything in the upper half of what is sent.
  json rows = json::array();
  for (int y = 0; y < height; ++y)
    rows.push_back(json(std::vector<bool>(static_cast<std::size_t>(width), y < height / 2)));
  const MockServer mock(
      json::array({{{"body", {{"masks", {{{"segmentation", rows}, {"area", 5}}}}}},
                    {"expect", {{"method", "POST"}, {"path", "/generate_masks"}}}}}));
  const auto server = server_at(mock.url(), perception::mask_server_path);
  const std::vector<perception::Mask> masks = served_masks(server).masks(cloud, wanted);
  EXPECT_EQ(server->use().answered, 1);
  EXPECT_EQ(server->use().offline, 0);
  const std::string sent = mock.requests().at(0)["body"].get<std::string>();
  EXPECT_NE(sent.find("name=\"image\"; filename=\"image.png\""), std::string::npos);
  EXPECT_NE(sent.find("coco_rle"), std::string::npos);
  std::vector<int> covered(cloud.size());
  std::size_t upper = 0;
  for (const perception::Mask& mask : masks) {
    bool all_upper = true;
    for (const std::uint32_t pixel : mask.pixels) {
      ++covered[pixel];
      all_upper &= static_cast<int>(pixel) / picture_width < top + height / 2;
    }
    if (all_upper) upper = std::max(upper, mask.pixels.size());
  }
  std::vector<int> own(cloud.size());
  for (const perception::Mask& mask : perception::GeometricMasks().masks(cloud, wanted))
    for (const std::uint32_t pixel : mask.pixels)
      own[pixel] = 1;
  std::size_t wanted_upper = 0, missed = 0, doubled = 0, wanted_all = 0;
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    wanted_upper +=
        wanted[i] != 0 && static_cast<int>(i) / picture_width < top + height / 2 ? 1U : 0U;
    wanted_all += wanted[i];
    missed += own[i] != 0 && covered[i] == 0 ? 1U : 0U;
    doubled += covered[i] > 1 || (covered[i] > 0 && wanted[i] == 0) ? 1U : 0U;
  }
  EXPECT_EQ(upper, wanted_upper) << "the server's mask, of what is wanted alone";
  EXPECT_EQ(doubled, 0U);
  EXPECT_LT(missed, wanted_all / 20) << "the rest is its own";
}

TEST(ServedMasks, WhateverAServerSaysWrongItsOwnStandIn) {
  const perception::ViewCloud cloud(carton_view());
  const std::vector<std::uint8_t> wanted = goods_over_table(cloud);
  const auto own = pixels_of(perception::GeometricMasks().masks(cloud, wanted));
  ASSERT_FALSE(own.empty());
  const json many(100'000, json{{"segmentation", json::array()}});
  struct Case {
    json step;
    int agent::PartUse::*counted;
  };
  const std::vector<Case> cases{
      {{{"status", 500}, {"body", "out of memory"}}, &agent::PartUse::refused},
      {{{"body", "NaN"}}, &agent::PartUse::bad_answer},
      {{{"body", {{"masks", {{{"segmentation", {{true}}}}}}}}}, &agent::PartUse::bad_answer},
      {{{"drop", true}}, &agent::PartUse::unreachable},
      {{{"delay_s", 3}, {"body", {{"masks", json::array()}}}}, &agent::PartUse::timed_out},
      {{{"body", {{"masks", json::array()}}}}, &agent::PartUse::answered},
      {{{"body", {{"masks", many}}}}, &agent::PartUse::answered}};
  for (const Case& each : cases) {
    const MockServer mock(json::array({each.step}));
    const auto server = server_at(mock.url(), perception::mask_server_path, 1.5);
    EXPECT_EQ(pixels_of(served_masks(server).masks(cloud, wanted)), own)
        << each.step.dump().substr(0, 80);
    EXPECT_EQ(server->use().*each.counted, 1) << each.step.dump().substr(0, 80);
    EXPECT_EQ(server->use().questions, 1);
  }
}

TEST(ServedMasks, AServerThatFailsThriceIsLeftAlone) {
  const perception::ViewCloud cloud(carton_view());
  const std::vector<std::uint8_t> wanted = goods_over_table(cloud);
  const auto server = server_at("http://127.0.0.1:9/masks", perception::mask_server_path);
  for (int i = 0; i < 5; ++i)
    served_masks(server).masks(cloud, wanted);
  EXPECT_EQ(server->use().unreachable, 3);
  EXPECT_EQ(server->use().skipped, 2);
  EXPECT_EQ(server->use().offline, 5);
  EXPECT_EQ(server->use().questions, 3);
}

agent::KnownProduct carton() {
  agent::KnownProduct known;
  known.product.sku = "test-carton";
  known.product.mass_kg = 0.2;
  known.product.size_mm = {60, 40, 120};
  known.body.center_of_mass = {0, 0, 0.06F};
  known.body.pieces.push_back({.shape = assets::PieceShape::box,
                               .center = {0, 0, 0.06F},
                               .half_size = {0.03F, 0.02F, 0.06F}});
  return known;
}

// A row of 17 for a grasp straight down on the carton, closing along its depth, in the camera's
// frame.
json row_at(const agent::View& view, Vec3 fingers_end, double score) {
  const Pose back = inverse(view.base_from_camera);
  const Vec3 ahead = rotate(back.rotation, {0, 0, -1}), closing = rotate(back.rotation, {0, 1, 0});
  const Vec3 third = cross(ahead, closing);
  const double depth_m = 0.02;
  const Vec3 center = back * fingers_end - ahead * depth_m;
  return {score,
          0.06,
          0.02,
          depth_m,
          ahead.x,
          closing.x,
          third.x,
          ahead.y,
          closing.y,
          third.y,
          ahead.z,
          closing.z,
          third.z,
          center.x,
          center.y,
          center.z,
          -1};
}

TEST(ServedGrasps, ThoseThatHoldTheProductComeFirstInTheServersOrder) {
  const robots::GraspTool hand = robots::load_grasp_tool(committed_rows, "panda-hand").value();
  const agent::Workplace place;
  const agent::KnownProduct known = carton();
  std::vector<perception::ViewCloud> views;
  views.emplace_back(carton_view());
  const agent::View& view = views[0].view();
  const Vec3 good{0.01, 0, 0.09}, better{-0.01, 0, 0.085}, beside{0.2, 0, 0.09};
  const MockServer mock(json::array(
      {{{"expect", {{"path", "/process"}}},
        {"body",
         {{"grasp_groups",
           {row_at(view, good, 0.4), row_at(view, beside, 0.9), row_at(view, better, 0.5)}}}}}}));
  const auto server = server_at(mock.url(), perception::grasp_server_path);
  const perception::GraspQuestion question{known, {}, {{0, 5, 0}, {}}, {}, {&views}};
  const auto served = perception::ServedGrasps(hand, place, server).grasps(question);
  const auto own = perception::FittedGrasps(hand, place).grasps(question);
  ASSERT_TRUE(served.ok() && own.ok());
  ASSERT_EQ(served->size(), own->size() + 2) << "the one beside it holds nothing";
  const auto ends_at = [&](const perception::SeenGrasp& grasp) {
    return grasp.base_from_tip * Vec3{0, 0, hand.pad_center.z + hand.pad_z_m};
  };
  EXPECT_LT(length(ends_at((*served)[0]) - better), 0.002);
  EXPECT_LT(length(ends_at((*served)[1]) - good), 0.002);
  EXPECT_NEAR((*served)[0].width_m, 0.04, 0.001) << "as the product is, not as the server says";
  EXPECT_EQ((*served)[2].base_from_tip.position, (*own)[0].base_from_tip.position);
  EXPECT_TRUE((*served)[1].proposed);
  EXPECT_FALSE((*served)[2].proposed);
  // What was sent is a part of the picture, with the lens to go with it.
  const json sent = json::parse(mock.requests().at(0)["body"].get<std::string>());
  ASSERT_EQ(sent["colors"].size(), sent["depths"].size());
  const int shift_x = static_cast<int>(view.lens.cx - sent["cx"].get<double>());
  const int shift_y = static_cast<int>(view.lens.cy - sent["cy"].get<double>());
  const std::size_t y = sent["depths"].size() / 2, x = sent["depths"][y].size() / 2;
  const std::size_t pixel =
      views[0].index(shift_x + static_cast<int>(x), shift_y + static_cast<int>(y));
  EXPECT_NEAR(sent["depths"][y][x].get<double>(), 1000 * view.depth_m[pixel], 0.06);
  EXPECT_EQ(sent["colors"][y][x][0],
            view.color.at(shift_x + static_cast<int>(x), shift_y + static_cast<int>(y))[0]);
}

TEST(ServedGrasps, WithoutAnAnswerAreThoseThatItHadAnyway) {
  const robots::GraspTool hand = robots::load_grasp_tool(committed_rows, "panda-hand").value();
  const agent::Workplace place;
  const agent::KnownProduct known = carton();
  std::vector<perception::ViewCloud> views;
  views.emplace_back(carton_view());
  const auto server = server_at("http://127.0.0.1:9", perception::grasp_server_path);
  const auto own = perception::FittedGrasps(hand, place).grasps({known, {}, {}, {}});
  for (const perception::SeenIn& seen : {perception::SeenIn{&views}, perception::SeenIn{}}) {
    const auto served =
        perception::ServedGrasps(hand, place, server).grasps({known, {}, {}, {}, seen});
    ASSERT_TRUE(served.ok());
    EXPECT_EQ(served->size(), own->size());
  }
  EXPECT_EQ(server->use().unreachable, 1) << "without pictures nothing is sent";
}

TEST(ServedShelfGrasps, AskInTheFrameOfThePictures) {
  const robots::GraspTool gripper =
      robots::load_grasp_tool(committed_rows, "parallel-gripper").value();
  const agent::KnownProduct known = carton();
  std::vector<perception::ViewCloud> views;
  views.emplace_back(carton_view());
  // From the front, ends of the fingers at the carton's middle.
  const Pose back = inverse(views[0].view().base_from_camera);
  const Vec3 ahead = rotate(back.rotation, {0, 1, 0}), closing = rotate(back.rotation, {1, 0, 0});
  const Vec3 third = cross(ahead, closing), center = back * Vec3{0, -0.01, 0.06};
  const json row{0.5,
                 0.08,
                 0.02,
                 0.02,
                 ahead.x,
                 closing.x,
                 third.x,
                 ahead.y,
                 closing.y,
                 third.y,
                 ahead.z,
                 closing.z,
                 third.z,
                 center.x,
                 center.y,
                 center.z,
                 -1};
  const MockServer mock(json::array({{{"body", {{"grasp_groups", {row}}}}}}));
  const auto server = server_at(mock.url(), perception::grasp_server_path);
  const Pose store_from_base{{3, 4, 0}, {}};
  const perception::ShelfGraspQuestion question{
      known, store_from_base, {}, {&views, store_from_base}};
  const auto served = perception::ServedShelfGrasps(gripper, server).grasps(question);
  const auto own = perception::FrontGrasps(gripper).grasps(question);
  ASSERT_TRUE(served.ok() && own.ok());
  ASSERT_EQ(served->size(), own->size() + 1);
  const Vec3 end = (*served)[0].base_from_tip * Vec3{0, 0, gripper.pad_center.z + gripper.pad_z_m};
  EXPECT_LT(length(end - Vec3{3, 4.01, 0.06}), 0.002);
}

}  // namespace
}  // namespace marketgen
