// Pictures with numbered marks, and what a model makes of them: that numbers can be read and mean
// the masks that they stand on, and that no answer, however odd, is worse than having no model.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <numbers>

#include "perception/model_shelf.h"
#include "perception/model_targets.h"
#include "support/drawn_boxes.h"

namespace marketgen {
namespace {

constexpr Rgb8 juice_red{200, 40, 30}, box_green{40, 170, 60}, table_grey{120, 120, 120};
constexpr int view_width = 640, view_height = 480;

perception::Mask block(int left, int top, int side) {
  perception::Mask mask;
  for (int y = top; y < top + side; ++y)
    for (int x = left; x < left + side; ++x)
      mask.pixels.push_back(static_cast<std::uint32_t>(y * view_width + x));
  return mask;
}

perception::ViewCloud grey_view() {
  agent::View view;
  view.lens = {500, 500, 320, 240};
  view.color = Image(view_width, view_height);
  view.depth_m.assign(static_cast<std::size_t>(view_width) * view_height, 1.0F);
  return perception::ViewCloud(std::move(view));
}

bool chips_overlap(const perception::Mark& a, const perception::Mark& b) {
  return a.view == b.view && std::abs(a.x_px - b.x_px) < a.half_width_px + b.half_width_px &&
         std::abs(a.y_px - b.y_px) < a.half_height_px + b.half_height_px;
}

TEST(MarkedPictures, NumbersTheLargestFirstAtTheirMiddles) {
  std::vector<perception::ViewCloud> views{grey_view()};
  const std::vector<perception::MaskedView> masked{
      {0, {block(400, 300, 40), block(50, 50, 80), block(10, 400, 3)}}};
  const auto made = perception::marked_pictures(views, masked);
  ASSERT_EQ(made.marks.size(), 2U) << "what shows next to nothing is no mark";
  EXPECT_EQ(made.marks[0].mask, 1U);
  EXPECT_EQ(made.marks[1].mask, 0U);
  EXPECT_EQ(made.pictures[0].width, 2 * view_width);
  EXPECT_NEAR(made.marks[0].x_px, 2 * 90, 2);
  EXPECT_NEAR(made.marks[0].y_px, 2 * 90, 2);
  // The outline and the chip are drawn, the rest is as it was.
  const auto drawn = [&](int x, int y) { return made.pictures[0].at(x, y)[0] != 0; };
  EXPECT_TRUE(drawn(100, 150));
  EXPECT_TRUE(drawn(made.marks[0].x_px - made.marks[0].half_width_px + 2, made.marks[0].y_px));
  EXPECT_FALSE(drawn(120, 120));
  EXPECT_FALSE(drawn(600, 600));
  EXPECT_EQ(made.pictures[0].pixels, perception::marked_pictures(views, masked).pictures[0].pixels);
}

TEST(MarkedPictures, ChipsOverlapNowhereAndStayOnThePicture) {
  std::vector<perception::ViewCloud> views{grey_view()};
  std::vector<perception::MaskedView> masked{{0, {}}};
  for (int i = 0; i < 60; ++i)
    masked[0].masks.push_back(block(i % 10 * 8, i / 10 * 6, 12));  // in a corner, one on another
  const auto made = perception::marked_pictures(views, masked);
  ASSERT_EQ(made.marks.size(), perception::max_marks);
  for (std::size_t i = 0; i < made.marks.size(); ++i) {
    const perception::Mark& mark = made.marks[i];
    EXPECT_GE(mark.x_px, mark.half_width_px);
    EXPECT_GE(mark.y_px, mark.half_height_px);
    for (std::size_t k = 0; k < i; ++k)
      EXPECT_FALSE(chips_overlap(mark, made.marks[k])) << i << " " << k;
  }
}

TEST(MarkedPictures, TakeAHundredThousandMasksAndPixelsThatAreNone) {
  std::vector<perception::ViewCloud> views{grey_view()};
  std::vector<perception::MaskedView> masked{{0, {}}};
  masked[0].masks.assign(100'000, block(100, 100, 5));
  masked[0].masks[7] = block(300, 200, 30);
  masked[0].masks[8].pixels.back() = 4'000'000;
  const auto made = perception::marked_pictures(views, masked);
  EXPECT_EQ(made.marks.size(), perception::max_marks);
  EXPECT_EQ(made.marks[0].mask, 7U);
  EXPECT_TRUE(perception::marked_pictures(views, {}).marks.empty());
}

// Says one thing after the other, the last again and again; an Error is one.
struct Scripted {
  std::vector<Result<llm::ChatAnswer>> says;
  std::vector<llm::ChatRequest> asked = {};
  std::shared_ptr<perception::MarkQuestioner> questioner() {
    return std::make_shared<perception::MarkQuestioner>(llm::LanguageModel{
        "test:scripted", [this](const llm::ChatRequest& request) -> Result<llm::ChatAnswer> {
          asked.push_back(request);
          return says[std::min(asked.size(), says.size()) - 1];
        }});
  }
};

llm::ChatAnswer text(std::string what) {
  return {std::move(what), "scripted-1", 100, 7, false};
}
llm::ChatAnswer mark(int number) {
  return text(nlohmann::json{{"seen", "a pack"}, {"mark", number}}.dump());
}

// A red carton and a green box on a table, seen from two sides.
class ModelChoosesTarget : public ::testing::Test {
 protected:
  ModelChoosesTarget() {
    const std::vector<DrawnBox> goods{
        {{{0.5, 0, -0.02}, {}}, {1.0, 1.0, 0.02}, plain(table_grey)},
        {{{0.45, 0.05, 0}, rotation_about({0, 0, 1}, 0.4)}, {0.06, 0.09, 0.12}, plain(juice_red)},
        {{{0.60, -0.06, 0}, rotation_about({0, 0, 1}, -0.7)},
         {0.05, 0.16, 0.04},
         plain(box_green)}};
    for (const Vec3 eye : {Vec3{0.5, 0.1, 0.6}, Vec3{0.35, -0.1, 0.7}}) {
      views_.emplace_back(drawn_view(goods, camera_over(eye), view_width, view_height, 530));
      masked_.push_back(
          {masked_.size(),
           perception::GeometricMasks().masks(
               views_.back(), perception::goods_over(views_.back(), {{0, -0.5}, {1, 0.5}}))});
    }
    auto made = perception::ProductLook::make("carton-sku",
                                              drawn_pictures({0.06, 0.09, 0.12}, plain(juice_red)));
    carton_ = std::make_unique<perception::ProductLook>(std::move(made).value());
    wanted_ = {{carton_.get(), {}, 1, "a red carton of juice"}};
  }

  std::vector<perception::FoundProduct> find(
      const std::shared_ptr<perception::MarkQuestioner>& questioner) const {
    return perception::ModelTargets(questioner,
                                    poses_,
                                    std::make_unique<perception::CatalogueMatching>(poses_),
                                    [](const std::string&) { return "Red carton, 1 l"; })
        .find(wanted_, views_, masked_);
  }
  // Number of the mark that shows the carton: it lies nearer to the left of the table.
  int carton_mark() const {
    const auto marked = perception::marked_pictures(views_, masked_);
    for (std::size_t i = 0; i < marked.marks.size(); ++i) {
      const perception::Mark& each = marked.marks[i];
      const perception::ViewCloud& view = views_[each.view];
      const perception::Mask& mask = masked_[each.view].masks[each.mask];
      const Vec3f color = view.color(mask.pixels[mask.pixels.size() / 2]);
      if (color.x > 2 * color.y) return static_cast<int>(i) + 1;
    }
    return -1;
  }

  perception::SweptPoses poses_;
  std::vector<perception::ViewCloud> views_;
  std::vector<perception::MaskedView> masked_;
  std::unique_ptr<perception::ProductLook> carton_;
  std::vector<perception::WantedProduct> wanted_;
};

TEST_F(ModelChoosesTarget, TheMarkIsTheProductAndTheWordsAreTheTasks) {
  Scripted model{{mark(carton_mark())}};
  const auto questioner = model.questioner();
  const auto found = find(questioner);
  ASSERT_EQ(found.size(), 1U);
  // Turned, it is alike.
  const Vec3 middle = to_double((carton_->low() + carton_->high()) * 0.5F);
  EXPECT_LT(length(found[0].pose.base_from_product * middle - Vec3{0.45, 0.05, 0.06}), 0.005);
  ASSERT_EQ(model.asked.size(), 2U);
  EXPECT_EQ(model.asked[0].turns[0].pictures.size(), 2U);
  EXPECT_EQ(model.asked[1].turns[0].pictures.size(), 3U);
  for (const llm::ChatRequest& request : model.asked) {
    EXPECT_NE(request.turns[0].text.find("a red carton of juice"), std::string::npos);
    EXPECT_EQ(request.turns[0].text.find("carton-sku"), std::string::npos);
  }
  EXPECT_EQ(find(questioner).size(), 1U);
  EXPECT_EQ(model.asked.size(), 2U) << "the same pictures are not sent again";
  EXPECT_EQ(questioner->use().chosen, 1);
  EXPECT_EQ(questioner->use().requests, 2);
  EXPECT_EQ(questioner->use().tokens_in, 200);
  EXPECT_EQ(questioner->use().offline, 0);
}

TEST_F(ModelChoosesTarget, ASkuIsToldAsTheCatalogueCallsIt) {
  wanted_[0].words.clear();
  Scripted model{{mark(carton_mark())}};
  EXPECT_EQ(find(model.questioner()).size(), 1U);
  EXPECT_NE(model.asked[0].turns[0].text.find("Red carton, 1 l"), std::string::npos);
}

TEST_F(ModelChoosesTarget, NotThereIsBelieved) {
  Scripted first{{mark(-1)}};
  EXPECT_TRUE(find(first.questioner()).empty());
  EXPECT_EQ(first.asked.size(), 1U);
  Scripted second{{mark(carton_mark()), mark(-1)}};
  EXPECT_TRUE(find(second.questioner()).empty());
}

TEST_F(ModelChoosesTarget, ASecondLookMayMendTheFirst) {
  const int right = carton_mark(), wrong = right == 1 ? 2 : 1;
  Scripted model{{mark(wrong), mark(right)}};
  ASSERT_EQ(find(model.questioner()).size(), 1U);
}

TEST_F(ModelChoosesTarget, WhateverFailsIsCountedAndTheOfflineChoiceStandsIn) {
  struct Case {
    Result<llm::ChatAnswer> says;
    int agent::ModelUse::*counted;
  };
  const auto failing = [](const char* code) {
    return Result<llm::ChatAnswer>(Error{code, "test:scripted", "no"});
  };
  const std::vector<Case> cases{
      {failing("llm.refused"), &agent::ModelUse::refused},
      {failing("net.timeout"), &agent::ModelUse::timed_out},
      {failing("net.unreachable"), &agent::ModelUse::unreachable},
      {text("{\"mark\": NaN}"), &agent::ModelUse::bad_answer},
      {text("I see a pack"), &agent::ModelUse::bad_answer},
      {text("{\"seen\": \"a pack\", \"mark\": \"1\"}"), &agent::ModelUse::bad_answer},
      {text("{\"seen\": \"a pack\", \"mark\": 1e99}"), &agent::ModelUse::bad_answer},
      {mark(0), &agent::ModelUse::off_picture},
      {mark(99), &agent::ModelUse::off_picture},
      {mark(-7), &agent::ModelUse::off_picture},
  };
  const auto offline = perception::CatalogueMatching(poses_).find(wanted_, views_, masked_);
  ASSERT_EQ(offline.size(), 1U);
  for (const Case& each : cases) {
    Scripted model{{each.says}};
    const auto questioner = model.questioner();
    const auto found = find(questioner);
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].pose.base_from_product.position.x,
              offline[0].pose.base_from_product.position.x);
    EXPECT_EQ(questioner->use().*each.counted, 1);
    EXPECT_EQ(questioner->use().questions, 1);
    EXPECT_EQ(questioner->use().offline, 1);
  }
}

TEST_F(ModelChoosesTarget, AMarkWhereItDoesNotFitIsCounted) {
  const int wrong = carton_mark() == 1 ? 2 : 1;
  wanted_[0].words = "something";
  Scripted model{{mark(wrong)}};
  const auto questioner = model.questioner();
  const auto found = find(questioner);
  const agent::ModelUse& use = questioner->use();
  EXPECT_EQ(use.chosen + use.no_pose, 1);
  EXPECT_EQ(use.no_pose, use.offline);
  EXPECT_LE(found.size(), 1U);
}

TEST_F(ModelChoosesTarget, FailuresInARowEndTheQuestions) {
  Scripted model{{Result<llm::ChatAnswer>(Error{"net.timeout", "test:scripted", "no"})}};
  const auto questioner = model.questioner();
  for (int i = 0; i < 6; ++i) {
    wanted_[0].words = "carton " + std::to_string(i);
    EXPECT_EQ(find(questioner).size(), 1U);
  }
  EXPECT_EQ(model.asked.size(), static_cast<std::size_t>(perception::max_failed));
  EXPECT_EQ(questioner->use().timed_out, perception::max_failed);
  EXPECT_EQ(questioner->use().skipped, 3);
}

// ---- On a shelf ----

constexpr Vec3 tea_size{0.06, 0.05, 0.12};

Pose shelf_pose() {
  return {{1.0, 0, 1.0}, rotation_about({0, 0, 1}, -std::numbers::pi / 2)};
}

class ModelChoosesSpot : public ::testing::Test {
 protected:
  ModelChoosesSpot() {
    std::vector<DrawnBox> boxes{
        {shelf_pose() * Pose{{0, 0.2, -0.025}, {}}, {1.0, 0.4, 0.025}, plain(table_grey)},
        {shelf_pose() * Pose{{0, 0.41, -1}, {}}, {1.2, 0.02, 2.5}, plain(table_grey)}};
    for (const auto& [x, color] :
         {std::pair{-0.2, juice_red}, std::pair{0.1, juice_red}, std::pair{0.3, box_green}})
      boxes.push_back({shelf_pose() * Pose{{x, 0.04, 0}, {}}, tea_size, plain(color)});
    const Vec3 ahead = normalized(Vec3{0.9, 0, -0.4});
    const Pose eye{{0.1, 0, 1.5}, rotation_with_axes(cross(ahead, {0, -1, 0}), ahead)};
    views_.emplace_back(drawn_view(boxes, eye, view_width, view_height, 460));
    boards_ = {{shelf_pose(), 1.0, 0.4, 0.4}};
    auto made = perception::ProductLook::make("tea", drawn_pictures(tea_size, plain(juice_red)));
    look_ = std::make_unique<perception::ProductLook>(std::move(made).value());
    wanted_ = {look_.get(), {}, 1, "red tea"};
    spots_ = perception::SweptSpots().spots(views_, boards_, look_->high() - look_->low());
  }
  std::vector<perception::FoundOnShelf> find(
      const std::shared_ptr<perception::MarkQuestioner>& questioner) const {
    return perception::ModelShelfChoice(questioner,
                                        std::make_unique<perception::UprightMatching>(),
                                        [](const std::string& sku) { return sku; })
        .find(wanted_, views_, boards_, spots_);
  }
  // The mark whose spot is nearest to a place on the board.
  int mark_at(double x_m) const {
    const auto likely = perception::likely_spots(*look_, views_, boards_, spots_, 24);
    const auto marked = perception::marked_pictures(
        views_, perception::masks_of_spots(views_, boards_, likely, look_->high() - look_->low()));
    for (std::size_t i = 0; i < marked.marks.size(); ++i)
      if (std::abs(likely[marked.marks[i].mask].x_m - x_m) < 0.03) return static_cast<int>(i) + 1;
    return -1;
  }

  std::vector<perception::ViewCloud> views_;
  std::vector<perception::BoardAhead> boards_;
  std::unique_ptr<perception::ProductLook> look_;
  perception::WantedProduct wanted_;
  std::vector<perception::ShelfSpot> spots_;
};

TEST_F(ModelChoosesSpot, TheOneThatTheModelSays) {
  for (const double x : {-0.2, 0.1}) {
    Scripted model{{mark(mark_at(x))}};
    const auto found = find(model.questioner());
    ASSERT_EQ(found.size(), 1U) << x;
    EXPECT_NEAR(found[0].spot.x_m, x, 0.01);
  }
}

TEST_F(ModelChoosesSpot, AsManyAsAreWanted) {
  wanted_.count = 2;
  Scripted model{{mark(mark_at(-0.2)), mark(mark_at(-0.2)), mark(1), mark(1)}};
  const auto found = find(model.questioner());
  EXPECT_EQ(model.asked.size(), 4U);
  ASSERT_GE(found.size(), 1U);
  EXPECT_NEAR(found[0].spot.x_m, -0.2, 0.01);
}

TEST_F(ModelChoosesSpot, NotThereAndFailures) {
  Scripted absent{{mark(-1)}};
  EXPECT_TRUE(find(absent.questioner()).empty());
  Scripted broken{{text("no idea")}};
  const auto questioner = broken.questioner();
  EXPECT_EQ(find(questioner).size(),
            perception::UprightMatching().find(wanted_, views_, boards_, spots_).size());
  EXPECT_EQ(questioner->use().bad_answer, 1);
  EXPECT_EQ(questioner->use().offline, 1);
}

}  // namespace
}  // namespace marketgen
