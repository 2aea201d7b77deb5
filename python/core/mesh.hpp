/// A surface mesh from NumPy arrays, which may replace a surface file in a set-up.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "arrays.hpp"
#include "mesh/named_panels.hpp"

namespace perimpact::python {

class Mesh {
 public:
  explicit Mesh(fccda::Panels panels) : panels_(std::move(panels)) {}
  explicit Mesh(fccda::NamedPanels panels) : panels_(std::move(panels)) {}

  /// `vertices`: (n, 3) [m]; `faces`: (m, 3) or (m, 4) vertex numbers from 0, the fourth -1 for triangles among quads; `parts`: part name of each
  /// face. Throws InputError.
  Mesh(Numbers vertices, const py::array_t<long, py::array::c_style | py::array::forcecast>& faces, const std::optional<std::vector<std::string>>& parts);

  const fccda::Panels& panels() const { return panels_.panels(); }
  const fccda::NamedPanels& named_panels() const { return panels_; }  ///< as a set-up refers to them

 private:
  fccda::NamedPanels panels_;
};

void bind_mesh(py::module_& module);

}  // namespace perimpact::python
