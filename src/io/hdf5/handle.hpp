/// RAII wrappers of the HDF5 C interface, with HDF5's error output disabled. For sources, not for headers that others include.
#pragma once

#include <hdf5.h>

#include <utility>

#include "io/hdf5/number_type.hpp"

namespace perimpact::hdf5 {

/// Owning HDF5 identifier of a file, data set, …; closed on destruction.
class Handle {
 public:
  Handle() = default;
  Handle(hid_t id, herr_t (*how_to_close)(hid_t)) : id_(id), close_(how_to_close) {}
  Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, -1)), close_(other.close_) {}
  Handle& operator=(Handle&& other) noexcept {
    std::swap(id_, other.id_), std::swap(close_, other.close_);
    return *this;
  }
  ~Handle() { close(); }

  bool is_open() const { return id_ >= 0; }
  hid_t id() const { return id_; }
  bool close() { return !is_open() || close_(std::exchange(id_, -1)) >= 0; }  ///< false on failure

 private:
  hid_t id_ = -1;
  herr_t (*close_)(hid_t) = nullptr;
};

/// Disables the error output of HDF5 while in scope.
class Quiet {
 public:
  Quiet() {
    [[maybe_unused]] static const herr_t first = H5dont_atexit();  // handles are closed explicitly; HDF5's exit handler would report damaged files
    H5Eget_auto2(H5E_DEFAULT, &print_, &to_);
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  }
  ~Quiet() { H5Eset_auto2(H5E_DEFAULT, print_, to_); }
  Quiet(const Quiet&) = delete;
  Quiet& operator=(const Quiet&) = delete;

 private:
  H5E_auto2_t print_ = nullptr;
  void* to_ = nullptr;
};

inline hid_t type_in_memory(NumberType type) {
  switch (type) {
    case NumberType::uint8:
      return H5T_NATIVE_UINT8;
    case NumberType::int32:
      return H5T_NATIVE_INT32;
    case NumberType::uint32:
      return H5T_NATIVE_UINT32;
    case NumberType::int64:
      return H5T_NATIVE_INT64;
    case NumberType::uint64:
      return H5T_NATIVE_UINT64;
    case NumberType::float32:
      return H5T_NATIVE_FLOAT;
    case NumberType::float64:
      break;
  }
  return H5T_NATIVE_DOUBLE;
}

/// File access properties for a format version with metadata checksums, so that damage is detected.
inline Handle file_access(H5F_libver_t version = H5F_LIBVER_V18) {
  Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  H5Pset_libver_bounds(access.id(), version, version);
  H5Pset_file_locking(access.id(), false, true);  // some network file systems do not support locks, and readers never see a change half done
  return access;
}

}  // namespace perimpact::hdf5
