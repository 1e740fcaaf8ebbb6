// Pictures of an episode's cameras, as a page asks for them: ?camera=wrist_camera&width=480.
#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "base/result.h"
#include "episodes/recorded_view.h"
#include "web/http_message.h"

namespace marketgen::server {

struct CameraAsk {
  std::string camera;
  int width = 0;  // pixels; the height is three quarters of it
};

// By itself the first of `cameras`, of which there is one or more. Error server.bad_request.
Result<CameraAsk> camera_ask(const web::HttpAsk& ask, const std::vector<std::string>& cameras);
// As JPEG. Errors: those of RecordedView::picture.
Result<web::HttpReply> camera_reply(episodes::RecordedView& view,
                                    std::size_t step,
                                    const CameraAsk& asked);

}  // namespace marketgen::server
