/// Vectors and small matrices in three dimensions.
#pragma once

#include <cmath>
#include <cstddef>

namespace fccda {

/// A vector of three numbers. T is double, or a pack of doubles in kernels.
template <class T>
struct Vec3 {
  T x{}, y{}, z{};  ///< components, 0 by default

  /// Component 0, 1 or 2.
  constexpr T& operator[](std::size_t axis) { return axis == 0 ? x : axis == 1 ? y : z; }
  /// Component 0, 1 or 2.
  constexpr const T& operator[](std::size_t axis) const { return axis == 0 ? x : axis == 1 ? y : z; }

  /// Adds b.
  constexpr Vec3& operator+=(const Vec3& b) {
    x += b.x, y += b.y, z += b.z;
    return *this;
  }
  /// Subtracts b.
  constexpr Vec3& operator-=(const Vec3& b) {
    x -= b.x, y -= b.y, z -= b.z;
    return *this;
  }
  /// Multiplies by a scalar.
  constexpr Vec3& operator*=(const T& s) {
    x *= s, y *= s, z *= s;
    return *this;
  }

  /// Sum, difference, opposite, products and quotient with a scalar, comparison of components.
  /// @{
  friend constexpr Vec3 operator+(Vec3 a, const Vec3& b) { return a += b; }
  friend constexpr Vec3 operator-(Vec3 a, const Vec3& b) { return a -= b; }
  friend constexpr Vec3 operator-(const Vec3& a) { return {-a.x, -a.y, -a.z}; }
  friend constexpr Vec3 operator*(Vec3 a, const T& s) { return a *= s; }
  friend constexpr Vec3 operator*(const T& s, Vec3 a) { return a *= s; }
  friend constexpr Vec3 operator/(const Vec3& a, const T& s) { return {a.x / s, a.y / s, a.z / s}; }
  friend constexpr bool operator==(const Vec3& a, const Vec3& b) = default;
  /// @}
};

/// Three doubles: a position, a velocity, a force.
using Vec3d = Vec3<double>;

/// Scalar product a·b.
template <class T>
constexpr T dot(const Vec3<T>& a, const Vec3<T>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

/// Vector product a × b.
template <class T>
constexpr Vec3<T> cross(const Vec3<T>& a, const Vec3<T>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// |a|².
template <class T>
constexpr T squared_norm(const Vec3<T>& a) {
  return dot(a, a);
}

/// |a|.
inline double norm(const Vec3d& a) { return std::sqrt(dot(a, a)); }

/// a/|a|; the zero vector is returned unchanged.
inline Vec3d normalised(const Vec3d& a) {
  const double length = norm(a);
  return length > 0 ? a / length : Vec3d{};
}

/// No component is infinite or not a number.
inline bool is_finite(const Vec3d& a) { return std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z); }

/// Maximum norm.
inline double largest_magnitude(const Vec3d& a) { return std::fmax(std::fabs(a.x), std::fmax(std::fabs(a.y), std::fabs(a.z))); }

/// The smaller of each component.
constexpr Vec3d min(const Vec3d& a, const Vec3d& b) { return {a.x < b.x ? a.x : b.x, a.y < b.y ? a.y : b.y, a.z < b.z ? a.z : b.z}; }
/// The larger of each component.
constexpr Vec3d max(const Vec3d& a, const Vec3d& b) { return {a.x > b.x ? a.x : b.x, a.y > b.y ? a.y : b.y, a.z > b.z ? a.z : b.z}; }

/// An axis-aligned box. The empty box has low > high.
struct Box {
  Vec3d low{1e300, 1e300, 1e300};      ///< lower corner
  Vec3d high{-1e300, -1e300, -1e300};  ///< upper corner

  void include(const Vec3d& point) { low = min(low, point), high = max(high, point); }                      ///< extends the box to the point
  bool is_empty() const { return low.x > high.x; }                                                          ///< nothing was included yet
  Vec3d size() const { return high - low; }                                                                 ///< edge lengths
  Vec3d centre() const { return 0.5 * (low + high); }                                                       ///< middle of the two corners
  double distance(const Vec3d& point) const { return norm(max(max(low - point, point - high), Vec3d{})); }  ///< 0 inside
};

/// A 3×3 matrix, stored by rows.
struct Mat3 {
  Vec3d row[3]{};  ///< its rows

  static constexpr Mat3 identity() { return {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}; }  ///< ones on the diagonal
  /// d on the diagonal, zero elsewhere.
  static constexpr Mat3 diagonal(const Vec3d& d) { return {{{d.x, 0, 0}, {0, d.y, 0}, {0, 0, d.z}}}; }
};

/// Product of matrix and column vector.
constexpr Vec3d operator*(const Mat3& m, const Vec3d& v) { return {dot(m.row[0], v), dot(m.row[1], v), dot(m.row[2], v)}; }
/// The transposed matrix.
constexpr Mat3 transpose(const Mat3& m) {
  return {{{m.row[0].x, m.row[1].x, m.row[2].x}, {m.row[0].y, m.row[1].y, m.row[2].y}, {m.row[0].z, m.row[1].z, m.row[2].z}}};
}
/// Matrix product.
constexpr Mat3 operator*(const Mat3& a, const Mat3& b) {
  const Mat3 bt = transpose(b);
  return {{bt * a.row[0], bt * a.row[1], bt * a.row[2]}};
}

}  // namespace fccda
