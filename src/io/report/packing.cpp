#include "io/report/packing.hpp"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/contract.hpp"
#include "base/error.hpp"

namespace perimpact::report {

namespace {

using Residuals = std::vector<std::uint32_t>;

/// Residuals of a prediction, modulo 2^(8 bytes), zigzag-coded so that small residuals of either sign are small numbers.
void leave(std::span<const std::uint32_t> numbers, const std::vector<std::uint32_t>& before, const std::vector<std::uint32_t>& before_that, int prediction,
           int bytes, Residuals& out) {
  const int in_time = prediction % 3;
  const bool along = prediction >= 3;
  const int unused = 32 - 8 * bytes;
  std::uint32_t last = 0;
  out.resize(numbers.size());
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const std::uint32_t predicted = in_time == 0 ? 0 : in_time == 1 ? before[i] : 2 * before[i] - before_that[i];
    const std::uint32_t off = numbers[i] - predicted, left = along ? off - last : off;
    last = off;
    const auto with_sign = static_cast<std::int32_t>(left << unused) >> unused;
    out[i] = (static_cast<std::uint32_t>(with_sign) << 1) ^ static_cast<std::uint32_t>(with_sign >> 31);
  }
}

/// Entropy of all byte planes for an ideal single-byte coder [bit].
double entropy(const Residuals& residuals, int bytes) {
  double bits = 0;
  for (int plane = 0; plane < bytes; ++plane) {
    std::array<std::size_t, 256> counts{};
    for (const std::uint32_t residual : residuals) ++counts[(residual >> (8 * plane)) & 255];
    for (const std::size_t count : counts)
      if (count > 0) bits -= static_cast<double>(count) * std::log2(static_cast<double>(count) / static_cast<double>(residuals.size()));
  }
  return bits;
}

}  // namespace

Scale::Scale(double low, double high, std::uint32_t steps) : low_(low), largest_(steps) {
  if (high > low) step_ = (high - low) / steps;
}

std::uint32_t Scale::number_of(double value) const {
  if (step_ == 0) return 0;
  return static_cast<std::uint32_t>(std::clamp(std::round((value - low_) / step_), 0.0, static_cast<double>(largest_)));
}

void ArrayPacker::append(std::span<const std::uint32_t> numbers, std::string& out) {
  const bool has_one = before_.size() == numbers.size(), has_two = has_one && before_that_.size() == numbers.size();
  Residuals best, residuals;
  int chosen = -1;
  double least = 0;
  for (const int prediction : {0, 1, 2, 3, 4, 5}) {
    if ((prediction % 3 == 1 && !has_one) || (prediction % 3 == 2 && !has_two)) continue;
    leave(numbers, before_, before_that_, prediction, bytes_, residuals);
    const double bits = entropy(residuals, bytes_);
    if (chosen < 0 || bits < least) chosen = prediction, least = bits, best.swap(residuals);
  }
  out.push_back(static_cast<char>(chosen));
  for (int plane = 0; plane < bytes_; ++plane)
    for (const std::uint32_t residual : best) out.push_back(static_cast<char>((residual >> (8 * plane)) & 255));
  before_that_ = std::move(before_);
  before_.assign(numbers.begin(), numbers.end());
}

std::string gzip(std::string_view bytes) {
  z_stream stream{};
  constexpr int with_gzip_header = 16 + MAX_WBITS, memory_level = 9;
  if (deflateInit2(&stream, 6, Z_DEFLATED, with_gzip_header, memory_level, Z_DEFAULT_STRATEGY) != Z_OK)
    throw fccda::RunError("there is not enough memory to compress the report; write it later with `perimpact report`.");
  std::string out(deflateBound(&stream, bytes.size()), '\0');
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
  stream.avail_in = static_cast<uInt>(bytes.size());
  stream.next_out = reinterpret_cast<Bytef*>(out.data());
  stream.avail_out = static_cast<uInt>(out.size());
  [[maybe_unused]] const int state = deflate(&stream, Z_FINISH);
  out.resize(stream.total_out);
  deflateEnd(&stream);
  EXPECTS(state == Z_STREAM_END);
  return out;
}

std::string base64(std::string_view bytes) {
  constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  out.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t at = 0; at < bytes.size(); at += 3) {
    std::uint32_t three = 0;
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - at);
    for (std::size_t k = 0; k < 3; ++k) three = three << 8 | (k < count ? static_cast<unsigned char>(bytes[at + k]) : 0U);
    for (std::size_t k = 0; k < 4; ++k) out.push_back(k <= count ? digits[(three >> (18 - 6 * k)) & 63] : '=');
  }
  return out;
}

}  // namespace perimpact::report
