#include "perimpact/deck_model/solids.hpp"

#include <algorithm>
#include <cctype>

namespace perimpact {

using namespace fccda;  // the ranges
using enum Presence;

namespace {

constexpr double full_turn = 6.2832;  // [rad] plus a margin for rounding; rejects 90 without its unit

}  // namespace

std::span<const Field<BoxSolid>> BoxSolid::fields() {
  static const Field<BoxSolid> all[] = {
      {"size", &BoxSolid::size, "m", positive(), required, "Edge lengths in x, y and z; whole multiples of the spacing if the body is only this box."}};
  return all;
}

std::span<const Field<CylinderSolid>> CylinderSolid::fields() {
  using S = CylinderSolid;
  static const Field<S> all[] = {{"diameter", &S::diameter, "m", positive(), required, "Diameter."},
                                 {"height", &S::height, "m", positive(), required, "Length along the axis, centred on the position."},
                                 {"axis", &S::axis, "", {}, optional, "Direction of the axis: x, y or z."}};
  return all;
}

std::span<const Field<SphereSolid>> SphereSolid::fields() {
  static const Field<SphereSolid> all[] = {{"diameter", &SphereSolid::diameter, "m", positive(), required, "Diameter."}};
  return all;
}

std::span<const Field<FileSolid>> FileSolid::fields() {
  using S = FileSolid;
  static const Field<S> all[] = {
      {"file",
       &S::file,
       "",
       {},
       required,
       "Closed surface whose interior is filled: any file that impactors.<name>.surface can read. A relative path starts at the deck's folder."},
      {"file_parts", &S::file_parts, "", {}, optional, "Names of the parts of the file to read; all where absent. `perimpact mesh` lists them."},
      {"scale", &S::scale, "1", positive(), optional, "Factor that converts the coordinates to metres: 0.001 for a file in millimetres."},
      {"mirror", &S::mirror, "", {}, optional, "Mirrors the surface in the plane x = 0, y = 0 or z = 0."},
      {"mirror_merge", &S::mirror_merge, "", {}, optional, "Adds the mirror image in the plane x = 0, y = 0 or z = 0. Panels in that plane are removed."},
      {"rotate", &S::rotate, "rad", between(-full_turn, full_turn), optional,
       "Rotates the surface about the axes x, y and z through the origin, in this order."},
      {"translate", &S::translate, "m", any_number(), optional,
       "Translates the surface. Scale, mirror, mirror_merge, rotate and translate apply in this order."},
      {"weld", &S::weld, "m", positive(), optional,
       "Welding tolerance: vertices closer than this are merged, which closes rounding gaps between panels. Where absent, 1e-9 of the surface's size."}};
  return all;
}

std::span<const Field<SolidSetup>> SolidSetup::fields() {
  using S = SolidSetup;
  static const Field<S> all[] = {{"position", &S::position, "m", any_number(), optional,
                                  "Position of its centre, or of the origin of its file, relative to the body's position and in the body's axes."},
                                 {"rotate", &S::rotate, "rad", between(-full_turn, full_turn), optional,
                                  "Rotates it about the axes x, y and z through its position, in this order: [0, 0, 45 deg]."}};
  return all;
}

std::span<const Field<CrackSetup>> CrackSetup::fields() {
  using S = CrackSetup;
  static const Field<S> all[] = {{"polygon", &S::polygon, "m", any_number(), required,
                                  "Corners of a plane polygon in order, relative to the body's position and in its axes; in a plane body the two ends of a "
                                  "line. Bonds that cross or touch it are cut."}};
  return all;
}

bool PointsShape::is_vtk() const {
  std::string words = file;  // as the readers of surfaces, which take .VTU too
  std::transform(words.begin(), words.end(), words.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (words.ends_with(".gz")) words.resize(words.size() - 3);
  return words.ends_with(".vtk") || words.ends_with(".vtp") || words.ends_with(".vtu");
}

std::span<const Field<PointsShape>> PointsShape::fields() {
  using S = PointsShape;
  static const Field<S> all[] = {
      {"file",
       &S::file,
       "",
       {},
       required,
       "A CSV file with one particle per row and a header line with units, \"x [m], y [m], z [m], volume [m3]\"; or the points of a VTK file (.vtk, .vtp, "
       ".vtu) in metres with a point array volume in m3. The origin of its coordinates is the body's position. A relative path starts at the deck's folder."},
      {"thickness", &S::thickness, "m", positive(), optional, "Thickness of a plane body, by which the volumes are divided."}};
  return all;
}

std::span<const Field<CellsShape>> CellsShape::fields() {
  using S = CellsShape;
  static const Field<S> all[] = {
      {"file",
       &S::file,
       "",
       {},
       required,
       "Mesh whose solid cells (of a plane body, triangles and quads) each become a particle at the cell's centroid with the cell's volume: VTK, VTU, MSH "
       "(Gmsh), INP (Abaqus), K, KEY or DYN (LS-DYNA), each also compressed as .gz. The origin of its coordinates is the body's position. A relative path "
       "starts at the deck's folder."},
      {"file_parts", &S::file_parts, "", {}, optional, "Names of the parts of the file to read; all where absent. `perimpact mesh` lists them."},
      {"scale", &S::scale, "1", positive(), optional, "Factor that converts the coordinates to metres: 0.001 for a file in millimetres."},
      {"thickness", &S::thickness, "m", positive(), optional, "Thickness of a plane body, by which cell areas are multiplied."}};
  return all;
}

}  // namespace perimpact
