#include "marine/hull.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/contract.hpp"
#include "mesh/part_naming.hpp"
#include "mesh/shapes/divisions.hpp"
#include "mesh/shapes/refuse.hpp"
#include "mesh/shapes/strip.hpp"

namespace fccda {
namespace {

constexpr double edges_of_radius = 0.35;  // of a stem with a radius: chords leave the arc by 1.5 % of it
constexpr double growth = 0.2;            // of the edges behind the bow, [m] per metre: a ratio of 1.2 from panel to panel

template <class... Words>
[[noreturn]] void refuse(const Words&... words) {
  refuse_shape("hull", words...);
}

enum class Stretch { bow, side, stern };  // of the ship's length

/// A line from the deck to the bottom: all points at the same fraction of a stretch.
struct Column {
  Stretch stretch;  ///< that begins here, going aft
  double share;     ///< fraction of the stretch, 0 to 1 going aft
  double size;      ///< [m] of edges here
};

enum Band : std::size_t { deck_band, side_band, bilge_band, bottom_band, band_count };

/// Starboard vertices of a column: each band starts at the end of the one above.
using ColumnVertices = std::array<std::vector<int>, band_count>;

using Triangles = std::vector<std::array<int, 3>>;

class HullPanels {
 public:
  explicit HullPanels(const HullForm& form)
      : form_(form), shape_(form.shape()), bow_edge_length_(shape_.bow_edge_length > 0 ? shape_.bow_edge_length : shape_.edge_length) {}

  Panels make() {
    lay_columns();
    std::vector<ColumnVertices> vertices;
    for (const Column& column : columns_) vertices.push_back(add_column(column));
    for (std::size_t k = 0; k + 1 < columns_.size(); ++k) {
      for (std::size_t band = 0; band < band_count; ++band) fill(columns_[k].stretch, band, vertices[k][band], vertices[k + 1][band]);
    }
    add_mirrored();
    return std::move(out_);
  }

 private:
  double widest() const { return std::fmax(form_.section(form_.bilge_top()), std::fmax(form_.section(shape_.freeboard), form_.section(0))); }
  double length_of_side() const { return form_.stern(shape_.freeboard) - form_.stem(shape_.freeboard) - form_.bow_length() - form_.stern_length(); }

  /// Edges along the longest waterline over one stretch, by samples of a parameter u from 0 to 1.
  struct Spread {
    std::vector<double> along{0.0};  ///< [m] of the waterline, up to each sample
    std::vector<double> count{0.0};  ///< of edges
    double triangles = 0;            ///< estimate, an upper bound
  };
  static constexpr int samples = 20000;  // of a smooth curve: the counts are accurate to 1e-8

  /// share_at(u): of the stretch; advance(k) [m]: along the ship from a sample to the next; share_of_breadth(share); size(share, along) [m]: of edges.
  template <class ShareAt, class Advance, class Widening, class Size>
  Spread spread(const ShareAt& share_at, const Advance& advance, const Widening& share_of_breadth, const Size& size) const {
    const double height = shape_.freeboard + shape_.draft;
    const double girth = 2 * widest() + height / std::sin(std::fmin(shape_.stem_angle, shape_.stern_angle)) + widest();
    constexpr auto bands = static_cast<double>(band_count);
    Spread found;
    const auto width = [&](int k) { return widest() * share_of_breadth(share_at(double(k) / samples)); };
    for (int k = 0; k < samples; ++k) {
      const double step = std::hypot(advance(k), width(k + 1) - width(k)), along = found.along.back();
      const double edge = size(share_at((k + 0.5) / samples), along + 0.5 * step);
      found.count.push_back(found.count.back() + step / edge);
      found.along.push_back(along + step);
      found.triangles += 4 * (step / edge) * (girth / edge + bands);
    }
    found.triangles += 4 * (girth / size(1.0, found.along.back()) + bands);  // a further column, as counts are rounded up
    return found;
  }

  /// Columns over one stretch, without the last, at equal counts of edges.
  template <class ShareAt, class Size>
  void lay(Stretch stretch, const Spread& over, const ShareAt& share_at, const Size& size) {
    const double edges = divisions(over.count.back(), 1);
    for (int column = 0; column < static_cast<int>(edges); ++column) {
      const double wanted = over.count.back() * column / edges;
      const auto above = std::upper_bound(over.count.begin(), over.count.end(), wanted);
      const auto k = static_cast<std::size_t>(above - over.count.begin() - 1);
      const double within = column == 0 ? 0 : (wanted - *(above - 1)) / (*above - *(above - 1));
      const double share = column == 0 ? 0 : share_at((static_cast<double>(k) + within) / samples);
      columns_.push_back({stretch, share, size(share, over.along[k] + within * (over.along[k + 1] - over.along[k]))});
    }
  }

  void lay_columns() {
    const double bow = form_.bow_length(), side = length_of_side(), stern = form_.stern_length();
    // edges follow the curvature of the stem, whose arc has half of the samples, at equal angles: its tangent at the stem is across the ship
    const double radius = shape_.stem_radius, arc = form_.stem_arc(), angle = arc > 0 ? std::acos(1 - arc / radius) : 0;
    const double on_arc = arc > 0 ? std::fmin(bow_edge_length_, edges_of_radius * radius) : bow_edge_length_;
    const auto in_bow = [&](double u) {
      if (arc == 0) return u;
      return std::fmin(1.0, (u < 0.5 ? radius * (1 - std::cos(2 * u * angle)) : arc + (2 * u - 1) * (bow - arc)) / bow);
    };
    const auto evenly = [](double u) { return u; };
    const auto along_bow = [&](int k) { return arc == 0 ? bow / samples : bow * (in_bow(double(k + 1) / samples) - in_bow(double(k) / samples)); };
    const auto bow_size = [&](double, double along) { return std::fmin(bow_edge_length_, on_arc + growth * std::fmax(0.0, along - radius * angle)); };
    const Spread over_bow = spread(
        in_bow, along_bow, [&](double t) { return form_.bow_share(t); }, bow_size);

    const double last = bow_size(1, over_bow.along.back());
    const auto behind_bow = [&](double distance) { return std::fmin(shape_.edge_length, last + growth * distance); };
    const auto side_size = [&](double f, double) { return behind_bow(f * side); };
    const auto stern_size = [&](double f, double) { return behind_bow(side + f * stern); };
    const Spread over_side = spread(
        evenly, [&](int) { return side / samples; }, [](double) { return 1.0; }, side_size);
    const Spread over_stern = spread(
        evenly, [&](int) { return stern / samples; }, [&](double f) { return form_.stern_share(1 - f); }, stern_size);
    expect_affordable(over_bow.triangles + over_side.triangles + over_stern.triangles, bow_edge_length_, "hull");

    lay(Stretch::bow, over_bow, in_bow, bow_size);
    lay(Stretch::side, over_side, evenly, side_size);
    lay(Stretch::stern, over_stern, evenly, stern_size);
    columns_.push_back({Stretch::stern, 1, stern_size(1, 0)});
  }

  Vec3d place(const Column& column, double z, double section) const {
    switch (column.stretch) {
      case Stretch::bow:
        return {form_.stem(z) + column.share * form_.bow_length(), section * form_.bow_share(column.share), z};
      case Stretch::side: {
        const double shoulder = form_.stem(z) + form_.bow_length(), quarter = form_.stern(z) - form_.stern_length();
        return {shoulder + column.share * (quarter - shoulder), section, z};
      }
      default:
        return {form_.stern(z) - (1 - column.share) * form_.stern_length(), section * form_.stern_share(1 - column.share), z};
    }
  }

  int add_vertex(const Vec3d& v) {
    out_.vertices.push_back(v);
    return static_cast<int>(out_.vertices.size()) - 1;
  }

  /// Continues from the last vertex of `before` along at(share), share from 0 to 1, in equal parts of the share.
  template <class At>
  std::vector<int> go_on(int before, double length, double size, const At& at) {
    std::vector<int> line{before};
    if (length <= std::numeric_limits<double>::epsilon() * shape_.length) return line;
    const int parts = static_cast<int>(divisions(length, size));
    for (int k = 1; k <= parts; ++k) line.push_back(add_vertex(at(double(k) / parts)));
    return line;
  }

  ColumnVertices add_column(const Column& column) {
    const double deck = shape_.freeboard, bilge = form_.bilge_top(), bottom = -shape_.draft, radius = shape_.bilge_radius;
    const auto on_side = [&](double z) { return place(column, z, form_.section(z)); };
    const auto on_bilge = [&](double share) {
      if (share == 1) return on_side(bottom);  // exactly the bottom's value, without rounding
      const double z = bilge - radius * std::sin(0.5 * std::numbers::pi * share);
      return on_side(z);
    };
    const Vec3d rail = on_side(deck), low = on_side(bilge), keel = on_side(bottom);
    double around_bilge = 0;  // [m] as if all of it were as long as its longest piece, so that equal parts are short enough everywhere
    constexpr int chords = 64;
    for (int k = 0; k < chords; ++k) around_bilge = std::fmax(around_bilge, chords * norm(on_bilge(double(k + 1) / chords) - on_bilge(double(k) / chords)));

    ColumnVertices lines;
    const int middle = add_vertex({rail.x, 0, deck});
    lines[deck_band] = go_on(middle, rail.y, column.size, [&](double share) { return Vec3d{rail.x, share * rail.y, deck}; });
    lines[side_band] = go_on(lines[deck_band].back(), norm(rail - low), column.size, [&](double share) { return on_side(deck + share * (bilge - deck)); });
    lines[bilge_band] = go_on(lines[side_band].back(), around_bilge, column.size, on_bilge);
    lines[bottom_band] = go_on(lines[bilge_band].back(), keel.y, column.size, [&](double share) { return Vec3d{keel.x, (1 - share) * keel.y, bottom}; });
    return lines;
  }

  void fill(Stretch stretch, std::size_t band, const std::vector<int>& fore, const std::vector<int>& aft) {
    const auto at = [&](int v) { return out_.vertices[static_cast<std::size_t>(v)]; };
    auto& part = band == side_band ? sides_[static_cast<std::size_t>(stretch)] : bands_[band];
    fill_strip(fore, aft, at, [&](int a, int b, int c) { part.push_back({a, b, c}); });
  }

  /// Names the parts and adds each with its mirror image; vertices on the centreline are shared.
  void add_mirrored() {
    const std::pair<std::string_view, const Triangles*> named[] = {
        {"bow", &sides_[0]},         {"side", &sides_[1]}, {"stern", &sides_[2]}, {"bilge", &bands_[bilge_band]}, {"bottom", &bands_[bottom_band]},
        {"deck", &bands_[deck_band]}};
    std::vector<int> mirrored(out_.vertices.size());
    for (std::size_t v = 0; v < mirrored.size(); ++v) {
      const Vec3d at = out_.vertices[v];
      mirrored[v] = at.y == 0 ? static_cast<int>(v) : add_vertex({at.x, -at.y, at.z});
    }
    PartNaming parts(out_);
    for (const auto& [name, triangles] : named) {
      parts.begin(std::string(name));
      for (const auto& t : *triangles) {
        const auto image = [&](std::size_t c) { return mirrored[static_cast<std::size_t>(t[c])]; };
        out_.add_triangle(t[0], t[1], t[2]);
        out_.add_triangle(image(0), image(2), image(1));
      }
    }
    parts.finish();
  }

  const HullForm& form_;
  const HullShape& shape_;
  double bow_edge_length_;
  Panels out_;
  std::vector<Column> columns_;
  std::array<Triangles, 3> sides_;           // of starboard, by stretch
  std::array<Triangles, band_count> bands_;  // of starboard; that of the side stays empty
};

}  // namespace

HullForm::HullForm(const HullShape& shape)
    : shape_(shape),
      cot_stem_(1 / std::tan(shape.stem_angle)),
      cot_stern_(1 / std::tan(shape.stern_angle)),
      tan_flare_(std::tan(shape.flare)),
      bow_length_(shape.fullness * 0.5 * shape.breadth / std::tan(shape.waterline_angle)),
      stern_length_(shape.breadth / std::tan(shape.stern_waterline_angle)) {
  EXPECTS(shape.length > 0 && shape.breadth > 0 && shape.draft > 0 && shape.freeboard > 0 && shape.edge_length > 0);
  EXPECTS(shape.stem_angle > 0 && shape.waterline_angle > 0 && shape.stern_angle > 0 && shape.stern_waterline_angle > 0);
  EXPECTS(shape.fullness >= 1 && shape.bilge_radius >= 0 && shape.stem_radius >= 0 && shape.bow_edge_length >= 0);
  if (shape.stem_radius > 0 && (shape.stem_radius < 1e-3 * shape.breadth || shape.stem_radius > 0.25 * shape.breadth))
    refuse("stem_radius is ", shape.stem_radius, " m; use 0, a sharp edge, or ", 1e-3 * shape.breadth, " to ", 0.25 * shape.breadth,
           " m, a thousandth to a quarter of the breadth.");
  if (shape.stem_radius > 0) round_stem();
  if (shape.bilge_radius > shape.draft)
    refuse("bilge_radius is ", shape.bilge_radius, " m, but the bilge must lie below the waterline; use at most the draft, ", shape.draft, " m.");
  const double least = 1e-3 * shape.breadth, narrowest_bottom = section(-shape.draft), narrowest_deck = section(shape.freeboard);
  if (narrowest_bottom < least)
    refuse("bilge_radius ", shape.bilge_radius, " m and flare leave a bottom of half-breadth ", narrowest_bottom,
           " m; use a smaller radius or flare, or a greater breadth.");
  if (narrowest_deck < least)
    refuse("the sides meet below the deck, whose half-breadth would be ", narrowest_deck, " m; use a flare nearer to 0, or a lower freeboard.");
  const double bottom_length = stern(-shape.draft) - stem(-shape.draft);
  if (bow_length_ + stern_length_ > bottom_length - 1e-3 * shape.length)
    refuse("the bow is ", bow_length_, " m long (fullness * breadth/2 / tan of waterline_angle", shape.stem_radius > 0 ? ", less what stem_radius takes" : "",
           ") and the stern ", stern_length_, " m, but the bottom between stem and stern only ", bottom_length,
           " m; use larger waterline angles, a larger stem or stern angle, a smaller fullness or a longer ship.");
  if (shape.bow_edge_length > shape.edge_length)
    refuse("bow_edge_length is ", shape.bow_edge_length, " m, but the bow is made finer, not coarser, than edge_length, ", shape.edge_length, " m.");
}

double HullForm::section(double z) const {
  const double radius = shape_.bilge_radius, straight = 0.5 * shape_.breadth + z * tan_flare_, below = bilge_top() - z;
  if (below <= 0) return straight;
  return straight - radius + std::sqrt(std::fmax(0.0, radius * radius - below * below));
}

void HullForm::round_stem() {
  const double half = 0.5 * shape_.breadth, curve_length = bow_length_, p = shape_.fullness;
  const auto breadth = [&](double t) { return half * (1 - std::pow(1 - t, p)); };
  const auto slope = [&](double t) { return half / curve_length * p * std::pow(1 - t, p - 1); };
  // the normal of the curve at t meets the centreline at the distance of the radius from it
  double low = 0, high = 1;
  constexpr int halvings = 60;  // to rounding
  for (int k = 0; k < halvings; ++k) {
    const double t = 0.5 * (low + high);
    (breadth(t) * std::hypot(1, slope(t)) < shape_.stem_radius ? low : high) = t;
  }
  const double tangent = low * curve_length, centre = tangent + breadth(low) * slope(low);
  ahead_ = centre - shape_.stem_radius;
  arc_ = tangent - ahead_;
  bow_length_ = curve_length - ahead_;
}

double HullForm::bow_share(double t) const {
  const double behind_stem = t * bow_length_;
  if (behind_stem < arc_) return std::sqrt(behind_stem * (2 * shape_.stem_radius - behind_stem)) / (0.5 * shape_.breadth);
  const double remaining = ahead_ == 0 ? 1 - t : (1 - t) * bow_length_ / (bow_length_ + ahead_);
  return 1 - std::pow(remaining, shape_.fullness);
}

double HullForm::half_breadth(double x, double z) const {
  const double t = std::clamp((x - stem(z)) / bow_length_, 0.0, 1.0), u = std::clamp((stern(z) - x) / stern_length_, 0.0, 1.0);
  return section(z) * bow_share(t) * stern_share(u);
}

Panels make_hull(const HullShape& shape) {
  const HullForm form(shape);
  return HullPanels(form).make();
}

}  // namespace fccda
