/// Conforming longest-edge bisection: triangles are halved in pairs, so that no hanging vertex arises.
///
/// An edge is halved only if it is the longest of both its triangles. If the triangle beyond has a longer one, that is halved first: the
/// path of growing edges ends after finitely many triangles (Rivara, Int. J. Numer. Methods Eng. 40 (1997) 3313). So every triangle results
/// from a given one by longest-edge bisections alone, and its angles are at least half the smallest of the given triangle (Rosenberg and
/// Stenger, SIAM J. Numer. Anal. 12 (1975) 390).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "mesh/surface.hpp"

namespace fccda {

class Bisection {
 public:
  /// Part of a given triangle. Edge e goes from vertex[e] to vertex[(e + 1) % 3]; edge 0 is the longest.
  struct Piece {
    std::array<int, 3> vertex;
    Neighbours beyond;  ///< pieces beyond the edges, -1 at a boundary edge
    int given;          ///< its triangle of the surface
    std::array<bool, 3> is_crease;
  };

  /// `creases`: by triangle, whether each edge is one (curvature.hpp).
  Bisection(const Surface& surface, std::span<const std::array<bool, 3>> creases);

  std::span<const Piece> pieces() const { return pieces_; }
  std::span<const Vec3d> vertices() const { return vertices_; }
  const Vec3d& corner(const Piece& piece, std::size_t c) const { return vertices_[static_cast<std::size_t>(piece.vertex[c])]; }
  double longest_edge(const Piece& piece) const { return norm(corner(piece, 1) - corner(piece, 0)); }  ///< [m]
  bool touches_crease(const Piece& piece) const;

  /// Halves the piece, after those that must be halved first. Its first half keeps its number; new pieces are appended.
  void halve(std::size_t piece);

 private:
  Piece turned(const Piece& piece) const;
  void halve_with_neighbour(std::size_t piece);
  void replace_neighbour(int piece, std::size_t old_one, std::size_t new_one);

  std::vector<Vec3d> vertices_;
  std::vector<bool> on_crease_;  // of each vertex
  std::vector<Piece> pieces_;
  std::vector<std::size_t> path_;  // of growing longest edges
};

}  // namespace fccda
