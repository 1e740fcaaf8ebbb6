// The viewer's server inside Python's process, for marketgen/views.py.
#include <nanobind/stl/string.h>
#include <nanobind/stl/unique_ptr.h>

#include <memory>

#include "binding.h"
#include "server/serve.h"
#include "store_handle.h"

namespace marketgen::python {
namespace {

// One that notebooks of this machine may show.
struct ViewHandle {
  std::unique_ptr<server::ViewServer> server;  // none once it was closed
};

ViewHandle serve(const StoreHandle& handle, int port) {
  server::ServeOptions options;
  options.port = port;
  options.embed = true;
  return {value_or_raise(without_interpreter([&] {
    return server::ViewServer::start(options, {{handle.store}, *handle.catalog});
  }))};
}

void close(ViewHandle& handle) {
  const nb::gil_scoped_release released;  // what is being answered goes to its end
  handle.server.reset();
}

}  // namespace

void add_views(nb::module_& module) {
  nb::class_<ViewHandle>(module, "_View")
      .def_prop_ro("address",
                   [](const ViewHandle& h) { return h.server ? h.server->address() : ""; })
      .def("close", &close);
  module.def("_serve", &serve, nb::arg("store"), nb::arg("port"));
}

}  // namespace marketgen::python
