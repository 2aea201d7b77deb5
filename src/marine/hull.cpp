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
constexpr double growth = 0.2;  // of the edges behind the bow, [m] per metre: a ratio of 1.2 from panel to panel

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
    expect_affordable(estimate(), bow_edge_length_, "hull");
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
  double widest() const { return std::fmax(form_.section(shape_.freeboard), form_.section(0)); }
  double length_of_side() const { return form_.stern(shape_.freeboard) - form_.stem(shape_.freeboard) - form_.bow_length() - form_.stern_length(); }
  /// Edges on the arc of the stem follow its curvature, and grow behind it.
  double size_on_arc() const { return form_.stem_arc() > 0 ? std::fmin(bow_edge_length_, edges_of_radius * shape_.stem_radius) : bow_edge_length_; }
  double size_in_bow(double behind_stem) const {
    return std::fmin(bow_edge_length_, size_on_arc() + growth * std::fmax(0.0, behind_stem - form_.stem_arc()));
  }
  double size_behind_bow(double distance) const { return std::fmin(shape_.edge_length, bow_edge_length_ + growth * distance); }

  /// Estimated number of triangles, an upper bound.
  double estimate() const {
    const double height = shape_.freeboard + shape_.draft;
    const double girth = 2 * widest() + height / std::sin(std::fmin(shape_.stem_angle, shape_.stern_angle)) + widest();
    const double bow = form_.bow_length() + widest(), rest = length_of_side() + form_.stern_length() + widest();
    return 4 * girth *
           (2 * shape_.stem_radius / (size_on_arc() * size_on_arc()) + (1 / size_on_arc() - 1 / bow_edge_length_) / growth +
            bow / (bow_edge_length_ * bow_edge_length_) + (1 / bow_edge_length_ - 1 / shape_.edge_length) / growth +
            rest / (shape_.edge_length * shape_.edge_length));
  }

  /// Columns over one stretch, without the last: at equal counts of edges of the target size along the longest waterline.
  template <class Widening, class Size>
  void lay(Stretch stretch, double length, const Widening& share_of_breadth, const Size& size) {
    constexpr int samples = 20000;  // of a smooth curve: the counts are accurate to 1e-8
    std::vector<double> count(samples + 1, 0.0);
    const auto width = [&](int k) { return widest() * share_of_breadth(double(k) / samples); };
    for (int k = 0; k < samples; ++k) {
      const double step = std::hypot(length / samples, width(k + 1) - width(k));
      count[static_cast<std::size_t>(k + 1)] = count[static_cast<std::size_t>(k)] + step / size((k + 0.5) / samples);
    }
    const double edges = divisions(count.back(), 1);
    for (int column = 0; column < static_cast<int>(edges); ++column) {
      const double wanted = count.back() * column / edges;
      const auto above = std::upper_bound(count.begin(), count.end(), wanted);
      const auto k = static_cast<double>(above - count.begin() - 1);
      const double share = column == 0 ? 0 : (k + (wanted - *(above - 1)) / (*above - *(above - 1))) / samples;
      columns_.push_back({stretch, share, size(share)});
    }
  }

  void lay_columns() {
    const double side = length_of_side(), stern = form_.stern_length();
    lay(
        Stretch::bow, form_.bow_length(), [&](double t) { return form_.bow_share(t); }, [&](double t) { return size_in_bow(t * form_.bow_length()); });
    lay(
        Stretch::side, side, [](double) { return 1.0; }, [&](double f) { return size_behind_bow(f * side); });
    lay(
        Stretch::stern, stern, [&](double f) { return form_.stern_share(1 - f); }, [&](double f) { return size_behind_bow(side + f * stern); });
    columns_.push_back({Stretch::stern, 1, size_behind_bow(side + stern)});
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
  if (shape.stem_radius > 0.25 * shape.breadth)
    refuse("stem_radius is ", shape.stem_radius, " m; use at most a quarter of the breadth, ", 0.25 * shape.breadth, " m.");
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
    refuse("the bow is ", bow_length_, " m long (fullness * breadth/2 / tan of waterline_angle", shape.stem_radius > 0 ? ", less what stem_radius takes" : "", ") and the stern ", stern_length_,
           " m, but the bottom between stem and stern only ", bottom_length,
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
