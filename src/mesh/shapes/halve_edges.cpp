#include "mesh/shapes/halve_edges.hpp"

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

#include "base/contract.hpp"

namespace fccda {
namespace {

using Edge = std::pair<int, int>;  // the smaller number first
constexpr int none = -1;

Edge edge_between(int a, int b) { return {std::min(a, b), std::max(a, b)}; }

class Halving {
 public:
  Halving(std::vector<std::array<int, 3>>& triangles, const SheetRules& rules) : triangles_(triangles), rules_(rules) {
    for (std::size_t t = 0; t < triangles_.size(); ++t) enter(static_cast<int>(t));
  }

  void run() {
    // new triangles are appended, so one pass visits them all
    for (std::size_t t = 0; t < triangles_.size(); ++t) {
      while (is_too_large(static_cast<int>(t))) halve(last_of_path(static_cast<int>(t)));
    }
  }

 private:
  static Edge edge_of(const std::array<int, 3>& corners, std::size_t e) { return edge_between(corners[e], corners[(e + 1) % 3]); }

  struct Sides {
    std::array<int, 2> triangle{none, none};
    double length = 0;
  };

  void enter(int t) {
    const auto& corners = triangles_[static_cast<std::size_t>(t)];
    for (std::size_t e = 0; e < 3; ++e) {
      const Edge edge = edge_of(corners, e);
      const auto [entry, is_new] = sides_.try_emplace(edge);
      Sides& sides = entry->second;
      if (is_new) sides.length = rules_.length(edge.first, edge.second);
      EXPECTS(sides.triangle[1] == none);
      sides.triangle[sides.triangle[0] == none ? 0 : 1] = t;
    }
  }

  void leave(int t) {
    const auto& corners = triangles_[static_cast<std::size_t>(t)];
    for (std::size_t e = 0; e < 3; ++e) {
      auto& beside = sides_.at(edge_of(corners, e)).triangle;
      if (beside[0] == t) beside[0] = beside[1];
      beside[1] = none;
    }
  }

  bool is_too_large(int t) const {
    const auto& c = triangles_[static_cast<std::size_t>(t)];
    return rules_.excess(c[0], c[1]) > 1 || rules_.excess(c[1], c[2]) > 1 || rules_.excess(c[2], c[0]) > 1;
  }

  /// Among edges of equal length the one with the larger numbers, so that paths cannot be cyclic.
  Edge longest_edge(int t) const {
    const auto& corners = triangles_[static_cast<std::size_t>(t)];
    Edge longest = edge_of(corners, 0);
    double length = sides_.at(longest).length;
    for (std::size_t e = 1; e < 3; ++e) {
      const Edge edge = edge_of(corners, e);
      const double its = sides_.at(edge).length;
      if (std::tie(its, edge) > std::tie(length, longest)) longest = edge, length = its;
    }
    return longest;
  }

  /// Follows longest edges to one that is the longest of both its triangles.
  Edge last_of_path(int t) const {
    Edge edge = longest_edge(t);
    for (;;) {
      const auto& beside = sides_.at(edge).triangle;
      const int beyond = beside[0] == t ? beside[1] : beside[0];
      if (beyond == none) return edge;
      const Edge next = longest_edge(beyond);
      if (next == edge) return edge;
      edge = next, t = beyond;
    }
  }

  void halve(const Edge& edge) {
    const std::array<int, 2> beside = sides_.at(edge).triangle;
    const int middle = rules_.middle(edge.first, edge.second);
    for (const int t : beside) {
      if (t == none) continue;
      leave(t);
      std::array<int, 3> first = triangles_[static_cast<std::size_t>(t)], second = first;
      std::replace(first.begin(), first.end(), edge.first, middle);
      std::replace(second.begin(), second.end(), edge.second, middle);
      triangles_[static_cast<std::size_t>(t)] = first;
      triangles_.push_back(second);
      enter(t);
      enter(static_cast<int>(triangles_.size()) - 1);
    }
    sides_.erase(edge);
  }

  std::vector<std::array<int, 3>>& triangles_;
  const SheetRules& rules_;
  std::map<Edge, Sides> sides_;
};

}  // namespace

void halve_edges(std::vector<std::array<int, 3>>& triangles, const SheetRules& rules) { Halving(triangles, rules).run(); }

}  // namespace fccda
