#include "mesh/named_panels.hpp"

#include <array>
#include <cstdint>
#include <cstring>
#include <utility>

namespace fccda {

namespace {

/// FNV-1a (Fowler, Noll and Vo), 64 bits.
class Fingerprint {
 public:
  template <class Number>
  void add(const Number& number) {
    unsigned char bytes[sizeof(Number)];
    std::memcpy(bytes, &number, sizeof(Number));
    for (const unsigned char byte : bytes) hash_ = (hash_ ^ byte) * 0x100000001b3u;
  }
  std::uint64_t value() const { return hash_; }

 private:
  std::uint64_t hash_ = 0xcbf29ce484222325u;
};

std::string name_of(const Panels& panels) {
  Fingerprint print;
  for (const Vec3d& vertex : panels.vertices)
    for (std::size_t axis = 0; axis < 3; ++axis) print.add(vertex[axis]);
  for (const std::array<int, 4>& panel : panels.panels)
    for (const int vertex : panel) print.add(vertex);
  for (const int part : panels.part) print.add(part);
  for (const std::string& part : panels.part_names)
    for (const char letter : part + '\n') print.add(letter);
  std::string name = "panels-in-memory-";
  for (int shift = 60; shift >= 0; shift -= 4) name += "0123456789abcdef"[(print.value() >> shift) & 15u];
  return name;
}

}  // namespace

NamedPanels::NamedPanels(Panels panels) : panels_(std::make_shared<const Panels>(std::move(panels))), name_(name_of(*panels_)) {}

}  // namespace fccda
