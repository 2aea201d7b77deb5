/// Power spectral density of a record (Welch's method).
#pragma once

#include <complex>
#include <cstddef>
#include <span>
#include <vector>

namespace perimpact {

/// X_k = Σ x_n exp(-2πi kn/N), in place; N is a power of two (Cooley and Tukey, Math. Comput. 19 (1965) 297).
void fourier_transform(std::span<std::complex<double>> x);

/// One-sided power spectral density P(f) [unit²/Hz]: the integral of P over a frequency band is the contribution of that band to the mean square, and
/// the integral over all frequencies is the variance.
struct Spectrum {
  double interval;              ///< [s] sampling interval of the record
  std::size_t segment;          ///< values per segment, a power of two
  std::size_t segments;         ///< number of averaged segments
  std::vector<double> density;  ///< at k/(segment · interval) [Hz], k = 0 … segment/2

  double resolution() const { return 1 / (interval * static_cast<double>(segment)); }  ///< [Hz]
  double frequency(std::size_t k) const { return static_cast<double>(k) * resolution(); }
  std::size_t highest() const;  ///< index k > 0 of the largest density; 0 where all are 0
};

/// Welch's method (IEEE Trans. Audio Electroacoust. 15 (1967) 70): Hann windows w that overlap by one half, the mean of each segment removed,
///
///   P_k = c_k Δt |Σ w_n (x_n - x̄) exp(-2πi kn/N)|² / Σ w_n²,    c_0 = c_{N/2} = 1, otherwise 2
///
/// averaged over the segments. A remainder shorter than half a segment is not used. `segment`: a power of two, at most the number of values.
Spectrum welch(std::span<const double> values, double interval, std::size_t segment);

/// The default segment length: the largest power of two of which seven overlapping segments fit, but at least 32 values where available. More
/// segments give a smoother density, longer ones a finer frequency resolution.
std::size_t default_segment(std::size_t values);

}  // namespace perimpact
