#include "drawing/zone_words.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include <opencv2/imgproc.hpp>

#include "geometry/image.h"
#include "io/png.h"
#include "io/program.h"

namespace marketgen::drawing {
namespace {

constexpr int line_px = 40, between_px = 36;  // of the page that is read
constexpr std::size_t max_lines = 60;
constexpr double ocr_seconds = 20;

struct Marks {
  cv::Mat small;  // ink without walls and other long lines
  std::vector<cv::Rect> letters;
};

Marks marks_of(const cv::Mat& ink, double side) {
  cv::Mat labels, stats, centres;
  const int count = cv::connectedComponentsWithStats(ink, labels, stats, centres, 8, CV_32S);
  std::vector<bool> large(count, true);
  Marks marks;
  marks.small = ink.clone();
  for (int i = 1; i < count; ++i) {
    const cv::Rect box(stats.at<int>(i, cv::CC_STAT_LEFT),
                       stats.at<int>(i, cv::CC_STAT_TOP),
                       stats.at<int>(i, cv::CC_STAT_WIDTH),
                       stats.at<int>(i, cv::CC_STAT_HEIGHT));
    const double longer = std::max(box.width, box.height),
                 shorter = std::min(box.width, box.height);
    // A frame around a legend's square is a square without much ink in it.
    const bool frame = shorter > 0.02 * side && longer < 1.25 * shorter &&
                       stats.at<int>(i, cv::CC_STAT_AREA) < 0.3 * box.area();
    const bool wall = longer > 0.02 * side && shorter < 0.12 * longer && box.width < box.height;
    large[i] = box.height > 0.07 * side || longer > 0.15 * side || frame || wall;
    if (!large[i] && box.height >= 0.006 * side) marks.letters.push_back(box);
  }
  for (int y = 0; y < ink.rows; ++y)
    for (int x = 0; x < ink.cols; ++x)
      if (large[labels.at<int>(y, x)]) marks.small.at<std::uint8_t>(y, x) = 0;
  return marks;
}

double median_height(const std::vector<cv::Rect>& letters) {
  std::vector<int> heights;
  for (const cv::Rect& box : letters)
    heights.push_back(box.height);
  std::ranges::nth_element(heights, heights.begin() + heights.size() / 2);
  return heights[heights.size() / 2];
}

bool is_ascii(std::string_view text) {
  return std::ranges::all_of(text, [](char c) { return static_cast<unsigned char>(c) < 128; });
}

std::vector<std::string_view> split(std::string_view text, char at) {
  std::vector<std::string_view> parts;
  std::size_t from = 0;
  while (from <= text.size()) {
    const std::size_t to = std::min(text.find(at, from), text.size());
    parts.push_back(text.substr(from, to - from));
    from = to + 1;
  }
  return parts;
}

double number_of(std::string_view text) {
  double value = 0;
  const auto end = std::from_chars(text.data(), text.data() + text.size(), value);
  return end.ec == std::errc{} ? value : 0;
}

// Nothing but what stands within words, so that specks do not become letters.
std::string_view trimmed(std::string_view text) {
  constexpr std::string_view blank = " \t\r\n|_-.,'`\"~*:;";
  while (!text.empty() && blank.find(text.front()) != std::string_view::npos)
    text.remove_prefix(1);
  while (!text.empty() && blank.find(text.back()) != std::string_view::npos)
    text.remove_suffix(1);
  return text;
}

// Digits or letters; strokes of hatching are read as signs and as the Chinese one and two.
bool is_word(std::string_view word) {
  if (word == "一" || word == "二") return false;
  const bool written = std::ranges::any_of(word, [](char c) {
    return static_cast<unsigned char>(c) >= 0xE4 || (c >= '0' && c <= '9') ||
           (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || c == '&';
  });
  return written;
}

// All lines below one another, black on white, each as high as the others.
cv::Mat page_of(const cv::Mat& bgr,
                const cv::Mat& letters,
                const std::vector<cv::Rect>& boxes,
                std::vector<int>& rows) {
  std::array<cv::Mat, 3> channels;
  cv::split(bgr, channels.data());
  cv::Mat grey = cv::max(cv::max(channels[0], channels[1]), channels[2]);  // colour becomes light
  cv::Mat near;
  cv::dilate(letters, near, cv::Mat::ones(7, 7, CV_8UC1));
  grey.setTo(255, near == 0);
  std::vector<cv::Mat> lines;
  int width = 0;
  for (const cv::Rect& box : boxes) {
    const double by = static_cast<double>(line_px) / box.height;
    cv::Mat line;
    // The ground around the letters, whatever its colour, becomes white.
    const cv::Mat ground = near(box) & ~letters(box);
    const double white = std::max(60.0, cv::mean(grey(box), ground)[0] - 12);
    grey(box).convertTo(line, CV_8U, 255 / white);
    cv::normalize(line, line, 0, 255, cv::NORM_MINMAX);
    cv::resize(
        line, line, {std::clamp(cvRound(box.width * by), 1, 3000), line_px}, 0, 0, cv::INTER_CUBIC);
    width = std::max(width, line.cols);
    lines.push_back(line);
  }
  cv::Mat page(static_cast<int>(lines.size()) * (line_px + between_px) + between_px,
               width + 2 * between_px,
               CV_8UC1,
               cv::Scalar(255));
  int y = between_px;
  for (const cv::Mat& line : lines) {
    rows.push_back(y - between_px / 2);
    line.copyTo(page(cv::Rect(between_px, y, line.cols, line.rows)));
    y += line_px + between_px;
  }
  rows.push_back(y - between_px / 2);
  return page;
}

Result<std::string> tesseract(const cv::Mat& page, const std::string& languages) {
  Image image(page.cols, page.rows, 1);
  for (int y = 0; y < page.rows; ++y)
    std::copy_n(page.ptr<std::uint8_t>(y), page.cols, image.at(0, y));
  MARKETGEN_TRY(const std::string png, io::encode_png(image));
  auto answer = io::run_program(
      {"env", "OMP_THREAD_LIMIT=1", "tesseract", "-", "-", "-l", languages, "--psm", "6", "tsv"},
      png,
      {.seconds = ocr_seconds});
  if (answer.ok()) return answer;
  const std::string message = to_string(answer.error());
  const bool missing =
      message.find("No such file") != std::string::npos || message.find("127") != std::string::npos;
  return Error{missing ? "usage.unavailable" : answer.error().code,
               "tesseract",
               "what is written on the drawing cannot be read (" + message +
                   "); install the Debian packages tesseract-ocr and tesseract-ocr-chi-sim"};
}

Result<std::vector<WrittenLine>> read_page(const cv::Mat& bgr,
                                           const cv::Mat& letters,
                                           const std::vector<cv::Rect>& boxes,
                                           const std::string& languages) {
  std::vector<int> rows;
  const cv::Mat page = page_of(bgr, letters, boxes, rows);
  MARKETGEN_TRY(const std::string tsv, tesseract(page, languages));
  std::vector<WrittenLine> lines = lines_of_tsv(tsv, rows);
  for (std::size_t i = 0; i < lines.size(); ++i)
    lines[i].box = boxes[i];
  return lines;
}

}  // namespace

cv::Mat letter_ink(const cv::Mat& bgr, double longer_side, bool hatched) {
  constexpr int window_share = 25;
  constexpr double darker = 0.76;
  std::array<cv::Mat, 3> channels;
  cv::split(bgr, channels.data());
  const cv::Mat high = cv::max(cv::max(channels[0], channels[1]), channels[2]);
  const cv::Mat low = cv::min(cv::min(channels[0], channels[1]), channels[2]);
  const int window = 2 * (static_cast<int>(longer_side) / window_share / 2) + 1;
  cv::Mat around;
  cv::blur(high, around, {window, window});
  around.convertTo(around, CV_8U, darker);
  cv::Mat ink = high < around;
  if (!hatched) return ink;
  // Beside coloured strokes, what is as dark as writing and has no colour near it.
  cv::Mat colour = high - low, near;
  const int stroke = 2 * cvRound(0.008 * longer_side) + 1;
  cv::blur(colour, near, {stroke, stroke});
  constexpr int written = 150, colourful = 14;
  return ink & (high < written) & (near < colourful);
}

std::vector<cv::Rect> lines_of_writing(const cv::Mat& ink,
                                       const cv::Mat& borders,
                                       double longer_side) {
  const Marks marks = marks_of(ink, longer_side);
  if (marks.letters.empty()) return {};
  const double height =
      std::clamp(median_height(marks.letters), 0.01 * longer_side, 0.05 * longer_side);
  cv::Mat joined;
  const int across = 2 * cvRound(0.75 * height) + 1, down = 2 * cvRound(0.12 * height) + 1;
  cv::dilate(marks.small, joined, cv::Mat::ones(down, across, CV_8UC1));
  joined.setTo(0, borders);
  cv::Mat labels, stats, centres;
  const int count = cv::connectedComponentsWithStats(joined, labels, stats, centres, 8, CV_32S);
  std::vector<cv::Rect> boxes;
  for (int i = 1; i < count; ++i) {
    const cv::Rect grown(stats.at<int>(i, cv::CC_STAT_LEFT),
                         stats.at<int>(i, cv::CC_STAT_TOP),
                         stats.at<int>(i, cv::CC_STAT_WIDTH),
                         stats.at<int>(i, cv::CC_STAT_HEIGHT));
    const int more = 1 + cvRound(0.12 * height);
    const cv::Rect box = cv::Rect(grown.x + across / 2 - more,
                                  grown.y + down / 2 - more,
                                  grown.width - across + 2 * more,
                                  grown.height - down + 2 * more) &
                         cv::Rect(0, 0, ink.cols, ink.rows);
    const bool line =
        box.height >= 0.45 * height && box.height < 3.5 * height && box.width >= 0.8 * height;
    const double inked = cv::countNonZero(marks.small(box)) / std::max(1.0, double(box.area()));
    if (line && inked > 0.06 && inked < 0.75 && boxes.size() < max_lines) boxes.push_back(box);
  }
  return boxes;
}

std::vector<WrittenLine> lines_of_tsv(std::string_view tsv, const std::vector<int>& rows) {
  std::vector<WrittenLine> lines(rows.empty() ? 0 : rows.size() - 1);
  std::vector<int> counts(lines.size());
  for (const std::string_view row : split(tsv, '\n')) {
    const std::vector<std::string_view> cells = split(row, '\t');
    constexpr std::size_t columns = 12;
    if (cells.size() < columns || cells[0] != "5") continue;
    const double confidence = number_of(cells[10]) / 100;
    const std::string_view word = trimmed(cells[11]);
    constexpr double least = 0.2;
    if (confidence < least || !is_word(word)) continue;
    const double y = number_of(cells[7]) + number_of(cells[9]) / 2;
    const auto next = std::ranges::upper_bound(rows, static_cast<int>(y));
    if (next == rows.begin() || next == rows.end()) continue;
    const std::size_t i = static_cast<std::size_t>(next - rows.begin()) - 1;
    WrittenLine& line = lines[i];
    const bool apart = !line.words.empty() && (is_ascii(word) || is_ascii(line.words));
    line.words += (apart ? " " : "") + std::string(word);
    line.confidence += (confidence - line.confidence) / ++counts[i];
  }
  return lines;
}

Result<std::vector<WrittenLine>> read_lines(const cv::Mat& bgr,
                                            const cv::Mat& ink,
                                            const std::vector<cv::Rect>& boxes,
                                            double longer_side) {
  if (boxes.empty()) return std::vector<WrittenLine>{};
  const cv::Mat letters = marks_of(ink, longer_side).small;
  MARKETGEN_TRY(std::vector<WrittenLine> lines, read_page(bgr, letters, boxes, "eng+chi_sim"));
  // With both languages at once Chinese is at times taken for Latin capitals: what is doubtful is
  // read once more as Chinese.
  constexpr double sure = 0.75;
  std::vector<std::size_t> doubtful;
  std::vector<cv::Rect> again;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const bool short_capitals = lines[i].words.size() <= 3 && is_ascii(lines[i].words);
    if (lines[i].confidence >= sure && !short_capitals) continue;
    doubtful.push_back(i);
    again.push_back(boxes[i]);
  }
  if (again.empty()) return lines;
  MARKETGEN_TRY(const std::vector<WrittenLine> chinese, read_page(bgr, letters, again, "chi_sim"));
  for (std::size_t k = 0; k < doubtful.size(); ++k) {
    WrittenLine& line = lines[doubtful[k]];
    const bool better = chinese[k].confidence > line.confidence ||
                        (is_ascii(line.words) && chinese[k].confidence > 0.5);
    if (better && !is_ascii(chinese[k].words)) line = chinese[k];
  }
  return lines;
}

std::optional<double> dimension_mm(std::string_view words) {
  std::string text;
  for (const char c : words)
    if (c != ' ') text += c == ',' ? '.' : c;
  const std::size_t digits = std::min(text.find_first_not_of("0123456789."), text.size());
  const double number = number_of(std::string_view(text).substr(0, digits));
  const std::string unit = text.substr(digits);
  constexpr double min_mm = 4000, max_mm = 200'000;
  double mm = 0;
  if (unit == "m" || unit == "M" || unit == "米") mm = number * 1000;
  if (unit == "cm" || unit == "厘米") mm = number * 10;
  if (unit == "mm" || unit == "毫米" || (unit.empty() && text.find('.') == std::string::npos))
    mm = number;
  if (mm < min_mm || mm > max_mm) return std::nullopt;
  return mm;
}

}  // namespace marketgen::drawing
