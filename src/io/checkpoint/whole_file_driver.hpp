/// HDF5 writes through an output::WholeFile: what reaches the disk appears under its name only when it is whole, and where the disk is full
/// the sentence is that of every other file.
///
/// HDF5 1.10 cannot be told that a write failed: it keeps the file open, tries again when the program ends, and crashes. So this driver
/// keeps the first error and tells HDF5 that all is well; who closed the file asks for the error.
#pragma once

#include <hdf5.h>

#include <exception>

#include "io/output/file.hpp"

namespace perimpact::checkpoint {

/// What the driver writes to. It must stay where it is until HDF5 has closed the file.
struct DriverTarget {
  output::WholeFile& file;
  std::exception_ptr error = nullptr;  ///< the first

  void rethrow() const {
    if (error) std::rethrow_exception(error);
  }
};

/// Makes a list of H5P_FILE_ACCESS use the driver; the name of the file then means nothing. False where that fails.
bool use_driver(hid_t file_access, DriverTarget& target);

}  // namespace perimpact::checkpoint
