#include "fccda/c/convert.hpp"

#include <algorithm>
#include <cstdint>
#include <string>
#include <type_traits>

#include "base/error.hpp"
#include "fccda/c/guarded.hpp"

namespace fccda::c_interface {

// The promise of fccda.h: no structure changes its size or the place of a member. These numbers are those of FCCDA_ABI_VERSION 1 with pointers of 64 bits.
static_assert(sizeof(void*) != 8 || (sizeof(fccda_vectors) == 48 && offsetof(fccda_vectors, count) == 24 && offsetof(fccda_vectors, type) == 40));
static_assert(sizeof(void*) != 8 || (sizeof(fccda_numbers) == 40 && offsetof(fccda_numbers, value) == 24 && offsetof(fccda_numbers, type) == 32));
static_assert(sizeof(void*) != 8 || (sizeof(fccda_points) == 224 && offsetof(fccda_points, mass) == 144 && offsetof(fccda_points, radius) == 184));
static_assert(sizeof(void*) != 8 || (sizeof(fccda_surface_options) == 24 && offsetof(fccda_surface_options, orientation) == 16));
static_assert(sizeof(fccda_surface_info) == 136 && offsetof(fccda_surface_info, area) == 48 && offsetof(fccda_surface_info, high) == 112);
static_assert(sizeof(fccda_hull) == 112 && offsetof(fccda_hull, fullness) == 48 && offsetof(fccda_hull, bow_edge_length) == 104);
static_assert(sizeof(fccda_propeller) == 104 && offsetof(fccda_propeller, edge_length) == 72 && offsetof(fccda_propeller, is_left_handed) == 96);
static_assert(sizeof(fccda_box) == 48 && offsetof(fccda_box, centre) == 24);
static_assert(sizeof(fccda_sectors) == 96 && offsetof(fccda_sectors, hub_radius) == 64 && offsetof(fccda_sectors, blades) == 88);
static_assert(sizeof(fccda_pose) == 56 && offsetof(fccda_pose, attitude) == 24);
static_assert(sizeof(fccda_motion) == 144 && offsetof(fccda_motion, t1) == 56 && offsetof(fccda_motion, centre) == 112 && offsetof(fccda_motion, dt) == 136);
static_assert(sizeof(fccda_body_properties) == 256 && offsetof(fccda_body_properties, pose) == 128 && offsetof(fccda_body_properties, is_free) == 232);
static_assert(sizeof(fccda_body_state) == 112 && offsetof(fccda_body_state, attitude) == 72 && offsetof(fccda_body_state, constraint_work) == 104);
static_assert(sizeof(fccda_contact) == 136 && offsetof(fccda_contact, hit) == 24 && offsetof(fccda_contact, depth) == 96 &&
              offsetof(fccda_contact, normal_t0) == 112);
static_assert(sizeof(fccda_contact_sum) == 56 && offsetof(fccda_contact_sum, contacts) == 48);
static_assert(sizeof(fccda_deforming_contact) == 208 && offsetof(fccda_deforming_contact, vertices) == 136 &&
              offsetof(fccda_deforming_contact, displacement) == 184);

namespace {

std::string array_in_words(const char* name) { return std::string("fccda: the array `") + name + '`'; }

/// Checks of one array of numbers, of which there are `count`.
template <class Number>
void expect_array(const void* first, std::size_t count, std::ptrdiff_t stride, const char* name) {
  constexpr auto size = static_cast<std::ptrdiff_t>(sizeof(Number));
  if (count > 0 && first == nullptr)
    throw InputError(array_in_words(name) + " of " + std::to_string(count) + " elements is NULL; pass the address of its first element.");
  if (stride % size != 0 || reinterpret_cast<std::uintptr_t>(first) % alignof(Number) != 0)
    throw InputError(array_in_words(name) + " has a stride of " + std::to_string(stride) + " bytes or an address that does not suit its numbers of " +
                     std::to_string(size) + " bytes; strides count bytes, and are a multiple of that.");
}

[[noreturn]] void refuse_type(std::int32_t type, const char* name, const char* types) {
  throw InputError(array_in_words(name) + " has the type " + std::to_string(type) + ", but it must be " + types + '.');
}

template <class Number>
Vectors typed_vectors(const fccda_vectors& view, const char* name) {
  for (const void* first : {view.x, view.y, view.z}) expect_array<Number>(first, view.count, view.stride, name);
  return Vectors(static_cast<Number*>(view.x), static_cast<Number*>(view.y), static_cast<Number*>(view.z), view.count,
                 view.stride / static_cast<std::ptrdiff_t>(sizeof(Number)));
}

template <class Number>
Numbers typed_numbers(const fccda_numbers& view, const char* name) {
  expect_array<Number>(view.first, view.count, view.stride, name);
  return Numbers(static_cast<const Number*>(view.first), view.count, view.stride / static_cast<std::ptrdiff_t>(sizeof(Number)));
}

}  // namespace

Vectors vectors_of(const fccda_vectors& view, const char* name) {
  expect_reserved(view.reserved, name);
  switch (view.type) {
    case FCCDA_DOUBLE:
      return typed_vectors<double>(view, name);
    case FCCDA_FLOAT:
      return typed_vectors<float>(view, name);
    default:
      refuse_type(view.type, name, "FCCDA_DOUBLE or FCCDA_FLOAT");
  }
}

Numbers numbers_of(const fccda_numbers& view, const char* name) {
  expect_reserved(view.reserved, name);
  switch (view.type) {
    case FCCDA_DOUBLE:
      return typed_numbers<double>(view, name);
    case FCCDA_FLOAT:
      return typed_numbers<float>(view, name);
    case FCCDA_ONE:
      return Numbers(view.value);
    default:
      refuse_type(view.type, name, "FCCDA_DOUBLE, FCCDA_FLOAT or FCCDA_ONE");
  }
}

PointArrays point_arrays_of(const fccda_points& points) {
  return {.x_t0 = const_vectors_of(points.x_t0, "x_t0"),
          .x_t1 = vectors_of(points.x_t1, "x_t1"),
          .velocity = vectors_of(points.velocity, "velocity"),
          .mass = numbers_of(points.mass, "mass")};
}

Pose pose_of(const fccda_pose& pose) {
  const double(&q)[4] = pose.attitude;
  return Pose(vector_of(pose.position), {q[0], q[1], q[2], q[3]});
}

Motion motion_of(const fccda_motion& motion) { return {pose_of(motion.t0), pose_of(motion.t1), motion.dt, vector_of(motion.centre)}; }

fccda_pose as_c(const Pose& pose) {
  const Quaternion& q = pose.attitude();
  fccda_pose out{{}, {q.w, q.x, q.y, q.z}};
  write(pose.position(), out.position);
  return out;
}

fccda_motion as_c(const Motion& motion) {
  fccda_motion out{as_c(motion.t0), as_c(motion.t1), {}, motion.dt};
  write(motion.centre, out.centre);
  return out;
}

fccda_contact as_c(const Contact& contact) {
  fccda_contact out{};
  out.point = static_cast<std::int64_t>(contact.point);
  out.panel = contact.panel;
  out.time_fraction = contact.time_fraction;
  write(contact.hit, out.hit);
  write(contact.normal, out.normal);
  write(contact.relocation, out.relocation);
  out.depth = contact.depth;
  out.radius = contact.radius;
  write(contact.normal_t0, out.normal_t0);
  return out;
}

fccda_deforming_contact as_c(const DeformingContact& contact) {
  fccda_deforming_contact out{};
  out.contact = as_c(contact.contact);
  for (std::size_t k = 0; k < 3; ++k) out.vertices[k] = contact.place.vertices[k], out.weights[k] = contact.place.weights[k];
  write(contact.place.displacement, out.displacement);
  return out;
}

fccda_contact_sum as_c(const ContactSum& sum) {
  fccda_contact_sum out{};
  write(sum.impulse, out.impulse);
  write(sum.angular_impulse, out.angular_impulse);
  out.contacts = static_cast<std::int64_t>(sum.contacts);
  return out;
}

std::size_t index_of(std::int64_t number, const char* name) {
  if (number < 0) throw InputError(std::string("fccda: the number of a ") + name + " is " + std::to_string(number) + ", but they are counted from 0.");
  return static_cast<std::size_t>(number);
}

std::vector<std::int64_t> as_c(std::span<const std::size_t> points) { return {points.begin(), points.end()}; }

std::vector<std::int64_t> as_c(const ContactDetector::State& state) {
  std::vector<std::int64_t> numbers{static_cast<std::int64_t>(state.entered), static_cast<std::int64_t>(state.renumbered),
                                    static_cast<std::int64_t>(state.inside.size())};
  numbers.insert(numbers.end(), state.inside.begin(), state.inside.end());
  numbers.insert(numbers.end(), state.in_contact.begin(), state.in_contact.end());
  return numbers;
}

ContactDetector::State state_of(std::span<const std::int64_t> numbers) {
  constexpr std::size_t head = 3;
  const bool is_state = numbers.size() >= head && std::ranges::all_of(numbers, [](std::int64_t number) { return number >= 0; }) &&
                        static_cast<std::size_t>(numbers[2]) <= numbers.size() - head;
  if (!is_state) throw InputError("fccda: these " + std::to_string(numbers.size()) + " numbers are not the state of a detector; pass all that it returned.");
  const auto lists = numbers.begin() + head, second = lists + numbers[2];
  return {.inside = {lists, second},
          .in_contact = {second, numbers.end()},
          .entered = static_cast<std::uint64_t>(numbers[0]),
          .renumbered = static_cast<std::uint64_t>(numbers[1])};
}

void expect_selection(std::span<const std::int64_t> which, std::size_t count) {
  for (std::size_t k = 0; k < which.size(); ++k) {
    if (index_of(which[k], "contact") >= count)
      throw InputError("fccda: contact " + std::to_string(which[k]) + " is to be kept, but the last detection found " + std::to_string(count) +
                       "; they are numbered from 0.");
    if (k > 0 && which[k] <= which[k - 1]) throw InputError("fccda: the contacts to be kept are not in ascending order; sort them, each once.");
  }
}

}  // namespace fccda::c_interface
