#include "assets/people/gait.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "assets/people/person_frame.h"

namespace marketgen::assets {
namespace {

constexpr double half_stance =
    0.62;  // steps: 62 % of two steps, half before the body and half after
constexpr double flat_from = -0.40, heel_off = 0.10;  // steps from the footprint
constexpr double strike_rad = 0.30, toe_off_rad = 0.75;
constexpr double usual_step_m = 0.65;  // at which angles are these
constexpr double lift_m = 0.035;
constexpr double walking_width = 0.040, walking_yaw = 0.07;  // as standing_width, standing_yaw
constexpr double swing_rad = 0.36;                           // of the arms
constexpr double arm_lead = 0.69;  // of two steps: the left foot is farthest ahead
constexpr double lean_rad = 0.035;

double smooth(double x) {
  const double t = std::clamp(x, 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

// One side's foot along the way; everything in steps.
struct Stride {
  int print = 0;     // the footprint on which it stands or which it leaves
  double after = 0;  // the body's way past that footprint
  bool swings = false;
  double swung = 0;                         // 0 to 1
  bool from_rest = false, to_rest = false;  // the swing begins, ends beside the other foot
};

Stride stride_of(int side, int steps, double walked) {
  Stride s;
  s.print = side + 2 * static_cast<int>(std::floor((walked - side + half_stance) / 2));
  s.after = walked - s.print;
  s.swings = s.after > half_stance && s.print < steps;
  const double off = s.print + half_stance, on = s.print + 2 - half_stance;
  s.from_rest = s.print < 0;
  s.to_rest = s.print + 2 > steps;
  const double begin = std::max(off, 0.0), end = std::min(on, static_cast<double>(steps));
  s.swung = std::clamp((walked - begin) / std::max(end - begin, 1e-9), 0.0, 1.0);
  return s;
}

struct Print {
  Vec2 ball;  // store frame
  double yaw;
};

Print print_of(
    const PersonLook& look, const Way& way, double length_m, int steps, int print, double side) {
  const bool rests = print <= 0 || print >= steps;
  const WayPlace at = way(length_m * std::clamp(print, 0, steps) / steps);
  const double ahead = foot_measures(look).ankle_behind_ball_m;
  const double aside = side * look.stature_m * (rests ? standing_width : walking_width);
  const double c = std::cos(at.heading_rad), s = std::sin(at.heading_rad);
  return {{at.position.x + c * ahead - s * aside, at.position.y + s * ahead + c * aside},
          at.heading_rad + side * (rests ? standing_yaw : walking_yaw)};
}

// Pitch and height of a foot on its print.
FootPlace standing_foot(
    const Print& print, double after, bool strikes, bool leaves, double vigour, double heel) {
  FootPlace foot;
  foot.ball = {print.ball.x, print.ball.y, 0};
  foot.yaw_rad = print.yaw;
  if (strikes && after < flat_from)
    foot.pitch_rad = -vigour * strike_rad * (after - flat_from) / (-half_stance - flat_from);
  if (leaves && after > heel_off)
    foot.pitch_rad = vigour * toe_off_rad * smooth((after - heel_off) / (half_stance - heel_off));
  if (foot.pitch_rad > 0) {
    foot.toe_rad = foot.pitch_rad;
  } else {  // it stands on its heel, which stays where it is
    const double back = heel * (1 - std::cos(foot.pitch_rad));
    foot.ball = foot.ball - Vec3{back * std::cos(print.yaw),
                                 back * std::sin(print.yaw),
                                 heel * std::sin(foot.pitch_rad)};
  }
  return foot;
}

FootPlace between(const FootPlace& from, const FootPlace& to, double swung, double lift) {
  const double s = smooth(swung), hump = std::sin(std::numbers::pi * swung);
  FootPlace foot;
  foot.ball = from.ball + (to.ball - from.ball) * s;
  foot.ball.z += lift * hump * hump;
  double turn = std::remainder(to.yaw_rad - from.yaw_rad, 2 * std::numbers::pi);
  foot.yaw_rad = from.yaw_rad + turn * s;
  foot.pitch_rad = from.pitch_rad + (to.pitch_rad - from.pitch_rad) * s;
  foot.toe_rad = foot.pitch_rad > 0 ? foot.pitch_rad * (1 - s) : 0;
  return foot;
}

FootPlace in_person_frame(FootPlace foot, const WayPlace& person) {
  const double c = std::cos(person.heading_rad), s = std::sin(person.heading_rad);
  const double x = foot.ball.x - person.position.x, y = foot.ball.y - person.position.y;
  foot.ball = {c * x + s * y, c * y - s * x, foot.ball.z};
  foot.yaw_rad -= person.heading_rad;
  return foot;
}

FootPlace walking_foot(
    const PersonLook& look, const Way& way, double length_m, int steps, double walked, int side) {
  const double left = side == 0 ? 1 : -1;
  const double vigour = std::min(length_m / steps / usual_step_m, 1.15);
  const double heel = foot_measures(look).heel_behind_ball_m;
  const Stride s = stride_of(side, steps, walked);
  const auto foot_on = [&](int print, double after) {
    return standing_foot(print_of(look, way, length_m, steps, print, left),
                         after,
                         print > 0 && print < steps,
                         print >= 0 && print < steps,
                         vigour,
                         heel);
  };
  if (!s.swings) return foot_on(s.print, s.after);
  const FootPlace from = foot_on(s.print, half_stance), to = foot_on(s.print + 2, -half_stance);
  return between(from, to, s.swung, lift_m * vigour);
}

}  // namespace

double step_length_m(double speed_m_s) {
  constexpr double walk_ratio_m_min = 0.0065;
  return std::sqrt(walk_ratio_m_min * 60 * speed_m_s);
}

PersonPose walking_pose(
    const PersonLook& look, const Way& way, double length_m, int steps, double walked_m) {
  const double walked = std::clamp(walked_m / length_m, 0.0, 1.0) * steps;
  const WayPlace person = way(std::clamp(walked_m, 0.0, length_m));
  PersonPose pose = standing_pose(look);
  for (std::size_t i = 0; i < 2; ++i)
    pose.feet[i] = in_person_frame(
        walking_foot(look, way, length_m, steps, walked, static_cast<int>(i)), person);
  const double in_step = smooth(std::min(walked, steps - walked));
  const double vigour = std::min(length_m / steps / usual_step_m, 1.15) * in_step;
  const double swing =
      swing_rad * vigour * std::cos(2 * std::numbers::pi * (walked / 2 - arm_lead));
  pose.arm_forward_rad = {-swing, swing};
  pose.lean_rad = lean_rad * vigour;
  return pose;
}

double turned_rad(double turn_rad, double done) {
  return turn_rad * smooth(done);
}

PersonPose turning_pose(const PersonLook& look, double turn_rad, double done) {
  const PersonPose rest = standing_pose(look);
  PersonPose pose = rest;
  const WayPlace person{{0, 0}, turned_rad(turn_rad, done)};
  for (std::size_t i = 0; i < 2; ++i) {
    FootPlace to = in_person_frame(rest.feet[i], {{0, 0}, -turn_rad});
    // The foot on the inside of the turn goes first.
    const bool first = (turn_rad > 0) == (i == 0);
    const double swung = std::clamp(first ? done * 2 : done * 2 - 1, 0.0, 1.0);
    pose.feet[i] = in_person_frame(between(rest.feet[i], to, swung, lift_m), person);
  }
  return pose;
}

}  // namespace marketgen::assets
