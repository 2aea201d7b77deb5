#include "structures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "base/error.hpp"
#include "io/deck/did_you_mean.hpp"
#include "kept.hpp"

namespace perimpact::python {

namespace {

using fccda::InputError;

void expect_member(const StructureOfPython& structure, const char* member, const char* meaning) {
  if (!py::hasattr(structure.object, member))
    throw InputError(fmt::format("the structure of impactor {} has no {}; it needs {}.", structure.impactor, member, meaning));
}

std::vector<Vec3d> positions_in(const py::object& returned, const std::string& what) {
  py::array keep;
  const fccda::ConstVectors vectors = vectors_in(returned, what, keep, each_vertex);
  std::vector<Vec3d> positions;
  for (std::size_t v = 0; v < vectors.size(); ++v) positions.push_back(vectors[v]);
  return positions;
}

fccda::StructureSolver solver_of(const StructureOfPython& structure) {
  const std::shared_ptr<py::object> object = kept(structure.object);
  const std::string what = "what advance of the structure of impactor " + structure.impactor + " returned";
  fccda::StructureSolver solver;
  solver.advance = [object, what](const fccda::Step& step) {
    const py::gil_scoped_acquire acquire;
    return positions_in(object->attr("advance")(step.t0, step.dt), what);
  };
  solver.apply = [object](std::span<const Vec3d> impulses) {
    const py::gil_scoped_acquire acquire;
    object->attr("apply")(array_of(impulses));
  };
  if (py::hasattr(structure.object, "energy"))
    solver.energy = [object] {
      const py::gil_scoped_acquire acquire;
      return py::cast<double>(object->attr("energy"));
    };
  return solver;
}

std::vector<double> masses_of(const StructureOfPython& structure) {
  const Numbers masses = Numbers::ensure(structure.object.attr("masses"));
  if (!masses || masses.ndim() != 1) {
    PyErr_Clear();
    throw InputError(fmt::format("the masses of the structure of impactor {} must be an array of one number [kg] for each vertex.", structure.impactor));
  }
  std::vector<double> values;
  for (py::ssize_t v = 0; v < masses.shape(0); ++v) values.push_back(masses.at(v));
  return values;
}

}  // namespace

std::vector<StructureOfPython> structures_of(const py::object& structures) {
  std::vector<StructureOfPython> all;
  if (structures.is_none()) return all;
  for (const auto& [impactor, object] : py::cast<py::dict>(structures))
    all.push_back({py::cast<std::string>(impactor), py::reinterpret_borrow<py::object>(object)});
  return all;
}

void attach(const std::vector<StructureOfPython>& structures, std::span<Impactor> impactors) {
  std::vector<std::string> names;
  for (const Impactor& impactor : impactors) names.push_back(impactor.name());
  for (const StructureOfPython& structure : structures) {
    const auto found = std::find(names.begin(), names.end(), structure.impactor);
    if (found == names.end())
      throw InputError(
          fmt::format("structures refers to impactor {}, which does not exist; {}", structure.impactor, deck::suggestion(structure.impactor, names)));
    expect_member(structure, "masses", "the lumped mass of each vertex [kg]");
    expect_member(structure, "advance", "advance(time, dt), which returns the positions of the vertices at time + dt");
    expect_member(structure, "apply", "apply(impulses), which takes the contact impulses of the step");
    impactors[static_cast<std::size_t>(found - names.begin())].make_external(solver_of(structure), masses_of(structure));
  }
}

}  // namespace perimpact::python
