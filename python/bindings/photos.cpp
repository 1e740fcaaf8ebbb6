#include "photo/read_photo.h"

#include <nanobind/stl/string.h>

#include "binding.h"
#include "io/file.h"
#include "io/json.h"

namespace marketgen::python {
namespace {

// A PhotoReading as JSON.
std::string read_photo(const std::string& path) {
  const photo::PhotoReading reading =
      value_or_raise(without_interpreter([&]() -> Result<photo::PhotoReading> {
        MARKETGEN_TRY(const std::filesystem::path data, io::data_folder());
        MARKETGEN_TRY(const photo::Bank bank, photo::load_bank(data));
        return photo::read_photo(path, bank);
      }));
  return io::write_json(reading);
}

}  // namespace

void add_photos(nb::module_& module) {
  module.def("read_photo", &read_photo);
}

}  // namespace marketgen::python
