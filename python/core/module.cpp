/// The extension module perimpact._core; python/src/perimpact says what of it is public.
#include "base/error.hpp"
#include "fccda_bindings.hpp"
#include "mesh.hpp"
#include "simulation_bindings.hpp"

PYBIND11_MODULE(_core, module) {
  namespace py = pybind11;
  using namespace perimpact::python;
  py::register_exception<fccda::InputError>(module, "InputError", PyExc_ValueError).doc() =
      "What was given cannot be used. The text says where, what, why and what to do, as the command line does.";
  py::register_exception<fccda::RunError>(module, "RunError", PyExc_RuntimeError).doc() =
      "The simulation cannot go on: it became unstable, or a file cannot be written.";
  module.attr("__version__") = PERIMPACT_VERSION;
  bind_mesh(module);
  bind_simulation(module);
  py::module_ fccda = module.def_submodule("fccda");
  bind_fccda(fccda);
}
