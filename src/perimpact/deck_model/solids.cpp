#include "perimpact/deck_model/solids.hpp"

#include <algorithm>
#include <cctype>

namespace perimpact {

using namespace fccda;  // the ranges
using enum Presence;

namespace {

constexpr double full_turn = 6.2832;  // [rad] somewhat more, for rounding; 90 without its unit is beyond

}  // namespace

std::span<const Field<BoxSolid>> BoxSolid::fields() {
  static const Field<BoxSolid> all[] = {
      {"size", &BoxSolid::size, "m", positive(), required, "Edge lengths in x, y and z. Of a body that is just this box, whole multiples of the spacing."}};
  return all;
}

std::span<const Field<CylinderSolid>> CylinderSolid::fields() {
  using S = CylinderSolid;
  static const Field<S> all[] = {{"diameter", &S::diameter, "m", positive(), required, "Diameter."},
                                 {"height", &S::height, "m", positive(), required, "Length along the axis, half of it on either side of the position."},
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
       "A closed surface, of which the inside is filled: any file that impactors.<name>.surface can read. A relative path starts at the deck's folder."},
      {"file_parts", &S::file_parts, "", {}, optional, "Names of the parts of the file that are wanted; all where absent. `perimpact mesh` lists them."},
      {"scale", &S::scale, "1", positive(), optional, "Multiplies the coordinates, so that they become metres: 0.001 for a file in millimetres."},
      {"mirror", &S::mirror, "", {}, optional, "Mirrors the surface at the plane x = 0, y = 0 or z = 0."},
      {"mirror_merge", &S::mirror_merge, "", {}, optional, "Adds the mirror image at the plane x = 0, y = 0 or z = 0. Panels in that plane go."},
      {"rotate", &S::rotate, "rad", between(-full_turn, full_turn), optional, "Turns the surface about the axes x, y and z through the origin, in this order."},
      {"translate", &S::translate, "m", any_number(), optional, "Moves the surface. Scale, mirror, complete, rotate and translate act in this order."},
      {"weld", &S::weld, "m", positive(), optional,
       "Vertices nearer than this become one: closes gaps that rounding left between panels. Where absent, 1e-9 of the surface's size."}};
  return all;
}

std::span<const Field<SolidSetup>> SolidSetup::fields() {
  using S = SolidSetup;
  static const Field<S> all[] = {{"position", &S::position, "m", any_number(), optional,
                                  "Where its centre is, or the origin of its file, from the body's position and along the body's axes."},
                                 {"rotate", &S::rotate, "rad", between(-full_turn, full_turn), optional,
                                  "Turns it about the axes x, y and z through its position, in this order: [0, 0, 45 deg]."}};
  return all;
}

std::span<const Field<CrackSetup>> CrackSetup::fields() {
  using S = CrackSetup;
  static const Field<S> all[] = {
      {"polygon", &S::polygon, "m", any_number(), required,
       "Corners of a plane polygon in order around it, from the body's position and along its axes; in a plane body the two ends of a "
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
  static const Field<S> all[] = {{"file",
                                  &S::file,
                                  "",
                                  {},
                                  required,
                                  "A CSV file with a particle a row and a first line that names the columns with units, \"x [m], y [m], z [m], volume [m3]\"; "
                                  "or the points of a VTK file (.vtk, .vtp, .vtu) in metres with a point array volume in m3. The origin of its coordinates is "
                                  "the body's position. A relative path starts at the deck's folder."},
                                 {"thickness", &S::thickness, "m", positive(), optional, "Of a plane body: its thickness, which the volumes are divided by."}};
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
       "A mesh of which each solid cell becomes a particle, in its middle and of its volume; of a plane body, each triangle and quad: VTK, VTU, MSH (Gmsh), "
       "INP "
       "(Abaqus), K, KEY or DYN (LS-DYNA), each also packed as .gz. The origin of its coordinates is the body's position. A relative path starts at the deck's "
       "folder."},
      {"file_parts", &S::file_parts, "", {}, optional, "Names of the parts of the file that are wanted; all where absent. `perimpact mesh` lists them."},
      {"scale", &S::scale, "1", positive(), optional, "Multiplies the coordinates, so that they become metres: 0.001 for a file in millimetres."},
      {"thickness", &S::thickness, "m", positive(), optional, "Of a plane body: its thickness, which areas are multiplied by."}};
  return all;
}

}  // namespace perimpact
