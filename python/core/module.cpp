/// The extension module perimpact._core; python/src/perimpact defines its public names.
#include "base/error.hpp"
#include "deforming_bindings.hpp"
#include "fccda_bindings.hpp"
#include "mesh.hpp"
#include "simulation_bindings.hpp"

PYBIND11_MODULE(_core, module) {
  namespace py = pybind11;
  using namespace perimpact::python;
  py::register_exception<fccda::InputError>(module, "InputError", PyExc_ValueError).doc() =
      "Invalid input. The message gives location, cause and remedy, as on the command line.";
  py::register_exception<fccda::RunError>(module, "RunError", PyExc_RuntimeError).doc() =
      "The simulation cannot continue: it became unstable, or a file cannot be written.";
  module.attr("__version__") = PERIMPACT_VERSION;
  bind_mesh(module);
  bind_simulation(module);
  py::module_ fccda = module.def_submodule("fccda");
  bind_fccda(fccda);
  bind_deforming(fccda);
}
