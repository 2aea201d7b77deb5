#include "io/hdf5/staged.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <random>
#include <vector>

using namespace perimpact::hdf5;

namespace {

using Bytes = std::vector<std::byte>;

class Memory final : public Storage {
 public:
  explicit Memory(std::size_t size) : bytes(size) {}
  void write_at(std::uint64_t offset, std::span<const std::byte> given) override {
    if (offset + given.size() > bytes.size()) bytes.resize(offset + given.size());
    std::ranges::copy(given, bytes.begin() + static_cast<std::ptrdiff_t>(offset));
    written.push_back({offset, given.size()});
  }
  void read_at(std::uint64_t offset, std::span<std::byte> into) const override {
    std::copy_n(bytes.begin() + static_cast<std::ptrdiff_t>(offset), into.size(), into.begin());
  }
  void resize(std::uint64_t size) override { bytes.resize(size); }
  std::uint64_t size() const override { return bytes.size(); }
  void sync() override {}

  struct Write {
    std::uint64_t offset, size;
  };
  Bytes bytes;
  std::vector<Write> written;
};

Bytes random_bytes(std::mt19937& chance, std::size_t count) {
  Bytes bytes(count);
  for (std::byte& byte : bytes) byte = static_cast<std::byte>(chance());
  return bytes;
}

}  // namespace

TEST_CASE("staged storage: what is read is what was written, before and after the commit, for any overlapping writes") {
  std::mt19937 chance(3);
  for (int scene = 0; scene < 50; ++scene) {
    Memory below(9000);
    below.bytes = random_bytes(chance, 9000);
    Bytes plain = below.bytes;
    StagedStorage staged(below);
    for (int k = 0; k < 40; ++k) {
      const std::size_t offset = chance() % 10000;
      const Bytes given = random_bytes(chance, 1 + chance() % 2000);
      staged.write_at(offset, given);
      plain.resize(std::max(plain.size(), offset + given.size()));
      std::ranges::copy(given, plain.begin() + static_cast<std::ptrdiff_t>(offset));
    }
    Bytes read(plain.size());
    staged.read_at(0, read);
    CHECK(read == plain);
    staged.commit();
    CHECK(below.bytes == plain);
  }
}

TEST_CASE("staged storage: before the commit only new bytes are written, then the superblock, the rest, and the first page at once") {
  Memory below(10000);
  StagedStorage staged(below);
  const Bytes some(100, std::byte{1});
  for (const std::uint64_t offset : {3000, 0, 6000, 100, 9950, 4090}) staged.write_at(offset, some);
  REQUIRE(below.written.size() == 1);
  CHECK(below.written[0].offset == 10000);  // the second half of those at 9950
  staged.commit();
  std::vector<std::uint64_t> order;
  for (const Memory::Write& write : below.written) order.push_back(write.offset);
  CHECK(order == std::vector<std::uint64_t>{10000, 0, 4096, 6000, 9950, 0});
  CHECK(below.written.back().size == StagedStorage::page);
}

TEST_CASE("staged storage: discarded changes leave the bytes and the length as they were") {
  Memory below(10000);
  const Bytes before = below.bytes;
  StagedStorage staged(below);
  staged.write_at(9000, Bytes(5000, std::byte{1}));
  CHECK(below.bytes.size() == 14000);
  staged.discard();
  CHECK(below.bytes == before);
}
