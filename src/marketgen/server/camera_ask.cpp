#include "server/camera_ask.h"

#include <algorithm>
#include <cstdint>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "io/jpeg.h"
#include "server/answering.h"

namespace marketgen::server {
namespace {

constexpr std::uint64_t usual_picture_px = 480, min_picture_px = 64, max_picture_px = 1280;

}  // namespace

Result<CameraAsk> camera_ask(const web::HttpAsk& ask, const std::vector<std::string>& cameras) {
  const auto given = ask.query.find("camera");
  const std::string& camera = given == ask.query.end() ? cameras.front() : given->second;
  if (std::ranges::find(cameras, camera) == cameras.end())
    return Error{"server.bad_request",
                 "camera",
                 fmt::format("\"{}\" is none of: {}", camera, fmt::join(cameras, ", "))};
  MARKETGEN_TRY(const std::uint64_t width,
                number_in(ask, "width", usual_picture_px, min_picture_px, max_picture_px));
  return CameraAsk{camera, static_cast<int>(width)};
}

Result<web::HttpReply> camera_reply(episodes::RecordedView& view,
                                    std::size_t step,
                                    const CameraAsk& asked) {
  MARKETGEN_TRY(const Image image,
                view.picture(asked.camera, step, asked.width, asked.width * 3 / 4));
  MARKETGEN_TRY(std::string bytes, io::encode_jpeg(image));
  return reply_with({"camera.jpg", "image/jpeg", std::move(bytes)});
}

}  // namespace marketgen::server
