// Heads: a skull with a face that is nobody's, neck, ears, and hair as caps over the skull.
//
// Head frame: origin between the ears, X ahead, Z up, metres of a head of 228 mm (stature 1.75 m).
#include <cmath>

#include "assets/people/part_fields.h"
#include "assets/people/soft_shapes.h"

namespace marketgen::assets {
namespace {

constexpr float flesh_m = 0.004F;  // mean way of light below skin

struct Head {
  Vec3f middle;
  float size, cos_left, sin_left, cos_down, sin_down;
  float width, nose, jaw, brow, neck;
  bool woman;
  Vec3f neck_foot;  // head frame

  Vec3f local(Vec3f p) const {
    const Vec3f d = (p - middle) / size;
    const float x = cos_left * d.x + sin_left * d.y, y = cos_left * d.y - sin_left * d.x;
    return {cos_down * x - sin_down * d.z, y, sin_down * x + cos_down * d.z};
  }
};

Head head_of(const PersonLook& look, const PersonFrame& frame) {
  Head head{};
  head.middle = frame.head;
  head.size = frame.head_size;
  head.cos_left = std::cos(frame.head_left_rad);
  head.sin_left = std::sin(frame.head_left_rad);
  head.cos_down = std::cos(frame.head_down_rad);
  head.sin_down = std::sin(frame.head_down_rad);
  head.width = static_cast<float>(look.face_width);
  head.nose = static_cast<float>(look.nose);
  head.jaw = static_cast<float>(look.jaw);
  head.brow = static_cast<float>(look.brow);
  head.woman = look.form == BodyForm::woman;
  head.neck = (head.woman ? 0.047F : 0.055F) * frame.broad;
  head.neck_foot = head.local(frame.neck + Vec3f{0, 0, -0.012F * frame.unit});
  return head;
}

float skull(Vec3f p, const Head& head, float over) {
  return ellipsoid(
      p, {-0.013F, 0, 0.034F}, {0.097F + over, 0.075F * head.width + over, 0.080F + over});
}

float jaw_bones(Vec3f p, Vec3f q, const Head& head, float over) {  // q: p, mirrored to the left
  const float w = head.width, j = head.jaw * (head.woman ? 0.92F : 1.0F);
  const float jaw = round_cone(q,
                               {0.012F, 0.040F * w * j, -0.058F},
                               {0.064F, 0.010F, -0.093F},
                               0.022F + over,
                               0.017F * j + over);
  return soft_min(
      jaw,
      ellipsoid(p, {0.028F, 0, -0.032F}, {0.060F + over, 0.058F * w + over, 0.074F + over}),
      0.03F);
}

float eye_and_brow(float d, Vec3f q, const Head& head) {
  const float b = 0.0072F * head.brow * (head.woman ? 0.8F : 1.0F);
  d = soft_min(
      d, round_cone(q, {0.0795F, 0.012F, 0.021F}, {0.064F, 0.043F, 0.020F}, b, b * 0.8F), 0.018F);
  d = soft_max(d, -ellipsoid(q, {0.096F, 0.031F, 0.003F}, {0.019F, 0.020F, 0.0125F}), 0.016F);
  // The lids: closed enough to look down on a shelf.
  d = soft_min(d, ellipsoid(q, {0.0735F, 0.031F, 0.0035F}, {0.0105F, 0.0145F, 0.0105F}), 0.006F);
  return d;
}

float nose_and_mouth(float d, Vec3f p, Vec3f q, const Head& head) {
  const float n = head.nose;
  d = soft_min(
      d,
      round_cone(
          p, {0.079F, 0, 0.012F}, {0.099F + 0.006F * n, 0, -0.024F}, 0.0065F, 0.0075F + 0.002F * n),
      0.014F);
  d = soft_min(
      d, ellipsoid(q, {0.093F, 0.0105F * n, -0.0285F}, {0.010F, 0.0065F, 0.0065F}), 0.008F);
  d = soft_max(d, -ellipsoid(q, {0.0985F, 0.0065F, -0.0365F}, {0.005F, 0.0032F, 0.003F}), 0.003F);
  d = soft_min(d, ellipsoid(p, {0.079F, 0, -0.054F}, {0.016F, 0.027F, 0.017F}), 0.016F);
  return soft_min(d, ellipsoid(p, {0.080F, 0, -0.095F}, {0.013F, 0.017F, 0.012F}), 0.022F);
}

float ear(Vec3f q, const Head& head) {
  const Vec3f at{-0.006F, 0.0765F * head.width, -0.003F};
  const float tilt = 0.25F;
  const Vec3f d{q.x - at.x + tilt * (q.z - at.z), q.y - at.y - 0.35F * (at.x - q.x), q.z - at.z};
  const float body = ellipsoid(d, {0, 0, 0}, {0.0175F, 0.0075F, 0.031F});
  return soft_max(
      body, -ellipsoid(d, {0.003F, 0.0085F, 0.004F}, {0.010F, 0.0055F, 0.018F}), 0.004F);
}

float skin(Vec3f p, const Head& head) {
  const Vec3f q{p.x, std::abs(p.y), p.z};
  float d = soft_min(skull(p, head, 0), jaw_bones(p, q, head, 0), 0.03F);
  d = soft_min(
      d, ellipsoid(q, {0.054F, 0.038F * head.width, -0.022F}, {0.022F, 0.023F, 0.02F}), 0.03F);
  d = eye_and_brow(d, q, head);
  d = nose_and_mouth(d, p, q, head);
  d = soft_min(d, ear(q, head), 0.006F);
  const float neck =
      round_cone(p, {-0.018F, 0, -0.05F}, head.neck_foot, head.neck, head.neck * 1.12F);
  return soft_min(d, neck, 0.025F);
}

// Above and behind the hairline; less than 0 where hair grows.
float hairline(Vec3f q, float lowest) {
  const float face = ellipsoid(q, {0.094F, 0, -0.022F}, {0.066F, 0.078F, 0.108F});
  const float side = ellipsoid(q, {0.034F, 0.085F, -0.055F}, {0.034F, 0.05F, 0.080F});
  const float low = lowest - 0.25F * (q.x + 0.03F) - q.z;
  return soft_max(soft_max(-face, -side, 0.012F), low, 0.012F);
}

float strands(Vec3f p, float depth) {
  const float round = std::atan2(p.y, p.x + 0.35F * p.z + 0.02F);
  return depth * (std::sin(round * 34 + 9 * p.z) * 0.6F + std::sin(round * 71 - 31 * p.z) * 0.4F);
}

// How much thinner hair is near its edge, where `edge` (0 there, less than 0 within) says.
float thinned(float edge, float thick) {
  return 0.75F * thick * std::clamp(1 + edge / 0.022F, 0.0F, 1.0F);
}

// Hair as a cap: cropped, short, or drawn back to a bun.
float short_cap(Vec3f p, Vec3f q, const Head& head, HairCut cut) {
  const bool cropped = cut == HairCut::cropped;
  const float thick = cropped ? 0.0035F : 0.011F, edge = hairline(q, -0.058F);
  float cap = skull(p, head, thick);
  if (!cropped)  // fuller on top, parted on one side
    cap = soft_min(
        cap, ellipsoid(p, {-0.008F, 0.004F, 0.061F}, {0.088F, 0.070F * head.width, 0.066F}), 0.03F);
  cap += thinned(edge, thick) + strands(p, cropped ? 0.0004F : 0.0014F);
  const float d = soft_max(cap, edge, 0.004F);
  if (cut != HairCut::bun) return d;
  const float bun = ellipsoid(p, {-0.115F, 0, 0.052F}, {0.031F, 0.034F, 0.031F});
  return soft_min(d, bun + strands(q, 0.001F), 0.008F);
}

float hair(Vec3f p, const Head& head, HairCut cut) {
  const Vec3f q{p.x, std::abs(p.y), p.z};
  const bool bob = cut == HairCut::bob;
  if (!bob && cut != HairCut::long_hair) return short_cap(p, q, head, cut);
  constexpr float thick = 0.013F;
  const float down = bob ? -0.095F : -0.215F;
  const float curtain = round_cone(q,
                                   {-0.022F, 0.052F * head.width, 0.010F},
                                   {-0.045F, 0.058F * head.width, down},
                                   0.040F,
                                   bob ? 0.030F : 0.020F);
  const float back = round_cone(p, {-0.045F, 0, 0}, {-0.075F, 0, down}, 0.070F, 0.030F);
  const float fall = soft_min(curtain, back, 0.05F);
  const float top = ellipsoid(p, {-0.008F, 0, 0.060F}, {0.088F, 0.072F * head.width, 0.066F});
  const float cap = soft_min(skull(p, head, thick), top, 0.03F);
  const float edge = -ellipsoid(q, {0.086F, 0, -0.032F}, {0.072F, 0.0665F, 0.108F});
  const float whole = soft_min(cap, fall, 0.03F) + strands(p, 0.0014F);
  return soft_max(whole + thinned(edge, thick), edge, 0.006F);
}

float beard(Vec3f p, const Head& head) {
  const Vec3f q{p.x, std::abs(p.y), p.z};
  const float chin = soft_min(jaw_bones(p, q, head, 0.004F),
                              ellipsoid(p, {0.080F, 0, -0.092F}, {0.017F, 0.022F, 0.018F}),
                              0.02F);
  const float mouth = ellipsoid(p, {0.095F, 0, -0.0575F}, {0.03F, 0.024F, 0.0085F});
  const float line = q.z + 0.034F - 0.62F * std::max(q.y - 0.018F, 0.0F);
  const float low = -0.108F - q.z;
  return soft_max(soft_max(chin, -mouth, 0.006F), soft_max(line, low, 0.006F), 0.006F) +
         strands(p, 0.0004F);
}

// A patch of another colour: where `outline` (about a distance, seen from ahead) is less than 0,
// `over` metres above the skin.
float patch(Vec3f p, const Head& head, float outline, float over) {
  const float depth = skin(p, head);
  const float sheet = std::max(depth - over, -depth - 0.003F);
  return soft_max(std::max(sheet, 0.03F - p.x), outline, 0.0005F);
}

// A band along the arc z = height + rise * (1 - (y - middle)^2 / half^2), thin at its ends.
float band(Vec3f q, float middle, float half, float height, float rise, float thick) {
  const float t = (q.y - middle) / half;
  const float line = height + rise * (1 - t * t) - 0.25F * rise * t;
  return std::max(std::abs(q.z - line) - thick * (1 - 0.55F * t * t), (std::abs(t) - 1) * half);
}

float brows(Vec3f p, const Head& head) {
  const Vec3f q{p.x, std::abs(p.y), p.z};
  const float thick = head.woman ? 0.0019F : 0.0028F;
  return patch(p, head, band(q, 0.0305F, 0.0175F, 0.0200F, 0.0040F, thick), 0.0012F);
}

constexpr float eye_y = 0.0310F, eye_z = 0.0025F, eye_half = 0.0125F;

// Between the lids, as two arcs.
float eye_opening(Vec3f q) {
  const float t = (q.y - eye_y) / eye_half, open = 1 - t * t;
  const float z = q.z - eye_z - 0.0010F * t;
  return std::max(z - 0.0040F * open, -z - 0.0026F * open);
}

float eyes(Vec3f p, const Head& head) {
  return patch(p, head, eye_opening({p.x, std::abs(p.y), p.z}), 0.0003F);
}

float irises(Vec3f p, const Head& head) {
  const Vec3f q{p.x, std::abs(p.y), p.z};
  const float dy = q.y - eye_y + 0.0005F, dz = q.z - eye_z - 0.0008F;
  const float iris = std::sqrt(dy * dy + dz * dz) - 0.0050F;
  return patch(p, head, std::max(iris, eye_opening(q)), 0.0006F);
}

float lashes(Vec3f p, const Head& head) {
  const Vec3f q{p.x, std::abs(p.y), p.z};
  const float tilt = 0.0010F * (q.y - eye_y) / eye_half;
  const float thick = head.woman ? 0.0010F : 0.0007F;
  return patch(p,
               head,
               band({q.x, q.y, q.z - tilt}, eye_y, eye_half * 1.06F, eye_z, 0.0042F, thick),
               0.0009F);
}

float lips(Vec3f p, const Head& head) {
  const float y = std::abs(p.y), t = y / (head.woman ? 0.0225F : 0.0235F),
              z = p.z + 0.0575F - 0.0014F * t * t;  // corners a little up

  const float open = std::max(1 - t * t, -1.0F);
  const float bow = 0.0012F * std::max(1 - y / 0.006F, 0.0F);
  const float full = head.woman ? 1.15F : 0.85F;
  return patch(
      p, head, std::max(z - full * 0.0052F * open + bow, -z - full * 0.0066F * open), 0.0006F);
}

PartField part(const Head& head,
               const std::string& name,
               float (*shape)(Vec3f, const Head&),
               Vec3f low,
               Vec3f high,
               float cell) {
  const float reach = length(high - low) * 0.5F * head.size;
  PartField made{
      name, [=](Vec3f p) { return shape(head.local(p), head) * head.size; }, {}, cell, {}};
  // The box about the middle of the part holds it however the head is turned.
  const Vec3f at = (low + high) * 0.5F;
  const float x = head.cos_down * at.x + head.sin_down * at.z;
  const Vec3f turned{head.cos_left * x - head.sin_left * at.y,
                     head.sin_left * x + head.cos_left * at.y,
                     head.cos_down * at.z - head.sin_down * at.x};
  made.bounds = bounds_round({head.middle + turned * head.size}, reach);
  return made;
}

template <HairCut cut>
float hair_as(Vec3f p, const Head& head) {
  return hair(p, head, cut);
}

using Shape = float (*)(Vec3f, const Head&);
constexpr std::array<Shape, 6> hair_shapes{nullptr,
                                           &hair_as<HairCut::cropped>,
                                           &hair_as<HairCut::short_hair>,
                                           &hair_as<HairCut::bob>,
                                           &hair_as<HairCut::long_hair>,
                                           &hair_as<HairCut::bun>};

PartField colored(PartField part, Vec3f color, float roughness, float scatter_m = 0) {
  part.color = color;
  part.roughness = roughness;
  part.scatter_m = scatter_m;
  return part;
}

}  // namespace

std::vector<PartField> head_fields(const PersonLook& look, const PersonFrame& frame) {
  const Head head = head_of(look, frame);
  const Vec3f lip = look.skin * Vec3f{0.86F, 0.60F, 0.58F};
  const Vec3f low{-0.13F, -0.11F, -0.22F}, high{0.13F, 0.11F, 0.14F};
  const Vec3f eyes_low{0.04F, -0.055F, -0.01F}, eyes_high{0.11F, 0.055F, 0.035F};
  const Vec3f mouth_low{0.06F, -0.03F, -0.075F}, mouth_high{0.11F, 0.03F, -0.04F};
  const bool dark = look.skin.x < 0.35F;
  const Vec3f iris = dark ? Vec3f{0.025F, 0.014F, 0.009F} : Vec3f{0.05F, 0.045F, 0.04F};
  std::vector<PartField> parts{
      colored(part(head, "head", &skin, low, high, 0.0035F), look.skin, 0.5F, flesh_m),
      colored(part(head, "lips", &lips, mouth_low, mouth_high, 0.0018F), lip, 0.45F, flesh_m),
      colored(part(head, "eyes", &eyes, eyes_low, eyes_high, 0.0013F), {0.52F, 0.49F, 0.46F}, 0.3F),
      colored(part(head, "irises", &irises, eyes_low, eyes_high, 0.0013F), iris, 0.2F),
      colored(part(head, "lashes", &lashes, eyes_low, eyes_high, 0.0012F),
              look.hair_color * 0.3F,
              0.7F),
      colored(
          part(head, "brows", &brows, eyes_low, eyes_high, 0.0014F), look.hair_color * 0.8F, 0.8F)};
  if (const Shape shape = hair_shapes[static_cast<std::size_t>(look.hair)])
    parts.push_back(
        colored(part(head, "hair", shape, {-0.16F, -0.12F, -0.28F}, {0.11F, 0.12F, 0.15F}, 0.004F),
                look.hair_color,
                0.55F));
  if (look.beard)
    parts.push_back(
        colored(part(head, "beard", &beard, {-0.02F, -0.08F, -0.13F}, {0.12F, 0.08F, 0}, 0.003F),
                look.hair_color,
                0.75F));
  return parts;
}

}  // namespace marketgen::assets
