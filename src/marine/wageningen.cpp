#include "marine/wageningen.hpp"

#include <array>
#include <cmath>
#include <iterator>
#include <span>
#include <vector>

#include "mesh/shapes/monotone_cubic.hpp"

namespace fccda::wageningen {
namespace {

constexpr std::array<double, 9> radii{0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1.0};
using Row = std::array<double, 9>;

constexpr Row chord_row{1.662, 1.882, 2.050, 2.152, 2.187, 2.144, 1.970, 1.582, 0};
constexpr Row leading_row{0.617, 0.613, 0.601, 0.586, 0.561,
                          0.524, 0.463, 0.351, 0.239};  // the last extrapolated linearly: the series ends there with a = c = 0
constexpr Row thickest_row{0.350, 0.350, 0.351, 0.355, 0.389, 0.443, 0.479, 0.500, 0.500};
constexpr Row a_row{0.0526, 0.0464, 0.0402, 0.0340, 0.0278, 0.0216, 0.0154, 0.0092, 0.0030};
constexpr Row b_row{0.0040, 0.0035, 0.0030, 0.0025, 0.0020, 0.0015, 0.0010, 0.0005, 0.0000};
constexpr Row pitch_row{0.822, 0.887, 0.950, 0.992, 1, 1, 1, 1, 1};  // of four blades

struct SectionRow {
  double radius;  ///< r/R
  std::array<double, 20> values;
};

constexpr std::array<double, 20> places{-1, -0.95, -0.9, -0.8, -0.7, -0.6, -0.5, -0.4, -0.2, 0, 0.2, 0.4, 0.5, 0.6, 0.7, 0.8, 0.85, 0.9, 0.95, 1};

constexpr SectionRow face_rows[] = {
    {0.15, {0.3, 0.2824, 0.265, 0.23, 0.195, 0.161, 0.128, 0.0955, 0.0365, 0, 0.0096, 0.0384, 0.0615, 0.092, 0.132, 0.187, 0.223, 0.2642, 0.315, 0.386}},
    {0.2, {0.2826, 0.263, 0.24, 0.1967, 0.157, 0.1207, 0.088, 0.0592, 0.0172, 0, 0.0049, 0.0304, 0.052, 0.0804, 0.118, 0.1685, 0.2, 0.2353, 0.2821, 0.356}},
    {0.25, {0.2598, 0.2372, 0.2115, 0.1651, 0.1246, 0.0899, 0.0579, 0.035,  0.0084, 0,
            0.0031, 0.0224, 0.0417, 0.0669, 0.1008, 0.1465, 0.1747, 0.2068, 0.2513, 0.3256}},
    {0.3,
     {0.2306, 0.204, 0.179, 0.1333, 0.0943, 0.0623, 0.0376, 0.0202, 0.0033, 0, 0.0027, 0.0148, 0.03, 0.0503, 0.079, 0.1191, 0.1445, 0.176, 0.2186, 0.2923}},
    {0.4, {0.1467, 0.12, 0.0972, 0.063, 0.0395, 0.0214, 0.0116, 0.0044, 0, 0, 0, 0.0033, 0.009, 0.0189, 0.0357, 0.0637, 0.0833, 0.1088, 0.1467, 0.2181}},
    {0.5, {0.0522, 0.042, 0.033, 0.019, 0.01, 0.004, 0.0012, 0, 0, 0, 0, 0, 0.0008, 0.0034, 0.0085, 0.0211, 0.0328, 0.05, 0.0778, 0.1278}},
    {0.6, {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0.0006, 0.0022, 0.0067, 0.0169, 0.0382}},
    {0.7, {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}}};

constexpr SectionRow rise_rows[] = {
    {0.15, {0, 0.054, 0.1325, 0.287, 0.428, 0.5585, 0.677, 0.7805, 0.936, 1, 0.976, 0.8825, 0.8055, 0.7105, 0.5995, 0.452, 0.3665, 0.26, 0.13, 0}},
    {0.2, {0, 0.064, 0.1455, 0.306, 0.4535, 0.5842, 0.6995, 0.7984, 0.9446, 1, 0.975, 0.8875, 0.817, 0.7277, 0.619, 0.4777, 0.3905, 0.284, 0.156, 0}},
    {0.25, {0, 0.0725, 0.1567, 0.3228, 0.474, 0.605, 0.7184, 0.8139, 0.9519, 1, 0.9751, 0.8899, 0.8259, 0.7415, 0.6359, 0.4982, 0.4108, 0.3042, 0.1758, 0}},
    {0.3, {0, 0.08, 0.167, 0.336, 0.4885, 0.6195, 0.7335, 0.8265, 0.9583, 1, 0.975, 0.892, 0.8315, 0.752, 0.6505, 0.513, 0.4265, 0.3197, 0.189, 0}},
    {0.4, {0, 0.0905, 0.181, 0.35, 0.504, 0.6353, 0.7525, 0.8415, 0.9645, 1, 0.9725, 0.8933, 0.8345, 0.7593, 0.659, 0.522, 0.4335, 0.3235, 0.1935, 0}},
    {0.5, {0, 0.095, 0.1865, 0.3569, 0.514, 0.6439, 0.758, 0.8456, 0.9639, 1, 0.971, 0.888, 0.8275, 0.7478, 0.643, 0.5039, 0.4135, 0.3056, 0.175, 0}},
    {0.6, {0, 0.0965, 0.1885, 0.3585, 0.511, 0.6415, 0.753, 0.8426, 0.9613, 1, 0.969, 0.879, 0.809, 0.72, 0.606, 0.462, 0.3775, 0.272, 0.1485, 0}},
    {0.7, {0, 0.0975, 0.19, 0.36, 0.51, 0.64, 0.75, 0.84, 0.96, 1, 0.9675, 0.866, 0.785, 0.684, 0.5615, 0.414, 0.33, 0.2337, 0.124, 0}},
    {0.8, {0, 0.0975, 0.19, 0.36, 0.51, 0.64, 0.75, 0.84, 0.96, 1, 0.9635, 0.852, 0.7635, 0.6545, 0.5265, 0.3765, 0.2925, 0.2028, 0.105, 0}},
    {0.85, {0, 0.0975, 0.19, 0.36, 0.51, 0.64, 0.75, 0.84, 0.96, 1, 0.9615, 0.845, 0.755, 0.6455, 0.516, 0.366, 0.283, 0.195, 0.1, 0}},
    {0.9, {0, 0.0975, 0.19, 0.36, 0.51, 0.64, 0.75, 0.84, 0.96, 1, 0.96, 0.84, 0.75, 0.64, 0.51, 0.36, 0.2775, 0.19, 0.0975, 0}}};

MonotoneCubic over_radius(const Row& row) { return {{radii.begin(), radii.end()}, {row.begin(), row.end()}}; }

/// Monotone cubics along the section at the radii of the table, straight lines between them.
class SectionTable {
 public:
  explicit SectionTable(std::span<const SectionRow> rows) {
    for (const SectionRow& row : rows) {
      radii_.push_back(row.radius);
      curves_.push_back({{places.begin(), places.end()}, {row.values.begin(), row.values.end()}});
    }
  }

  double operator()(double r, double place) const {
    if (r <= radii_.front()) return curves_.front()(place);
    if (r >= radii_.back()) return curves_.back()(place);
    std::size_t k = 0;
    while (radii_[k + 1] <= r) ++k;
    const double share = (r - radii_[k]) / (radii_[k + 1] - radii_[k]);
    return (1 - share) * curves_[k](place) + share * curves_[k + 1](place);
  }

 private:
  std::vector<double> radii_;
  std::vector<MonotoneCubic> curves_;
};

}  // namespace

double chord(double r, int blades, double area_ratio) {
  static const MonotoneCubic squared = [] {
    Row row = chord_row;
    for (double& k : row) k *= k;
    return over_radius(row);
  }();
  return std::sqrt(std::fmax(0.0, squared(r))) * area_ratio / blades;
}

double leading_part(double r) {
  static const MonotoneCubic curve = over_radius(leading_row);
  return curve(r);
}

double thickest(double r) {
  static const MonotoneCubic curve = over_radius(thickest_row);
  return curve(r);
}

double thickness(double r, int blades) {
  static const MonotoneCubic a = over_radius(a_row), b = over_radius(b_row);
  return a(r) - blades * b(r);
}

double pitch(double r, int blades) {
  static const MonotoneCubic curve = over_radius(pitch_row);
  return blades == 4 ? curve(r) : 1;
}

double face(double r, double place) {
  static const SectionTable table(face_rows);
  return table(r, place);
}

double rise(double r, double place) {
  static const SectionTable table(rise_rows);
  return table(r, place);
}

}  // namespace fccda::wageningen
