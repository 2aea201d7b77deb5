#include "io/results/panel_frames.hpp"

#include "io/output/vtp.hpp"

namespace perimpact {

namespace {

void write(const frames::Sink& sink, const Impactor& impactor, std::vector<output::VtpArray> arrays) {
  const fccda::Panels& panels = impactor.surface().panels();
  sink({.points = output::coordinates(impactor.vertices()), .panels = panels.panels, .cell_arrays = std::move(arrays)});
}

}  // namespace

void write_impactor(const std::filesystem::path& path, const Impactor& impactor) {
  write([&](const output::PolyData& frame) { output::write_vtp(path, frame, output::Compression::zlib); }, impactor, {});
}

void PanelFrames::write(const frames::Sink& sink, const Impactor& impactor, double time) {
  if (!impactor.names_panels()) return perimpact::write(sink, impactor, {});
  const fccda::PanelLoads& loads = impactor.record().panels();
  const std::vector<fccda::PanelLoad> since_start = loads.since_start();
  normal_impulse_.resize(since_start.size(), 0);

  std::vector<float> pressure, peak, impulse;
  for (std::size_t panel = 0; panel < since_start.size(); ++panel) {
    const double area = loads.faces()[panel].area, gained = since_start[panel].normal_impulse - normal_impulse_[panel];
    pressure.push_back(area > 0 && time > time_ ? static_cast<float>(gained / (area * (time - time_))) : 0);
    peak.push_back(static_cast<float>(loads.peak_pressure()[panel]));
    const Vec3d& J = since_start[panel].impulse;
    impulse.insert(impulse.end(), {static_cast<float>(J.x), static_cast<float>(J.y), static_cast<float>(J.z)});
    normal_impulse_[panel] = since_start[panel].normal_impulse;
  }
  time_ = time;
  perimpact::write(sink, impactor,
                   {{"contact_pressure", 1, std::span<const float>(pressure)},
                    {"peak_pressure", 1, std::span<const float>(peak)},
                    {"contact_impulse", 3, std::span<const float>(impulse)}});
}

}  // namespace perimpact
