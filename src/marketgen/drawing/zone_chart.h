// Charts that could pass for drawings of zones.
#pragma once
#include <string>
#include <vector>

#include <opencv2/core.hpp>

#include "base/result.h"
#include "drawing/zone_segments.h"
#include "drawing/zone_words.h"

namespace marketgen::drawing {

// drawing.chart.
inline Error chart(const std::string& kind, const std::string& where) {
  return {"drawing.chart",
          where,
          "this looks like a " + kind +
              ", not like the floor of a shop; draw the walls with their doors, and in them zones "
              "with a name on each"};
}

// All that is coloured is one ellipse, parts of different colours meet in its middle.
bool is_pie_chart(const cv::Mat& picture);

// Within a frame without doors (`floor`, on the picture) three or more bars without words stand on
// one side of it, with floor left over at their ends; beside it stand numbers as on an axis, or the
// bars stand apart from one another and no legend names them.
bool is_bar_chart(const Segments& segments,
                  const cv::Rect& floor,
                  const std::vector<WrittenLine>& lines);

}  // namespace marketgen::drawing
