// What a grasp server says, as AnyGrasp and GraspNet have it.
//
// {"grasp_groups": [...]}, each a row of 17 numbers (score, width, height, depth, rotation 9 row by
// row, translation 3, object) or an object with "translation", "rotation_matrix", "depth", "score"
// and, where the server tells it, "width", as GenManip's server of AnyGrasp sends it.
#pragma once
#include <string>
#include <vector>

#include "base/result.h"
#include "geometry/vector.h"

namespace marketgen::perception {

// In the camera's frame (OpenCV's axes), metres.
struct NetworkGrasp {
  Vec3 center;             // between the fingers
  Vec3 approach, closing;  // unit, at right angles
  double depth_m = 0;      // how far the fingers' ends reach beyond the centre
  double width_m = 0;      // between them; 0: not told
  double score = 0;
};

constexpr std::size_t max_network_grasps = 1000;  // of one answer, best first; the rest is dropped

// Best first, those that are no grasp left out: values that are not finite, axes that are none.
// Errors: perception.bad_answer, also when all of several are none.
Result<std::vector<NetworkGrasp>> read_grasps(const std::string& answer);

}  // namespace marketgen::perception
