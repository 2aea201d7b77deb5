#include "mesh_io/vtk/vtp_arrays.hpp"

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "base/error.hpp"
#include "mesh_io/file/inflate.hpp"
#include "mesh_io/file/whole_number.hpp"
#include "mesh_io/file/words.hpp"

namespace fccda {

void VtpArrays::fail(const VtpArray& array, const std::string& sentence) const {
  throw InputError(file_ + ":" + std::to_string(array.line) + ": " + excerpt(array.name) + " " + sentence);
}

void VtpArrays::fail_at_end(const VtpArray& array) const { fail(array, "is truncated or damaged; export the file again."); }

std::vector<double> VtpArrays::reals(const VtpArray& array, std::size_t count) {
  std::vector<double> out = numbers<double>(array, count);
  if (!std::all_of(out.begin(), out.end(), [](double number) { return std::isfinite(number); }))
    fail(array, "has a number that is not finite; repair the mesh and export it again.");
  return out;
}

std::vector<std::int64_t> VtpArrays::wholes(const VtpArray& array, std::size_t count) {
  if (!is_whole(array.type)) fail(array, "has numbers of type Float32 or Float64, where integers are expected; export the file again.");
  return numbers<std::int64_t>(array, count);
}

template <class Number>
std::vector<Number> VtpArrays::numbers(const VtpArray& array, std::size_t count) {
  if (count == 0) return {};
  if (count > bytes_left_ / sizeof(Number)) {
    fail(array, "needs " + std::to_string(count) + " numbers, more than the file can hold; it is truncated or a count is damaged: export it again.");
  }
  bytes_left_ -= count * sizeof(Number);
  if (array.format == VtpArray::Format::ascii) return numbers_of_text<Number>(array, count);
  return numbers_in<Number>(bytes(array, count * size_of(array.type)), array.type, encoding_.order);
}

template <class Number>
std::vector<Number> VtpArrays::numbers_of_text(const VtpArray& array, std::size_t count) const {
  Words words(array.text, file_, array.line);
  std::vector<Number> out;
  while (!words.at_end()) {
    const std::string_view word = words.next();
    if constexpr (std::is_same_v<Number, double>) {
      out.push_back(words.number(word, excerpt(array.name)));
    } else {
      out.push_back(whole_number(words, word, excerpt(array.name)));
    }
  }
  if (out.size() != count)
    fail(array, "has " + std::to_string(out.size()) + " numbers, but needs " + std::to_string(count) + "; correct the file or export it again.");
  return out;
}

std::size_t VtpArrays::header_number(const VtpArray& array, EncodedBytes& source) const {
  const auto bytes = source.next(size_of(encoding_.header));
  if (!bytes) fail_at_end(array);
  return static_cast<std::size_t>(numbers_in<std::int64_t>(*bytes, encoding_.header, encoding_.order).front());
}

std::string VtpArrays::bytes(const VtpArray& array, std::size_t size) const {
  const bool is_appended = array.format == VtpArray::Format::appended;
  if (is_appended && array.offset > encoding_.appended_text.size()) fail_at_end(array);
  EncodedBytes source(is_appended ? encoding_.appended_text.substr(array.offset) : array.text, is_appended ? encoding_.appended : Encoding::base64);
  if (encoding_.is_packed) return unpacked(array, source, size);
  const std::size_t stored = header_number(array, source);
  if (stored != size) fail(array, "has " + std::to_string(stored) + " bytes, but needs " + std::to_string(size) + "; export the file again.");
  auto out = source.next(size);
  if (!out) fail_at_end(array);
  return std::move(*out);
}

/// Header: number of blocks, block size, size of a shorter last block (else 0), compressed size of each block; then the blocks.
std::string VtpArrays::unpacked(const VtpArray& array, EncodedBytes& source, std::size_t size) const {
  const std::size_t blocks = header_number(array, source), whole = header_number(array, source), partial = header_number(array, source);
  const bool is_sum =
      blocks > 0 && whole > 0 && partial <= whole && (blocks - 1) <= size / whole && (blocks - 1) * whole + (partial > 0 ? partial : whole) == size;
  if (!is_sum) fail(array, "is compressed in blocks whose sizes do not add up to " + std::to_string(size) + " bytes; export the file again.");
  const auto sizes = source.next(blocks * size_of(encoding_.header));
  if (!sizes) fail_at_end(array);
  std::string out;
  const std::vector<std::int64_t> packed_sizes = numbers_in<std::int64_t>(*sizes, encoding_.header, encoding_.order);
  for (std::size_t b = 0; b < blocks; ++b) {
    const auto packed = source.next(static_cast<std::size_t>(packed_sizes[b]));
    if (!packed) fail_at_end(array);
    const std::size_t block_size = b + 1 == blocks && partial > 0 ? partial : whole;
    constexpr std::size_t most_into_a_byte = 1032;
    const auto block = block_size / most_into_a_byte > packed->size() ? std::nullopt : inflated(*packed, block_size);
    if (!block) fail(array, "is damaged: block " + std::to_string(b + 1) + " of " + std::to_string(blocks) + " does not decompress; export the file again.");
    out += *block;
  }
  return out;
}

}  // namespace fccda
