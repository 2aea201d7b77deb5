/// The structures of fccda.h and those of the C++ interface, converted into each other.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "fccda/api/contact_detector.hpp"
#include "fccda/api/deforming_contact_detector.hpp"
#include "fccda/api/respond_arrays.hpp"
#include "fccda/fccda.h"

namespace fccda::c_interface {

/// Views of the program's memory. Throw InputError if a pointer is NULL or not aligned, or the stride or type is none. `name`: "x_t1", for the sentence.
/// @{
Vectors vectors_of(const fccda_vectors& view, const char* name);
Numbers numbers_of(const fccda_numbers& view, const char* name);
inline ConstVectors const_vectors_of(const fccda_vectors& view, const char* name) { return vectors_of(view, name); }
/// @}

/// Of points in a response.
PointArrays point_arrays_of(const fccda_points& points);

/// Copies between vectors and three numbers.
/// @{
inline Vec3d vector_of(const double (&xyz)[3]) { return {xyz[0], xyz[1], xyz[2]}; }
inline void write(const Vec3d& vector, double (&xyz)[3]) { xyz[0] = vector.x, xyz[1] = vector.y, xyz[2] = vector.z; }
/// @}

/// Poses and motions, bit for bit in both directions.
/// @{
Pose pose_of(const fccda_pose& pose);
Motion motion_of(const fccda_motion& motion);
fccda_pose as_c(const Pose& pose);
fccda_motion as_c(const Motion& motion);
/// @}

fccda_contact as_c(const Contact& contact);
fccda_deforming_contact as_c(const DeformingContact& contact);
fccda_contact_sum as_c(const ContactSum& sum);

/// Number of a point or panel that C passes as a signed number. Throws InputError if it is negative. `name`: "point".
std::size_t index_of(std::int64_t number, const char* name);

/// Numbers of points as signed ones.
std::vector<std::int64_t> as_c(std::span<const std::size_t> points);

/// State of a detector as one list: entries, whether points were renumbered, the length of the first list of points, that list, and the second list.
/// @{
std::vector<std::int64_t> as_c(const ContactDetector::State& state);
ContactDetector::State state_of(std::span<const std::int64_t> numbers);  ///< throws InputError if the list is none
/// @}

/// Keeps the elements with these numbers, in ascending order. Throws InputError, and changes nothing, if they are not, or there is no such element.
template <class T>
void keep_only(std::vector<T>& contacts, std::span<const std::int64_t> which);
/// Throws InputError if the numbers are not in ascending order and less than `count`.
void expect_selection(std::span<const std::int64_t> which, std::size_t count);

template <class T>
void keep_only(std::vector<T>& contacts, std::span<const std::int64_t> which) {
  expect_selection(which, contacts.size());
  for (std::size_t k = 0; k < which.size(); ++k) contacts[k] = contacts[static_cast<std::size_t>(which[k])];
  contacts.resize(which.size());
}

}  // namespace fccda::c_interface
