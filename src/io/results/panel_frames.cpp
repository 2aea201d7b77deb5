#include "io/results/panel_frames.hpp"

#include "fccda/elastic/stress.hpp"
#include "io/output/vtp.hpp"

namespace perimpact {

namespace {

using fccda::Vec3d;

/// What a deforming surface has at its vertices.
struct VertexArrays {
  std::vector<Vec3d> displacement;  // [m]
  std::vector<float> stress, von_mises;

  explicit VertexArrays(const Impactor& impactor, std::span<const Vec3d> vertices) {
    const DeformingPart* part = impactor.deforming();
    if (!part) return;
    const std::vector<Vec3d>& undeformed = impactor.surface().panels().vertices;
    for (std::size_t v = 0; v < vertices.size(); ++v) displacement.push_back(vertices[v] - impactor.body().pose().to_world(undeformed[v]));
    const fccda::ElasticBody* body = part->elastic();
    if (!body || !fccda::have_stresses(body->modes())) return;
    for (std::size_t v = 0; v < vertices.size(); ++v) {
      const fccda::SymmetricTensor tensor = body->stress(v);
      for (const double component : tensor) stress.push_back(static_cast<float>(component));
      von_mises.push_back(static_cast<float>(fccda::von_mises(tensor)));
    }
  }

  std::vector<output::VtpArray> arrays() const {
    std::vector<output::VtpArray> all;
    if (!displacement.empty()) all.push_back({"displacement", 3, output::coordinates(displacement)});
    if (!stress.empty()) all.push_back({"stress", 6, std::span<const float>(stress)});
    if (!von_mises.empty()) all.push_back({"von_mises_stress", 1, std::span<const float>(von_mises)});
    return all;
  }
};

void write(const frames::Sink& sink, const Impactor& impactor, std::vector<output::VtpArray> arrays) {
  const std::vector<Vec3d> vertices = impactor.vertices();
  const VertexArrays at_vertices(impactor, vertices);
  sink({.points = output::coordinates(vertices),
        .panels = impactor.surface().panels().panels,
        .point_arrays = at_vertices.arrays(),
        .cell_arrays = std::move(arrays)});
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
