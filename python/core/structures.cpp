#include "structures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "arguments.hpp"
#include "base/error.hpp"
#include "io/deck/did_you_mean.hpp"
#include "kept.hpp"

namespace perimpact::python {

namespace {

using fccda::InputError;

void expect_member(const StructureOfPython& structure, const char* member, const char* meaning) {
  if (!py::hasattr(*structure.object, member))
    throw InputError(fmt::format("the structure of impactor {} has no {}; it needs {}.", structure.impactor, member, meaning));
}

std::vector<Vec3d> positions_in(const py::object& returned, const std::string& what) {
  py::array keep;
  const fccda::ConstVectors vectors = vectors_in(returned, what, keep, each_vertex);
  std::vector<Vec3d> positions;
  for (std::size_t v = 0; v < vectors.size(); ++v) positions.push_back(vectors[v]);
  return positions;
}

fccda::StructureSolver solver_of(const StructureOfPython& structure, UserCalls& calls) {
  const std::string its = "of the structure of impactor " + structure.impactor;
  // calls f(object)
  const auto call = [&calls, object = structure.object, its](const char* member, const auto& f) {
    return calls.call(fmt::format("{} {}", member, its), [&] {
      if (!*object) throw fccda::RunError(fmt::format("{} {} was deleted with its simulation.", member, its));
      return f(*object);
    });
  };
  fccda::StructureSolver solver;
  solver.advance = [call, its](const fccda::Step& step) {
    return call("advance",
                [&](const py::object& object) { return positions_in(object.attr("advance")(step.t0, step.dt), "what advance " + its + " returned"); });
  };
  solver.apply = [call](std::span<const Vec3d> impulses) { call("apply", [&](const py::object& object) { object.attr("apply")(array_of(impulses)); }); };
  if (py::hasattr(*structure.object, "energy"))
    solver.energy = [call] { return call("energy", [](const py::object& object) { return py::cast<double>(object.attr("energy")); }); };
  return solver;
}

std::vector<double> masses_of(const StructureOfPython& structure) {
  const Numbers masses = Numbers::ensure(structure.object->attr("masses"));
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
  for (const auto& [impactor, object] : dict_in(structures, "structures", "{\"impactor\": object}"))
    all.push_back({name_in(impactor, "structures", "impactors"), kept(py::reinterpret_borrow<py::object>(object))});
  return all;
}

void attach(const std::vector<StructureOfPython>& structures, std::span<Impactor> impactors, UserCalls& calls) {
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
    impactors[static_cast<std::size_t>(found - names.begin())].make_external(solver_of(structure, calls), masses_of(structure));
  }
}

}  // namespace perimpact::python
