#include "assets/shapes/convex_worker.h"

#include "geometry/weld.h"
#include "io/json.h"
#include "io/program.h"

namespace marketgen::assets {
namespace {

constexpr std::size_t max_triangles = 200'000;
constexpr double weld_m = 1e-6;

struct PiecesRequest {
  std::vector<float> positions;
  std::vector<std::uint32_t> triangles;
  double threshold = 0.05;  // CoACD's own default concavity: 0.01 fine, 1 one hull
  int max_pieces = 16, max_points = 64;
  static constexpr auto fields =
      field_list(field("positions", &PiecesRequest::positions, "x, y, z of each vertex"),
                 field("triangles", &PiecesRequest::triangles, "three vertices each"),
                 field("threshold", &PiecesRequest::threshold, "concavity that is left"),
                 field("max_pieces", &PiecesRequest::max_pieces, "pieces"),
                 field("max_points", &PiecesRequest::max_points, "points of a piece"));
};

struct PiecesAnswer {
  std::vector<std::vector<float>> pieces;
  static constexpr auto fields =
      field_list(field("pieces", &PiecesAnswer::pieces, "x, y, z of each point", required()));
};

PiecesRequest request_of(const Mesh& mesh) {
  PiecesRequest request;
  const std::vector<std::uint32_t> welded = weld_positions(mesh.positions, weld_m);
  for (const Vec3f& p : mesh.positions)
    request.positions.insert(request.positions.end(), {p.x, p.y, p.z});
  for (const auto& triangle : mesh.triangles) {
    for (const std::uint32_t vertex : triangle)
      request.triangles.push_back(welded[vertex]);
  }
  return request;
}

}  // namespace

Result<std::vector<std::vector<Vec3f>>> convex_pieces(const Mesh& mesh) {
  if (mesh.triangles.size() > max_triangles)
    return Error{"input.too_large", "mesh", "has more than 200,000 triangles"};
  MARKETGEN_TRY(const std::string answer,
                io::run_worker("convex_pieces", io::write_json_line(request_of(mesh)), 120));
  MARKETGEN_TRY(const PiecesAnswer read, io::read_json<PiecesAnswer>(answer, "worker"));
  std::vector<std::vector<Vec3f>> pieces;
  for (const std::vector<float>& values : read.pieces) {
    std::vector<Vec3f> points;
    for (std::size_t i = 0; i + 2 < values.size(); i += 3)
      points.push_back({values[i], values[i + 1], values[i + 2]});
    if (points.size() >= 4) pieces.push_back(std::move(points));
  }
  if (pieces.empty()) return Error{"program.failed", "coacd", "gave no pieces"};
  return pieces;
}

}  // namespace marketgen::assets
