// The viewer's server inside Python's process, for marketgen/views.py.
#include <nanobind/stl/string.h>
#include <nanobind/stl/unique_ptr.h>

#include <memory>

#include "binding.h"
#include "environment_handle.h"
#include "server/serve.h"
#include "store_handle.h"

namespace marketgen::python {
namespace {

// One that notebooks of this machine may show.
struct ViewHandle {
  std::unique_ptr<server::ViewServer> server;  // none once it was closed
};

ViewHandle serve_store(const StoreHandle& handle, int port, bool watch) {
  server::ServeOptions options;
  options.port = port;
  options.embed = true;
  options.watch = watch;
  return {value_or_raise(without_interpreter([&] {
    return server::ViewServer::start(options,
                                     store::opened_stores({handle.store}, *handle.catalog));
  }))};
}

// An environment's episode as it is now; nothing once it was closed.
void watch(const ViewHandle& handle,
           EnvironmentHandle& environment,
           environments::EpisodeGround& ground,
           bool began) {
  if (handle.server == nullptr) return;
  world_of(environment);
  check_or_raise(without_interpreter(
      [&] { return handle.server->watched().watch(*environment.environment, ground, began); }));
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
      .def("watch", &watch)
      .def("close", &close);
  module.def("_serve", &serve_store, nb::arg("store"), nb::arg("port"), nb::arg("watch") = false);
}

}  // namespace marketgen::python
