#include "mesh/shapes/box.hpp"

#include <array>

namespace fccda {
namespace {

using Place = std::array<int, 3>;

/// Numbers of the lattice points (i, j, k), 0 <= i <= parts[0] and so on, that lie on the surface: the complete lowest layer, the four sides
/// of each intermediate layer, the complete highest layer.
class SurfaceLattice {
 public:
  explicit SurfaceLattice(const Place& parts) : parts_(parts), layer_((parts[0] + 1) * (parts[1] + 1)), belt_(2 * (parts[0] + parts[1])) {}

  int vertex(const Place& p) const {
    const auto [i, j, k] = p;
    if (k == 0) return within_layer(i, j);
    const int start = layer_ + (k - 1) * belt_;
    return start + (k == parts_[2] ? within_layer(i, j) : within_belt(i, j));
  }

 private:
  int within_layer(int i, int j) const { return j * (parts_[0] + 1) + i; }
  int within_belt(int i, int j) const {
    if (j == 0) return i;
    if (i == parts_[0]) return parts_[0] + j;
    if (j == parts_[1]) return 2 * parts_[0] + parts_[1] - i;
    return belt_ - j;
  }

  Place parts_;
  int layer_, belt_;
};

}  // namespace

Panels make_box(const BoxShape& shape) {
  expect_sizes({shape.size.x, shape.size.y, shape.size.z}, shape.edge_length, "box");
  const double panel = shape.edge_length > 0 ? shape.edge_length : largest_magnitude(shape.size);
  const Vec3d counts{divisions(shape.size.x, panel), divisions(shape.size.y, panel), divisions(shape.size.z, panel)};
  expect_affordable(4 * (counts.x * counts.y + counts.y * counts.z + counts.z * counts.x), panel, "box");
  const Place parts{static_cast<int>(counts.x), static_cast<int>(counts.y), static_cast<int>(counts.z)};
  const SurfaceLattice lattice(parts);

  Panels out;
  // in the order of the numbers above, except that intermediate layers are traversed around their perimeter
  for (int k = 0; k <= parts[2]; ++k) {
    const auto add = [&](int i, int j) {
      // from the middle, so that mirror images are bitwise identical
      const auto along = [](double size, int part, int count) { return 0.5 * size * (static_cast<double>(2 * part - count) / count); };
      out.vertices.push_back({along(shape.size.x, i, parts[0]), along(shape.size.y, j, parts[1]), along(shape.size.z, k, parts[2])});
    };
    if (k == 0 || k == parts[2]) {
      for (int j = 0; j <= parts[1]; ++j) {
        for (int i = 0; i <= parts[0]; ++i) add(i, j);
      }
    } else {
      for (int i = 0; i < parts[0]; ++i) add(i, 0);
      for (int j = 0; j < parts[1]; ++j) add(parts[0], j);
      for (int i = parts[0]; i > 0; --i) add(i, parts[1]);
      for (int j = parts[1]; j > 0; --j) add(0, j);
    }
  }

  for (std::size_t normal = 0; normal < 3; ++normal) {
    const std::size_t u = (normal + 1) % 3, v = (normal + 2) % 3;
    for (const bool high : {false, true}) {
      Place p{};
      p[normal] = high ? parts[normal] : 0;
      for (p[v] = 0; p[v] < parts[v]; ++p[v]) {
        for (p[u] = 0; p[u] < parts[u]; ++p[u]) {
          Place along_u = p, along_v = p, across = p;
          ++along_u[u], ++along_v[v], ++across[u], ++across[v];
          const int a = lattice.vertex(p), c = lattice.vertex(across);
          const int b = lattice.vertex(high ? along_u : along_v), d = lattice.vertex(high ? along_v : along_u);
          if (shape.panels == PanelKind::quads) {
            out.add_quad(a, b, c, d);
          } else {
            out.add_triangle(a, b, c);
            out.add_triangle(a, c, d);
          }
        }
      }
    }
  }
  return out;
}

}  // namespace fccda
