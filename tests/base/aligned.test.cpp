#include "base/aligned.hpp"

#include <doctest/doctest.h>
#include <unistd.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

using namespace fccda;

namespace {

template <class T>
std::uintptr_t place_of(const AlignedVector<T>& values) {
  return reinterpret_cast<std::uintptr_t>(values.data());
}

/// Flags of the mapping that contains an address, as the kernel prints them ("hg": huge pages are requested).
std::string flags_of(std::uintptr_t address) {
  std::ifstream maps("/proc/self/smaps");
  bool is_inside = false;
  for (std::string line; std::getline(maps, line);) {
    std::uintptr_t begin = 0, end = 0;
    char dash = 0;
    if (std::istringstream range(line); range >> std::hex >> begin >> dash >> end && dash == '-') is_inside = begin <= address && address < end;
    if (is_inside && line.starts_with("VmFlags:")) return line + " ";
  }
  return {};
}

/// [byte] of address space of this process
std::size_t address_space() {
  std::size_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  return pages * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
}

}  // namespace

TEST_CASE("aligned: arrays begin at a cache line, those of a huge page or more at one") {
  for (const std::size_t bytes : {std::size_t{8}, std::size_t{1000}, MappedPages::huge_page - 8}) CHECK(place_of(AlignedVector<double>(bytes / 8)) % 64 == 0);
  for (const std::size_t bytes : {MappedPages::huge_page, MappedPages::huge_page + 8, 5 * MappedPages::huge_page / 2})
    CHECK(place_of(AlignedVector<double>(bytes / 8)) % MappedPages::huge_page == 0);
}

TEST_CASE("aligned: huge pages are requested for all whole pages of a large array") {
  if (!std::filesystem::exists("/sys/kernel/mm/transparent_hugepage")) return;  // a kernel without them
  const AlignedVector<double> large(5 * MappedPages::huge_page / 2 / 8);
  CHECK(flags_of(place_of(large)).find(" hg ") != std::string::npos);
  CHECK(flags_of(place_of(large) + 2 * MappedPages::huge_page - 8).find(" hg ") != std::string::npos);
}

TEST_CASE("aligned: a large array counts towards the address space with its own pages only, and no longer once it is freed") {
  if (address_space() == 0) return;  // another operating system than Linux
  const std::size_t page = static_cast<std::size_t>(sysconf(_SC_PAGESIZE)), before = address_space();
  {
    const AlignedVector<double> large((5 * MappedPages::huge_page / 2 - 8) / 8);
    CHECK(address_space() - before == 5 * MappedPages::huge_page / 2 / page * page);
  }
  CHECK(address_space() == before);
}

TEST_CASE("aligned: an array keeps its values as it grows from small to large") {
  AlignedVector<std::uint32_t> values;
  for (std::uint32_t n = 0; n < 2 * MappedPages::huge_page / 4; ++n) values.push_back(n);
  for (std::uint32_t n = 0; n < values.size(); ++n) REQUIRE(values[n] == n);
}
