// Output for ParaView: legacy VTK files, text.
#pragma once

#include <cstdio>
#include <fccda/fccda.hpp>
#include <initializer_list>
#include <span>
#include <string>

struct VtkArray {
  const char* name;
  std::span<const double> values;  // one per point
};

inline std::FILE* open_vtk(const std::string& path, std::span<const fccda::Vec3d> points) {
  std::FILE* file = std::fopen(path.c_str(), "w");
  if (!file) throw fccda::RunError(path + " cannot be written; check the disk space and the write permission.");
  std::fprintf(file, "# vtk DataFile Version 3.0\nfccda\nASCII\nDATASET POLYDATA\nPOINTS %zu double\n", points.size());
  for (const fccda::Vec3d& x : points) std::fprintf(file, "%.9g %.9g %.9g\n", x.x, x.y, x.z);
  return file;
}

inline void write_vtk(const std::string& path, std::span<const fccda::Vec3d> points, std::initializer_list<VtkArray> arrays) {
  std::FILE* file = open_vtk(path, points);
  std::fprintf(file, "VERTICES %zu %zu\n", points.size(), 2 * points.size());
  for (std::size_t i = 0; i < points.size(); ++i) std::fprintf(file, "1 %zu\n", i);
  std::fprintf(file, "POINT_DATA %zu\n", points.size());
  for (const VtkArray& array : arrays) {
    std::fprintf(file, "SCALARS %s double 1\nLOOKUP_TABLE default\n", array.name);
    for (const double value : array.values) std::fprintf(file, "%.6g\n", value);
  }
  std::fclose(file);
}

inline void write_vtk(const std::string& path, const fccda::Panels& panels) {
  std::FILE* file = open_vtk(path, panels.vertices);
  std::size_t corners = 0;
  for (const auto& panel : panels.panels) corners += panel[3] < 0 ? 3 : 4;
  std::fprintf(file, "POLYGONS %zu %zu\n", panels.panels.size(), panels.panels.size() + corners);
  for (const auto& panel : panels.panels) {
    if (panel[3] < 0)
      std::fprintf(file, "3 %d %d %d\n", panel[0], panel[1], panel[2]);
    else
      std::fprintf(file, "4 %d %d %d %d\n", panel[0], panel[1], panel[2], panel[3]);
  }
  std::fclose(file);
}
