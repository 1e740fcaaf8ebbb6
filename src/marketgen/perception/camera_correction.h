// Corrects where cameras at a counter are said to stand: calibration is a few millimetres and
// tenths of a degree off. The counter's top, which the arm's base stands on, is level at z = 0; and
// what two cameras see of the same surface is in one place.
#pragma once
#include <vector>

#include "agent/workplace.h"
#include "perception/view_cloud.h"

namespace marketgen::perception {

// Moves the views: height and tilt of each by what it sees of the counter, place and turn over the
// counter by what the others see of the same goods: all meet in the middle, since none is known to
// be better. As far as the pictures tell: what they do not tell stays as it was.
void correct_cameras(std::vector<ViewCloud>& views, const agent::Workplace& place);

}  // namespace marketgen::perception
