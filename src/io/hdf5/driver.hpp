/// HDF5 file driver that writes through a Storage: files are replaced or extended as the program needs it (WholeFile, StagedStorage), and a full
/// disk gives the same message as for every other file.
///
/// HDF5 1.10 does not handle failed writes: it keeps the file open, retries when the program ends, and crashes. The driver therefore keeps the
/// first error and reports success to HDF5; the owner checks the error after closing the file.
#pragma once

#include <hdf5.h>

#include <exception>

#include "io/hdf5/storage.hpp"

namespace perimpact::hdf5 {

/// Target of the driver. Its address must not change until HDF5 has closed the file.
struct DriverTarget {
  Storage& storage;
  std::exception_ptr error = nullptr;  ///< the first error

  void rethrow() const {
    if (error) std::rethrow_exception(error);
  }
};

/// Sets the driver in a H5P_FILE_ACCESS list; the file name is then ignored. False on failure.
bool use_driver(hid_t file_access, DriverTarget& target);

}  // namespace perimpact::hdf5
