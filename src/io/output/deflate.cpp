#include "io/output/deflate.hpp"

#include <zlib.h>

#include <new>

namespace perimpact::output {

static_assert(deflate_level == Z_BEST_SPEED);

std::vector<std::byte> deflated(std::span<const std::byte> bytes) {
  uLongf size = compressBound(bytes.size());
  std::vector<std::byte> out(size);
  const int outcome = compress2(reinterpret_cast<Bytef*>(out.data()), &size, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size(), deflate_level);
  if (outcome != Z_OK) throw std::bad_alloc();  // the buffer has the size of zlib's bound, so only memory can run out
  out.resize(size);
  out.shrink_to_fit();  // all parts of a frame are kept until they are written
  return out;
}

}  // namespace perimpact::output
