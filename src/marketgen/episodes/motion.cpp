#include "episodes/motion.h"

#include <algorithm>
#include <span>

#include "io/file.h"
#include "io/flatbuffer.h"
#include "io/gzip.h"

namespace marketgen::episodes {
namespace {

// Rows of something that moved now and then: ascending steps that the motion has, `numbers` each.
bool fits(const std::vector<std::uint32_t>& steps,
          const std::vector<float>& values,
          std::size_t numbers,
          std::size_t all_steps) {
  return values.size() == numbers * steps.size() &&
         std::ranges::adjacent_find(steps, std::greater_equal{}) == steps.end() &&
         (steps.empty() || steps.back() < all_steps);
}

bool is_whole(const Motion& motion) {
  const std::size_t all = motion.steps();
  return !motion.dofs.empty() && motion.states.size() == all * motion.dofs.size() &&
         motion.store_from_robot.size() == pose_numbers &&
         std::ranges::all_of(motion.things,
                             [&](const ThingMotion& thing) {
                               return fits(thing.steps, thing.poses, pose_numbers, all);
                             }) &&
         std::ranges::all_of(motion.joints,
                             [&](const JointMotion& joint) {
                               return fits(joint.steps, joint.positions, 1, all);
                             }) &&
         std::ranges::all_of(motion.events, [&](const MotionEvent& event) {
           return event.step <= event.last_step && event.last_step < all;
         });
}

}  // namespace

std::string pack_motion(const Motion& motion) {
  return io::gzip(io::write_flatbuffer_of(type_of<Motion>(), &motion, motion_file_identifier));
}

Result<Motion> unpack_motion(std::string_view packed, const std::string& source) {
  MARKETGEN_TRY(const std::string bytes, io::gunzip(packed, source));
  Motion motion;
  MARKETGEN_CHECK(io::read_flatbuffer_into(
      std::as_bytes(std::span(bytes)), source, motion_file_identifier, type_of<Motion>(), &motion));
  if (is_whole(motion)) return motion;
  return Error{"scene.corrupt",
               source,
               "its tables do not fit together: it was changed; record the motion again"};
}

Result<Motion> read_motion(const std::filesystem::path& file) {
  MARKETGEN_TRY(const std::string packed, io::read_file(file));
  return unpack_motion(packed, file.string());
}

}  // namespace marketgen::episodes
