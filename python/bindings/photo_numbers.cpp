// What tools/shop_photos/make_bank.py makes the bank of photos from: the numbers that the reader of
// photos sees.
#include <nanobind/ndarray.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include "binding.h"
#include "io/json.h"
#include "photo/features.h"

namespace marketgen::python {
namespace {

using NumberRows = nb::ndarray<nb::numpy, double, nb::ndim<2>>;

NumberRows array_of(const std::vector<std::vector<double>>& rows) {
  const std::size_t columns = rows.empty() ? 0 : rows[0].size();
  auto* kept = new std::vector<double>;
  for (const std::vector<double>& row : rows)
    kept->insert(kept->end(), row.begin(), row.end());
  const nb::capsule owner(kept,
                          [](void* p) noexcept { delete static_cast<std::vector<double>*>(p); });
  return NumberRows(kept->data(), {rows.size(), columns}, owner);
}

photo::Looked looked_at(const std::string& path) {
  return value_or_raise(photo::looked_at(std::filesystem::path(path)));
}

// Columns of the grid of cells, and a row per cell.
nb::tuple first_numbers(const std::string& path) {
  const photo::Cells cells = photo::cells_of(looked_at(path));
  return nb::make_tuple(cells.columns, array_of(photo::first_numbers(cells)));
}

NumberRows second_numbers(const std::string& path, const std::string& first_model) {
  const auto model = value_or_raise(io::read_json<photo::PartModel>(first_model, "model"));
  const photo::Cells cells = photo::cells_of(looked_at(path));
  const std::vector<std::vector<double>> first = photo::first_numbers(cells);
  return array_of(photo::second_numbers(cells, first, photo::parts_by(model, first)));
}

// Features by group.
nb::dict features(const std::string& path,
                  const std::string& first_model,
                  const std::string& second_model) {
  photo::Bank bank;
  bank.first_parts = value_or_raise(io::read_json<photo::PartModel>(first_model, "model"));
  bank.second_parts = value_or_raise(io::read_json<photo::PartModel>(second_model, "model"));
  const photo::Looked looked = looked_at(path);
  const photo::Cells cells = photo::cells_of(looked);
  const photo::Features found = photo::features_of(looked, cells, photo::parts_of(cells, bank));
  nb::dict groups;
  for (std::size_t i = 0; i < photo::group_names.size(); ++i)
    groups[nb::str(std::string(photo::group_names[i]).c_str())] = nb::cast(found.groups[i]);
  return groups;
}

}  // namespace

void add_photo_numbers(nb::module_& module) {
  module.def("_photo_first_numbers", &first_numbers);
  module.def("_photo_second_numbers", &second_numbers);
  module.def("_photo_features", &features);
}

}  // namespace marketgen::python
