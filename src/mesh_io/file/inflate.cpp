#include "mesh_io/file/inflate.hpp"

#include <zlib.h>

#include <algorithm>
#include <new>

#include "base/error.hpp"

namespace fccda {
namespace {

/// A zlib stream. zlib counts bytes in unsigned int, so input and output are passed in chunks.
class Inflater {
 public:
  explicit Inflater(std::string_view packed, int window_bits) : packed_(packed) {
    if (inflateInit2(&stream_, window_bits) != Z_OK) throw std::bad_alloc();
  }
  Inflater(const Inflater&) = delete;
  Inflater& operator=(const Inflater&) = delete;
  ~Inflater() { inflateEnd(&stream_); }

  /// Fills `room`, or part of it where the stream ends, is truncated or damaged. Returns the number of bytes written.
  std::size_t fill(char* room, std::size_t size) {
    std::size_t written = 0;
    while (written < size && outcome_ == Z_OK) {
      const std::size_t given = std::min(packed_.size(), piece), wanted = std::min(size - written, piece);
      // zlib takes a non-const pointer to its input, but does not write to it
      stream_.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed_.data()));
      stream_.avail_in = static_cast<uInt>(given);
      stream_.next_out = reinterpret_cast<Bytef*>(room + written);
      stream_.avail_out = static_cast<uInt>(wanted);
      outcome_ = inflate(&stream_, Z_NO_FLUSH);
      packed_.remove_prefix(given - stream_.avail_in);
      written += wanted - stream_.avail_out;
      if (outcome_ == Z_OK && packed_.empty() && stream_.avail_out > 0) outcome_ = Z_BUF_ERROR;
    }
    return written;
  }

  bool is_at_end() const { return outcome_ == Z_STREAM_END; }
  bool is_cut_short() const { return outcome_ == Z_BUF_ERROR; }
  bool is_good() const { return outcome_ == Z_OK; }

  /// Continues with the next stream after the end of one.
  void begin_next() {
    inflateReset(&stream_);
    outcome_ = Z_OK;
  }
  std::string_view rest() const { return packed_; }

 private:
  static constexpr std::size_t piece = std::size_t{1} << 30;
  std::string_view packed_;
  z_stream stream_{};
  int outcome_ = Z_OK;
};

constexpr std::string_view gzip_mark = "\x1f\x8b";

}  // namespace

std::string gunzip(std::string_view packed, const std::string& file) {
  if (!packed.starts_with(gzip_mark)) throw InputError(file + ": this is not a gzip file, although its name ends in .gz; rename it or compress it again.");
  const std::size_t most = std::max<std::size_t>(std::size_t{64} << 20, 256 * packed.size());
  constexpr int gzip_window = 15 + 16;
  Inflater inflater(packed, gzip_window);
  std::string out;
  std::size_t used = 0;
  for (;;) {
    if (used == out.size()) out.resize(std::min(most + 1, std::max(2 * out.size(), 4 * packed.size() + 256)));
    used += inflater.fill(out.data() + used, out.size() - used);
    if (used > most) {
      throw InputError(file + ": the file decompresses to more than " + std::to_string(most >> 20) +
                       " MiB, the limit for a mesh file of its size; decompress it and inspect the contents.");
    }
    if (inflater.is_at_end()) {
      if (!inflater.rest().starts_with(gzip_mark)) break;  // zeros may follow, from tapes
      inflater.begin_next();
    } else if (inflater.is_cut_short()) {
      throw InputError(file + ": the gzip file is truncated; copy it again.");
    } else if (!inflater.is_good()) {
      throw InputError(file + ": the gzip file is damaged after " + std::to_string(used) + " bytes of decompressed data; copy it again.");
    }
  }
  out.resize(used);
  if (out.empty()) throw InputError(file + ": the gzip file has no contents; export it again.");
  return out;
}

std::optional<std::string> inflated(std::string_view packed, std::size_t size) {
  std::string out(size + 1, '\0');  // one byte more, to detect excess data
  Inflater inflater(packed, 15);
  if (inflater.fill(out.data(), out.size()) != size || !inflater.is_at_end()) return std::nullopt;
  out.resize(size);
  return out;
}

}  // namespace fccda
