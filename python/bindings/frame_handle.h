// A picture that Python holds; its planes are NumPy arrays over this memory.
#pragma once
#include <nanobind/nanobind.h>

#include "render/render.h"

namespace marketgen::python {

struct FrameHandle {
  render::Frame frame;
};

void add_frames(nanobind::module_& module);

}  // namespace marketgen::python
