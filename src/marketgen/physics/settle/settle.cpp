#include "physics/settle/settle.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "physics/goods/contact_shape.h"
#include "physics/settle/settle_model.h"

namespace marketgen::physics {
namespace {

constexpr double still_margin_m = 3;     // goods and fixtures this near are in the model
constexpr double stable_drift_m = 0.05;  // STB: an item that moves less stands

using Clock = std::chrono::steady_clock;
double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

// Rows of the region's products, those nearest to its centre first; equally near ones by row.
std::vector<std::uint32_t> products_in(const scene::Scene& scene, const SettleOptions& options) {
  const auto& [x0, y0, x1, y1] = options.region_m;
  std::vector<std::pair<double, std::uint32_t>> found;
  for (std::uint32_t row = 0; row < scene.products.size(); ++row) {
    const Vec3 p = scene::world_from_product(scene.products[row]).position;
    if (p.x < x0 || p.x > x1 || p.y < y0 || p.y > y1) continue;
    const Vec3 offset{p.x - (x0 + x1) / 2, p.y - (y0 + y1) / 2, 0};
    found.emplace_back(dot(offset, offset), row);
  }
  std::ranges::sort(found);
  found.resize(std::min(found.size(), static_cast<std::size_t>(std::max(0, options.max_products))));
  std::vector<std::uint32_t> rows;
  for (const auto& [distance, row] : found)
    rows.push_back(row);
  return rows;
}

// What MuJoCo counts instead of failing; each of them makes the drift meaningless.
Result<void> check_warnings(const mjData& data) {
  for (const int warning : {mjWARN_INERTIA,
                            mjWARN_CONTACTFULL,
                            mjWARN_CNSTRFULL,
                            mjWARN_BADQPOS,
                            mjWARN_BADQVEL,
                            mjWARN_BADQACC}) {
    if (data.warning[warning].number == 0) continue;
    return Error{
        "physics.failed",
        "settle",
        fmt::format("at {:.3f} s: {}",
                    data.time,
                    mju_warningText(warning, static_cast<size_t>(data.warning[warning].lastinfo)))};
  }
  return {};
}

// Largest distance of every free body's centre from its start, over `duration_s`.
Result<std::vector<double>> drifts(const mjModel& model,
                                   mjData& data,
                                   std::size_t bodies,
                                   double duration_s) {
  std::vector<double> worst(bodies, 0);
  const int steps = static_cast<int>(duration_s / time_step_s + 0.5);
  std::vector<mjtNum> start;
  MARKETGEN_CHECK(guarded("settle", [&] {
    mj_kinematics(&model, &data);
    mj_comPos(&model, &data);
  }));
  start.assign(data.xipos, data.xipos + 3 * model.nbody);
  for (int step = 0; step < steps; ++step) {
    MARKETGEN_CHECK(guarded("settle", [&] { mj_step(&model, &data); }));
    MARKETGEN_CHECK(check_warnings(data));
    for (std::size_t i = 0; i < bodies; ++i) {
      const std::size_t at = 3 * (i + 1);  // body 0 is the world
      const Vec3 moved{data.xipos[at] - start[at],
                       data.xipos[at + 1] - start[at + 1],
                       data.xipos[at + 2] - start[at + 2]};
      worst[i] = std::max(worst[i], length(moved));
    }
  }
  return worst;
}

void summarize(const std::vector<double>& drift,
               const scene::Scene& scene,
               const std::vector<std::uint32_t>& rows,
               SettleReport& report) {
  const auto worst = std::ranges::max_element(drift);
  report.worst_drift_m = *worst;
  report.worst_product =
      scene::product_id(scene, rows[static_cast<std::size_t>(worst - drift.begin())]);
  const auto below = std::ranges::count_if(drift, [](double d) { return d < stable_drift_m; });
  report.share_below_5_cm = static_cast<double>(below) / static_cast<double>(drift.size());
  std::vector<double> sorted = drift;
  std::ranges::sort(sorted);
  report.median_drift_m = sorted[sorted.size() / 2];
}

}  // namespace

Result<SettleReport> settle(const scene::Scene& scene, const SettleOptions& options) {
  SettleReport report;
  const std::vector<std::uint32_t> rows = products_in(scene, options);
  report.products = static_cast<int>(rows.size());
  if (rows.empty()) return report;

  const auto compile_start = Clock::now();
  MARKETGEN_TRY(const SettleModel built, settle_model(scene, rows, still_margin_m));
  MARKETGEN_TRY(const MujocoData data, make_data(*built.model, "settle"));
  report.compile_s = seconds_since(compile_start);

  const auto simulate_start = Clock::now();
  MARKETGEN_TRY(const std::vector<double> drift,
                drifts(*built.model, *data, rows.size(), options.settle_s + options.watch_s));
  report.simulate_s = seconds_since(simulate_start);
  summarize(drift, scene, rows, report);
  return report;
}

std::string physics_version() {
  return mj_versionString();
}

}  // namespace marketgen::physics
