#include "mesh/remesh/bisection.hpp"

#include <algorithm>

namespace fccda {
namespace {

/// Strict order of edges by length. Both triangles of an edge must agree, also among edges of equal length, or the path could be cyclic.
struct EdgeRank {
  double squared_length;
  int low, high;
  auto operator<=>(const EdgeRank&) const = default;
};

}  // namespace

Bisection::Bisection(const Surface& surface, std::span<const std::array<bool, 3>> creases)
    : vertices_(surface.vertices().begin(), surface.vertices().end()), on_crease_(vertices_.size(), false) {
  pieces_.reserve(surface.triangles().size());
  for (std::size_t t = 0; t < surface.triangles().size(); ++t) {
    const Neighbours beyond{surface.neighbour(t, 0), surface.neighbour(t, 1), surface.neighbour(t, 2)};
    const std::array<bool, 3> is_crease = creases[t];
    const std::array<int, 3>& vertex = surface.triangles()[t].vertex;
    for (std::size_t e = 0; e < 3; ++e)
      if (is_crease[e]) on_crease_[static_cast<std::size_t>(vertex[e])] = on_crease_[static_cast<std::size_t>(vertex[(e + 1) % 3])] = true;
    pieces_.push_back(turned({vertex, beyond, static_cast<int>(t), is_crease}));
  }
}

bool Bisection::touches_crease(const Piece& piece) const {
  return std::any_of(piece.vertex.begin(), piece.vertex.end(), [&](int vertex) { return on_crease_[static_cast<std::size_t>(vertex)]; });
}

void Bisection::halve(std::size_t piece) {
  path_.assign(1, piece);
  while (!path_.empty()) {
    const std::size_t last = path_.back();
    const int beyond = pieces_[last].beyond[0];
    if (beyond >= 0 && pieces_[static_cast<std::size_t>(beyond)].beyond[0] != static_cast<int>(last)) {
      path_.push_back(static_cast<std::size_t>(beyond));
    } else {
      halve_with_neighbour(last);
      path_.pop_back();
    }
  }
}

/// The piece rotated so that its longest edge comes first.
Bisection::Piece Bisection::turned(const Piece& piece) const {
  const auto rank = [&](std::size_t e) {
    const auto [low, high] = std::minmax(piece.vertex[e], piece.vertex[(e + 1) % 3]);
    return EdgeRank{squared_norm(vertices_[static_cast<std::size_t>(high)] - vertices_[static_cast<std::size_t>(low)]), low, high};
  };
  std::size_t first = 0;
  for (const std::size_t e : {std::size_t{1}, std::size_t{2}})
    if (rank(e) > rank(first)) first = e;
  Piece out = piece;
  for (std::size_t e = 0; e < 3; ++e) {
    out.vertex[e] = piece.vertex[(first + e) % 3];
    out.beyond[e] = piece.beyond[(first + e) % 3];
    out.is_crease[e] = piece.is_crease[(first + e) % 3];
  }
  return out;
}

/// Bisects edge 0 of the piece, which is also edge 0 of the piece beyond:
///
///            c                       c
///          /   \                   / | \                  |
///        a ----- b      →        a - m - b     with t = (a, b, c), u = (b, a, d)
///          \   /                   \ | /
///            d                       d
void Bisection::halve_with_neighbour(std::size_t piece) {
  const Piece t = pieces_[piece];
  const int middle = static_cast<int>(vertices_.size());
  vertices_.push_back(0.5 * (corner(t, 0) + corner(t, 1)));
  on_crease_.push_back(t.is_crease[0]);

  const int t1 = static_cast<int>(piece), t2 = static_cast<int>(pieces_.size());
  const int u1 = t.beyond[0], u2 = u1 < 0 ? -1 : t2 + 1;
  const bool crease = t.is_crease[0];
  pieces_[piece] = turned({{t.vertex[0], middle, t.vertex[2]}, {u2, t2, t.beyond[2]}, t.given, {crease, false, t.is_crease[2]}});
  pieces_.push_back(turned({{middle, t.vertex[1], t.vertex[2]}, {u1, t.beyond[1], t1}, t.given, {crease, t.is_crease[1], false}}));
  replace_neighbour(t.beyond[1], piece, static_cast<std::size_t>(t2));
  if (u1 < 0) return;
  const Piece u = pieces_[static_cast<std::size_t>(u1)];
  pieces_[static_cast<std::size_t>(u1)] = turned({{u.vertex[0], middle, u.vertex[2]}, {t2, u2, u.beyond[2]}, u.given, {crease, false, u.is_crease[2]}});
  pieces_.push_back(turned({{middle, u.vertex[1], u.vertex[2]}, {t1, u.beyond[1], u1}, u.given, {crease, u.is_crease[1], false}}));
  replace_neighbour(u.beyond[1], static_cast<std::size_t>(u1), static_cast<std::size_t>(u2));
}

void Bisection::replace_neighbour(int piece, std::size_t old_one, std::size_t new_one) {
  if (piece < 0) return;
  Neighbours& beyond = pieces_[static_cast<std::size_t>(piece)].beyond;
  *std::find(beyond.begin(), beyond.end(), static_cast<int>(old_one)) = static_cast<int>(new_one);
}

}  // namespace fccda
