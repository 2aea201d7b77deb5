#include "io/hdf5/driver.hpp"

#include <algorithm>
#include <cstddef>
#include <cstring>

namespace perimpact::hdf5 {

namespace {

/// File object of this driver; HDF5 accesses it through its first member.
struct Open {
  H5FD_t known{};
  DriverTarget* target = nullptr;
  haddr_t end_of_addresses = 0;
  haddr_t end_of_file = 0;
};

Open& opened(H5FD_t* file) { return *reinterpret_cast<Open*>(file); }
const Open& opened(const H5FD_t* file) { return *reinterpret_cast<const Open*>(file); }

/// Performs an operation unless an earlier one failed; errors are kept and not passed to HDF5.
template <class F>
void attempt(DriverTarget& target, const F& f) {
  if (target.error) return;
  try {
    f();
  } catch (...) {
    target.error = std::current_exception();
  }
}

H5FD_t* open(const char*, unsigned, hid_t access, haddr_t) {
  auto* file = new Open;
  file->target = *static_cast<DriverTarget* const*>(H5Pget_driver_info(access));
  file->end_of_file = file->target->storage.size();
  return &file->known;
}

herr_t close(H5FD_t* file) {
  delete &opened(file);
  return 0;
}

/// Metadata is not accumulated: each write is a whole item of it, which StagedStorage relies on.
herr_t query(const H5FD_t*, unsigned long* features) {
  *features = H5FD_FEAT_AGGREGATE_METADATA | H5FD_FEAT_AGGREGATE_SMALLDATA;
  return 0;
}

haddr_t end_of_addresses(const H5FD_t* file, H5FD_mem_t) { return opened(file).end_of_addresses; }

herr_t set_end_of_addresses(H5FD_t* file, H5FD_mem_t, haddr_t end) {
  opened(file).end_of_addresses = end;
  return 0;
}

haddr_t end_of_file(const H5FD_t* file, H5FD_mem_t) { return opened(file).end_of_file; }

herr_t read(H5FD_t* file, H5FD_mem_t, hid_t, haddr_t from, size_t size, void* into) {
  std::memset(into, 0, size);
  DriverTarget& target = *opened(file).target;
  attempt(target, [&] { target.storage.read_at(from, {static_cast<std::byte*>(into), size}); });
  return 0;
}

herr_t write(H5FD_t* file, H5FD_mem_t, hid_t, haddr_t to, size_t size, const void* from) {
  Open& its = opened(file);
  attempt(*its.target, [&] { its.target->storage.write_at(to, {static_cast<const std::byte*>(from), size}); });
  its.end_of_file = std::max(its.end_of_file, to + size);
  return 0;
}

/// Readers compare the file length with the addresses that the file uses.
herr_t truncate(H5FD_t* file, hid_t, hbool_t) {
  Open& its = opened(file);
  attempt(*its.target, [&] { its.target->storage.resize(its.end_of_addresses); });
  its.end_of_file = its.end_of_addresses;
  return 0;
}

hid_t registered() {
  H5FD_class_t driver{};
#if H5_VERSION_GE(1, 13, 0)
  driver.version = H5FD_CLASS_VERSION;
  driver.value = static_cast<H5FD_class_value_t>(700);  // in the range for drivers not registered with the HDF Group
#endif
  driver.name = "perimpact";
  driver.maxaddr = (haddr_t{1} << 63) - 1;  // the maximum of off_t
  driver.fc_degree = H5F_CLOSE_STRONG;
  driver.fapl_size = sizeof(DriverTarget*);
  driver.open = open;
  driver.close = close;
  driver.query = query;
  driver.get_eoa = end_of_addresses;
  driver.set_eoa = set_end_of_addresses;
  driver.get_eof = end_of_file;
  driver.read = read;
  driver.write = write;
  driver.truncate = truncate;
  std::fill(std::begin(driver.fl_map), std::end(driver.fl_map), H5FD_MEM_DEFAULT);
  static H5FD_class_t lasting;
  lasting = driver;
  return H5FDregister(&lasting);
}

}  // namespace

bool use_driver(hid_t file_access, DriverTarget& target) {
  static const hid_t driver = registered();
  DriverTarget* const where = &target;
  return driver >= 0 && H5Pset_driver(file_access, driver, &where) >= 0;
}

}  // namespace perimpact::hdf5
