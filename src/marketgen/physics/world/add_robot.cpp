// The body that a robot has in a World, and its drives.
#include "physics/world/robot_actor.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <mujoco/mujoco.h>

#include "physics/goods/spec_geoms.h"
#include "physics/world/fixture_bodies.h"
#include "physics/world/pad_balls.h"
#include "physics/world/suction_actor.h"
#include "robots/self_collision.h"

namespace marketgen::physics {
namespace {

// Full effort at this error: about the gains of MuJoCo Menagerie's Panda (4500 N m/rad at 87 N m).
constexpr double full_effort_rad = 0.02, full_effort_m = 0.002;
constexpr double damping_time_s = 0.1;  // damping of a servo over its stiffness; as there
// Of joints without a published effort: stiffness that moves the robot's mass as quickly as this,
// rad/s.
constexpr double bare_quickness = 40;
constexpr double bare_gyration_m2 = 0.1;  // inertia over mass, of one that turns
// Servo of a gripper's fingers, N/m. Measured to hold cans, boxes and bottles within 0.1 mm while
// they are shaken.
constexpr double finger_stiffness = 4000;
// Spindles and worm gears of grippers do not turn back: what tries to move the fingers at their top
// speed needs this many times the tool's force.
constexpr double finger_locking = 2;
constexpr double plain_finger_m_s = 0.2;  // of fingers without a published speed
// Of a pad's rubber on most packs; where the World knows the pack's material, it has the two's own.
constexpr double pad_friction = 0.5;
// MuJoCo takes no moving body without mass; frames between joints get this much, kg and kg m^2.
constexpr double frame_mass = 1e-6, frame_inertia = 1e-9;

struct Servo {
  double stiffness = 0, damping = 0, max_effort = 0;  // 0 for no limit
};

Servo servo_of(const robots::Robot& robot, const robots::Joint& joint) {
  if (robots::is_on_wheels(robot, joint.dof)) return {};
  if (const robots::Tool* tool = robots::gripper_of(robot, joint.dof)) {
    return {finger_stiffness, 0, 2 * tool->force};  // one drive moves both fingers
  }
  const bool slides = joint.kind == robots::JointType::prismatic;
  if (std::isfinite(joint.effort)) {
    const double stiffness = joint.effort / (slides ? full_effort_m : full_effort_rad);
    return {stiffness, stiffness * damping_time_s, joint.effort};
  }
  const double inertia = robots::total_mass(robot) * (slides ? 1 : bare_gyration_m2);
  const double stiffness = inertia * bare_quickness * bare_quickness;
  return {stiffness, stiffness * damping_time_s, 0};
}

// Of each finger. The drive makes up for it as far as they are to move.
double finger_damping(const robots::Tool& tool, const robots::Joint& joint) {
  return finger_locking * tool.force / finger_speed(joint);
}

std::vector<const robots::BodyShape*> boxes_of(const robots::Link& link) {
  std::vector<const robots::BodyShape*> boxes;
  for (const robots::BodyShape& shape : link.look)
    if (shape.kind == robots::ShapeKind::box) boxes.push_back(&shape);
  return boxes;
}

// The joint on which a link is a gripper's finger; null for other links.
const robots::Joint* finger_joint(const robots::Robot& robot, std::size_t link) {
  if (link == 0) return nullptr;
  const robots::Joint& joint = robot.joints[link - 1];
  return joint.dof >= 0 && robots::gripper_of(robot, joint.dof) != nullptr ? &joint : nullptr;
}

// The box of a finger that is furthest in, when balls meet goods in its place; else null, as for a
// finger that does not slide along Y.
const robots::BodyShape* balled_pad(const RobotActorOptions& options,
                                    const robots::Link& link,
                                    const robots::Joint& joint) {
  const std::vector<const robots::BodyShape*> boxes = boxes_of(link);
  const bool along_y = std::abs(joint.axis.y) > 0.5;
  if (options.touch == GripperTouch::plain || boxes.empty() || !along_y) return nullptr;
  const auto inner = [&](const robots::BodyShape* box) {
    return joint.axis.y * box->link_from_shape.position.y - box->size.y / 2;
  };
  return *std::ranges::min_element(boxes, {}, inner);
}

bool carries_fingers(const robots::Robot& robot, std::size_t link) {
  return std::ranges::any_of(robot.joints, [&](const robots::Joint& joint) {
    return static_cast<std::size_t>(joint.parent) == link &&
           finger_joint(robot, static_cast<std::size_t>(joint.link)) != nullptr;
  });
}

class RobotBuilder {
 public:
  RobotBuilder(mjSpec& spec, const robots::Robot& robot, const RobotActorOptions& options)
      : spec_(spec),
        robot_(robot),
        options_(options),
        state_(robots::with_followers(
            robot, options.state.empty() ? robots::neutral_state(robot) : options.state)) {}

  void add() {
    bodies_.resize(robot_.links.size());
    bodies_[0] = add_body(mjs_findBody(&spec_, "world"), 0, options_.world_from_base);
    for (const robots::Joint& joint : robot_.joints)
      add_joint(joint);
    for (const robots::Joint& joint : robot_.joints) {
      if (joint.follows >= 0) add_follower(joint);
      if (joint.dof >= 0 && joint.follows < 0) add_drive(joint);
    }
    add_excludes();
  }

 private:
  std::string name(const std::string& part) const { return options_.prefix + part; }

  mjsBody* add_body(mjsBody* parent, std::size_t index, const Pose& parent_from_link) {
    const robots::Link& link = robot_.links[index];
    mjsBody* body = mjs_addBody(parent, nullptr);
    mjs_setName(body->element, name(link.name).c_str());
    set_pose(body->pos, body->quat, parent_from_link);
    body->gravcomp = 1;
    body->explicitinertial = true;
    const robots::Inertia& i = link.inertia;
    const bool empty = !(link.mass > 0);
    const double entries[6] = {i.xx, i.yy, i.zz, i.xy, i.xz, i.yz};
    const double small[6] = {frame_inertia, frame_inertia, frame_inertia, 0, 0, 0};
    std::copy_n(empty ? small : entries, 6, body->fullinertia);
    body->mass = empty ? frame_mass : link.mass;
    const Vec3 c = empty ? Vec3{} : link.center_of_mass;
    body->ipos[0] = c.x, body->ipos[1] = c.y, body->ipos[2] = c.z;
    add_geoms(body, index);
    return body;
  }

  // The balls of its pad meet goods in place of the pad's box.
  void add_finger(mjsBody* body, const robots::Link& link, const robots::Joint& joint) const {
    const robots::BodyShape* pad = balled_pad(options_, link, joint);
    int count = 0;
    for (const robots::BodyShape* box : boxes_of(link)) {
      mjsGeom* geom =
          add_shape(body, {assets::CollisionShape::box, box->link_from_shape, box->size * 0.5});
      finish_geom(geom, link, count++);
      set_goods_contact(geom, {4, 1, torsional_friction_m, plain_rolling_friction_m});
      if (box != pad) continue;
      geom->contype = pad_box_contact_type;
      geom->conaffinity = pad_box_affinity;
    }
    if (pad == nullptr) return;
    for (mjsGeom* ball :
         add_pad_balls(body, pad->link_from_shape.position, pad->size * 0.5, joint.axis.y)) {
      finish_geom(ball, link, count++);
      ball->contype = pad_ball_contact_type;
      ball->conaffinity = pad_ball_affinity;
      ball->friction[0] = pad_friction;
      ball->priority = 1;  // goods do not roll in it
    }
  }

  void add_geoms(mjsBody* body, std::size_t index) {
    const robots::Link& link = robot_.links[index];
    const bool boxed = !boxes_of(link).empty();
    if (const robots::Joint* joint = finger_joint(robot_, index); joint != nullptr && boxed)
      return add_finger(body, link, *joint);
    int count = 0;
    if (boxed && options_.touch == GripperTouch::fine && carries_fingers(robot_, index)) {
      for (const robots::BodyShape* box : boxes_of(link))
        finish_geom(
            add_shape(body, {assets::CollisionShape::box, box->link_from_shape, box->size * 0.5}),
            link,
            count++);
      return;
    }
    for (const assets::ContactShape& solid : cup_solids(robot_, index))
      finish_geom(add_shape(body, solid), link, count++);
    if (count > 0) return;
    for (const robots::Capsule& c : link.capsules) {
      mjsGeom* geom = mjs_addGeom(body, nullptr);
      const bool ball = length(c.b - c.a) < 1e-9;
      geom->type = ball ? mjGEOM_SPHERE : mjGEOM_CAPSULE;
      geom->size[0] = c.radius;
      const double ends[6] = {c.a.x, c.a.y, c.a.z, c.b.x, c.b.y, c.b.z};
      if (ball)
        std::copy_n(ends, 3, geom->pos);
      else
        std::copy_n(ends, 6, geom->fromto);
      geom->solref[0] = contact_time_s;
      finish_geom(geom, link, count++);
    }
  }

  void finish_geom(mjsGeom* geom, const robots::Link& link, int number) const {
    geom->mass = 0;
    mjs_setName(geom->element, name(fmt::format("{}/{}", link.name, number)).c_str());
  }

  // The model's state at the start is `state_`: bodies stand as they do there.
  void add_joint(const robots::Joint& joint) {
    const double start = joint.dof >= 0 ? state_[static_cast<std::size_t>(joint.dof)] : 0;
    mjsBody* body = add_body(bodies_[static_cast<std::size_t>(joint.parent)],
                             static_cast<std::size_t>(joint.link),
                             robots::joint_motion(joint, start));
    bodies_[static_cast<std::size_t>(joint.link)] = body;
    if (joint.dof < 0) return;
    mjsJoint* made = mjs_addJoint(body, nullptr);
    mjs_setName(made->element, name(joint.name).c_str());
    made->type = joint.kind == robots::JointType::prismatic ? mjJNT_SLIDE : mjJNT_HINGE;
    made->axis[0] = joint.axis.x, made->axis[1] = joint.axis.y, made->axis[2] = joint.axis.z;
    made->ref = start;
    made->armature = joint.armature;
    made->damping[0] = joint.damping;
    if (const robots::Tool* tool = robots::gripper_of(robot_, joint.dof))
      made->damping[0] += finger_damping(*tool, joint);
    if (std::isfinite(joint.lower) && std::isfinite(joint.upper)) {
      made->limited = mjLIMITED_TRUE;
      made->range[0] = joint.lower, made->range[1] = joint.upper;
    }
    if (const Servo servo = servo_of(robot_, joint);
        servo.max_effort > 0 && joint.follows < 0 &&
        robots::gripper_of(robot_, joint.dof) == nullptr) {
      made->actgravcomp = true;  // gravity is carried by the drive and counts against its effort
      made->actfrclimited = mjLIMITED_TRUE;
      made->actfrcrange[0] = -servo.max_effort, made->actfrcrange[1] = servo.max_effort;
    }
  }

  void add_follower(const robots::Joint& joint) {
    mjsEquality* tie = mjs_addEquality(&spec_, nullptr);
    tie->type = mjEQ_JOINT;
    tie->objtype = mjOBJ_JOINT;
    mjs_setString(tie->name1, name(joint.name).c_str());
    mjs_setString(tie->name2,
                  name(robot_.joint_of_dof(static_cast<std::size_t>(joint.follows)).name).c_str());
    std::fill_n(tie->data, mjNEQDATA, 0.0);
    tie->data[0] = joint.follow_offset, tie->data[1] = joint.follow_ratio;
    tie->solref[0] = contact_time_s;
  }

  void add_drive(const robots::Joint& joint) {
    mjsActuator* drive = mjs_addActuator(&spec_, nullptr);
    mjs_setName(drive->element, name(joint.name).c_str());
    mjs_setString(drive->target, name(joint.name).c_str());
    drive->trntype = mjTRN_JOINT;
    if (robots::gripper_of(robot_, joint.dof) != nullptr) pull_evenly(*drive, joint);
    const Servo servo = servo_of(robot_, joint);
    if (servo.max_effort > 0 && robots::gripper_of(robot_, joint.dof) == nullptr) {
      drive->forcelimited = mjLIMITED_TRUE;
      drive->forcerange[0] = -servo.max_effort, drive->forcerange[1] = servo.max_effort;
    }
    drive->gaintype = mjGAIN_FIXED;
    const bool bare =
        options_.drive == RobotDrive::torque && robots::gripper_of(robot_, joint.dof) == nullptr;
    if (bare || robots::is_on_wheels(robot_, joint.dof)) {
      drive->gainprm[0] = 1;
      return;
    }
    drive->gainprm[0] = servo.stiffness;
    drive->biastype = mjBIAS_AFFINE;
    drive->biasprm[1] = -servo.stiffness, drive->biasprm[2] = -servo.damping;
  }

  // One drive moves a finger and those that follow it, each with its share of the force: its place
  // is the mean of theirs.
  void pull_evenly(mjsActuator& drive, const robots::Joint& finger) {
    std::vector<const robots::Joint*> moved{&finger};
    for (const robots::Joint& joint : robot_.joints)
      if (joint.dof >= 0 && joint.follows == finger.dof) moved.push_back(&joint);
    mjsTendon* tendon = mjs_addTendon(&spec_, nullptr);
    mjs_setName(tendon->element, name(finger.name).c_str());
    for (const robots::Joint* joint : moved)
      mjs_wrapJoint(tendon, name(joint->name).c_str(), 1.0 / static_cast<double>(moved.size()));
    drive.trntype = mjTRN_TENDON;
  }

  // Every pair of links but those that may touch.
  void add_excludes() {
    const std::vector<robots::LinkPair> pairs = robots::pairs_that_may_touch(robot_);
    for (int a = 0; a < static_cast<int>(robot_.links.size()); ++a) {
      for (int b = a + 1; b < static_cast<int>(robot_.links.size()); ++b) {
        if (std::find(pairs.begin(), pairs.end(), robots::LinkPair{a, b}) != pairs.end()) continue;
        mjsExclude* exclude = mjs_addExclude(&spec_);
        mjs_setString(exclude->bodyname1,
                      name(robot_.links[static_cast<std::size_t>(a)].name).c_str());
        mjs_setString(exclude->bodyname2,
                      name(robot_.links[static_cast<std::size_t>(b)].name).c_str());
      }
    }
  }

  mjSpec& spec_;
  const robots::Robot& robot_;
  const RobotActorOptions& options_;
  std::vector<double> state_;
  std::vector<mjsBody*> bodies_;
};

}  // namespace

double finger_speed(const robots::Joint& joint) {
  return std::isfinite(joint.velocity) ? joint.velocity : plain_finger_m_s;
}

Result<void> add_robot(mjSpec_& spec,
                       const robots::Robot& robot,
                       const RobotActorOptions& options) {
  if (robot.dof_count() == 0)
    return Error{
        "physics.bad_command", robot.name, "the robot has no moving joint: nothing to drive"};
  if (!options.state.empty()) MARKETGEN_CHECK(robots::check_state(robot, options.state));
  RobotBuilder(spec, robot, options).add();
  return {};
}

std::map<std::string, std::string> robot_materials(const robots::Robot& robot,
                                                   const RobotActorOptions& options) {
  std::map<std::string, std::string> materials;
  for (const robots::Joint& joint : robot.joints) {
    if (joint.dof < 0 || robots::gripper_of(robot, joint.dof) == nullptr) continue;
    const robots::Link& link = robot.links[static_cast<std::size_t>(joint.link)];
    const std::size_t boxes = boxes_of(link).size();
    std::size_t geoms = boxes > 0 ? boxes : link.capsules.size();
    if (const robots::BodyShape* pad = balled_pad(options, link, joint))
      geoms += pad_ball_places(pad->link_from_shape.position, pad->size * 0.5, joint.axis.y).size();
    for (std::size_t i = 0; i < geoms; ++i)
      materials.emplace(fmt::format("{}{}/{}", options.prefix, link.name, i),
                        options.finger_material);
  }
  return materials;
}

}  // namespace marketgen::physics
