#include "photo/parts.h"

#include <algorithm>
#include <cmath>

namespace marketgen::photo {
namespace {

constexpr std::size_t place_numbers = 6, contexts = 6;
constexpr int around = 2;  // cells to each side of a block

// Mean over the cells of a rectangle, ends excluded, cut to the photo; zeros where nothing is left.
template <std::size_t count>
std::array<double, count> mean_over(const std::vector<std::array<double, count>>& rows,
                                    const Cells& cells,
                                    cv::Rect block) {
  block &= cv::Rect(0, 0, cells.columns, cells.rows);
  std::array<double, count> mean{};
  for (int y = block.y; y < block.br().y; ++y) {
    for (int x = block.x; x < block.br().x; ++x) {
      const auto& row = rows[static_cast<std::size_t>(y) * cells.columns + x];
      for (std::size_t i = 0; i < count; ++i)
        mean[i] += row[i];
    }
  }
  for (double& sum : mean)
    sum /= std::max(1, block.area());
  return mean;
}

template <class Range>
void append(std::vector<double>& to, const Range& numbers) {
  to.insert(to.end(), numbers.begin(), numbers.end());
}

std::array<double, place_numbers> place_of(const Cells& cells, int column, int row) {
  const double x = std::abs(2.0 * (column + 0.5) / cells.columns - 1);
  const double y = 2.0 * (row + 0.5) / cells.rows - 1;
  return {x, y, x * x, y * y, x * y, static_cast<double>(cells.rows) / cells.columns};
}

double weighted_sum(const double* weights, const std::vector<double>& inputs) {
  double sum = weights[inputs.size()];
  for (std::size_t i = 0; i < inputs.size(); ++i)
    sum += weights[i] * inputs[i];
  return sum;
}

PartShares softmax(const PartShares& scores) {
  const double most = *std::ranges::max_element(scores);
  PartShares shares{};
  double all = 0;
  for (std::size_t i = 0; i < part_count; ++i)
    all += shares[i] = std::exp(scores[i] - most);
  for (double& share : shares)
    share /= all;
  return shares;
}

}  // namespace

std::size_t first_number_count() {
  return number::count + 6 + place_numbers;
}

std::size_t second_number_count() {
  return first_number_count() + contexts * part_count;
}

std::vector<std::vector<double>> first_numbers(const Cells& cells) {
  std::vector<std::vector<double>> all;
  for (int row = 0; row < cells.rows; ++row) {
    for (int column = 0; column < cells.columns; ++column) {
      const CellNumbers& own = cells.at(column, row);
      std::vector<double>& numbers = all.emplace_back(own.begin(), own.end());
      const CellNumbers near = mean_over(cells.numbers, cells, cv::Rect(column - 1, row - 1, 3, 3));
      for (std::size_t c = number::mean; c < number::mean + 3; ++c)
        numbers.push_back(own[c] - near[c]);
      for (std::size_t c = number::mean; c < number::mean + 3; ++c)
        numbers.push_back(own[c] - cells.whole[c]);
      append(numbers, place_of(cells, column, row));
    }
  }
  return all;
}

std::vector<std::vector<double>> second_numbers(const Cells& cells,
                                                const std::vector<std::vector<double>>& first,
                                                const std::vector<PartShares>& said) {
  const PartShares whole = mean_over(said, cells, cv::Rect(0, 0, cells.columns, cells.rows));
  std::vector<std::vector<double>> all = first;
  std::size_t at = 0;
  for (int row = 0; row < cells.rows; ++row) {
    const PartShares beside = mean_over(said, cells, cv::Rect(0, row, cells.columns, 1));
    for (int column = 0; column < cells.columns; ++column, ++at) {
      append(all[at], said[at]);
      constexpr int side = 2 * around + 1;
      append(all[at], mean_over(said, cells, cv::Rect(column - around, row - around, side, side)));
      append(all[at], mean_over(said, cells, cv::Rect(column - 1, 0, 3, row)));
      append(all[at], mean_over(said, cells, cv::Rect(column - 1, row + 1, 3, cells.rows)));
      append(all[at], beside);
      append(all[at], whole);
    }
  }
  return all;
}

std::vector<PartShares> parts_by(const PartModel& model,
                                 const std::vector<std::vector<double>>& numbers) {
  const std::size_t inputs = model.mean.size(), units = model.hidden.size() / (inputs + 1);
  std::vector<double> input(inputs), unit(units);
  std::vector<PartShares> all;
  all.reserve(numbers.size());
  for (const std::vector<double>& row : numbers) {
    for (std::size_t i = 0; i < inputs; ++i)
      input[i] = (row[i] - model.mean[i]) * model.scale[i];
    for (std::size_t u = 0; u < units; ++u)
      unit[u] = std::max(0.0, weighted_sum(&model.hidden[u * (inputs + 1)], input));
    PartShares scores{};
    for (std::size_t part = 0; part < part_count; ++part)
      scores[part] = weighted_sum(&model.output[part * (units + 1)], unit);
    all.push_back(softmax(scores));
  }
  return all;
}

std::vector<PartShares> parts_of(const Cells& cells, const Bank& bank) {
  const std::vector<std::vector<double>> first = first_numbers(cells);
  return parts_by(bank.second_parts,
                  second_numbers(cells, first, parts_by(bank.first_parts, first)));
}

}  // namespace marketgen::photo
