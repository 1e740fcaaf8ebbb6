// Checkout Unloading for marketgen/environments.py: one world and its pictures.
#include <nanobind/ndarray.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include "base/seed.h"
#include "binding.h"
#include "episodes/checkout_view.h"
#include "episodes/sample_checkout.h"
#include "frame_handle.h"
#include "io/file.h"
#include "io/json.h"
#include "robots/numeric_ik.h"
#include "store_handle.h"

namespace marketgen::python {
namespace {

using Joints = nb::ndarray<const double, nb::ndim<1>, nb::c_contig, nb::device::cpu>;

class CheckoutHandle {
 public:
  explicit CheckoutHandle(const StoreHandle& store)
      : store_(store.store),
        data_(value_or_raise(data_folder())),
        frictions_(store.frictions),
        stock_(checkout_stock(store_->scene)),
        world_(value_or_raise(CheckoutWorld::create(data_, frictions_))) {}

  // Episode `index` of a seed, as market-episode/1.
  std::string sample(std::uint64_t seed, int index) const {
    const EpisodeOrigin origin{
        store_->manifest.name, store_->manifest.scene_hash, plan_hash(store_->plan)};
    return write_json(value_or_raise(without_interpreter(
        [&] { return sample_checkout(data_, stock_, frictions_, origin, Seed(seed), index); })));
  }

  void reset(const std::string& episode) {
    const EpisodeSpec spec = value_or_raise(read_json<EpisodeSpec>(episode, "episode"));
    check_or_raise(check_store(spec, store_->manifest.scene_hash, plan_hash(store_->plan)));
    view_.reset();
    check_or_raise(world_.reset(spec, stock_));
  }

  nb::tuple observe() const { return told(world_.observe()); }

  nb::tuple step(const Joints& position, double opening_m, double force_n, bool stop) {
    Action action;
    action.position.assign(position.data(), position.data() + position.size());
    action.tools = {{opening_m, force_n}};
    action.stop = stop;
    return told(value_or_raise(without_interpreter([&] { return world_.step(action); })));
  }

  // Joint values that bring the tool to a pose near where it is, by damped least squares; those of
  // now when it is out of reach. Robot frame: x, y, z, qw, qx, qy, qz.
  std::vector<double> joints_for(const Joints& pose) const {
    if (pose.size() != 7) raise({"episode.bad_action", "pose", "expected x, y, z, qw, qx, qy, qz"});
    const double* p = pose.data();
    NumericIkOptions near;
    near.restarts = 0;
    near.tolerance = 1e-5;
    const Robot& robot = world_.robot();
    const std::vector<double> now = world_.robot_state();
    const std::vector<int>& arm = robot.find_group("arm")->dofs;
    const auto found = solve_numeric(robot,
                                     robot.tools.front().frame,
                                     arm,
                                     {{p[0], p[1], p[2]}, {p[3], p[4], p[5], p[6]}},
                                     now,
                                     Seed(0),
                                     near);
    std::vector<double> joints;
    for (const int dof : arm)
      joints.push_back((found.ok() ? *found : now)[static_cast<std::size_t>(dof)]);
    return joints;
  }

  std::vector<double> tool_pose() const {
    const Robot& robot = world_.robot();
    return seven(frame_pose(robot, world_.robot_state(), robot.tools.front().frame));
  }

  std::string finish() {
    return write_json(value_or_raise(without_interpreter([&] { return world_.finish(); })));
  }

  FrameHandle render(const std::string& camera, int width, int height, const std::string& quality) {
    const auto which = named<StationCamera>(camera, "camera");
    RenderOptions options;
    options.quality = named<Quality>(quality, "quality");
    return {value_or_raise(without_interpreter([&]() -> Result<Frame> {
      MARKETGEN_CHECK(show());
      return view_->renderer().render(view_->camera(which, width, height), options);
    }))};
  }
  Camera camera(const std::string& camera, int width, int height) {
    const auto which = named<StationCamera>(camera, "camera");
    check_or_raise(without_interpreter([&] { return show(); }));
    return view_->camera(which, width, height);
  }

  std::vector<std::vector<double>> item_poses() const {
    std::vector<std::vector<double>> poses;
    for (std::size_t i = 0; i < world_.item_count(); ++i)
      poses.push_back(seven(world_.item_pose(i)));
    return poses;
  }
  std::vector<double> unloading_center() const {
    const auto& center = world_.station().unloading.center_m;
    return {center[0], center[1]};
  }
  std::string state_hash() const { return world_.state_hash(); }
  bool done() const { return world_.done(); }
  nb::tuple joint_limits() const {
    std::vector<double> lower, upper;
    const Robot& robot = world_.robot();
    for (const int dof : robot.find_group("arm")->dofs) {
      lower.push_back(robot.joint_of_dof(static_cast<std::size_t>(dof)).lower);
      upper.push_back(robot.joint_of_dof(static_cast<std::size_t>(dof)).upper);
    }
    return nb::make_tuple(lower, upper, robot.tools.front().opening);
  }

 private:
  static nb::tuple told(const Observation& seen) {
    return nb::make_tuple(seen.time_s, seen.position, seen.velocity, seen.openings_m.front());
  }
  static std::vector<double> seven(const Pose& p) {
    return {p.position.x,
            p.position.y,
            p.position.z,
            p.rotation.w,
            p.rotation.x,
            p.rotation.y,
            p.rotation.z};
  }
  Result<void> show() {
    if (view_) return view_->follow(world_);
    MARKETGEN_TRY(view_, CheckoutView::create(world_));
    return {};
  }

  std::shared_ptr<const Store> store_;
  std::filesystem::path data_;
  std::vector<FrictionRow> frictions_;
  std::vector<Product> stock_;
  CheckoutWorld world_;
  std::unique_ptr<CheckoutView> view_;  // of this episode, once a picture was asked for
};

}  // namespace

void add_checkout(nb::module_& module) {
  nb::class_<CheckoutHandle>(module, "Checkout")
      .def(nb::init<const StoreHandle&>())
      .def("sample", &CheckoutHandle::sample)
      .def("reset", &CheckoutHandle::reset)
      .def("observe", &CheckoutHandle::observe)
      .def("step", &CheckoutHandle::step)
      .def("joints_for", &CheckoutHandle::joints_for)
      .def("tool_pose", &CheckoutHandle::tool_pose)
      .def("finish", &CheckoutHandle::finish)
      .def("render", &CheckoutHandle::render)
      .def("camera", &CheckoutHandle::camera)
      .def("item_poses", &CheckoutHandle::item_poses)
      .def("unloading_center", &CheckoutHandle::unloading_center)
      .def("state_hash", &CheckoutHandle::state_hash)
      .def("done", &CheckoutHandle::done)
      .def("joint_limits", &CheckoutHandle::joint_limits);
}

}  // namespace marketgen::python
