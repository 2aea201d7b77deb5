#include "fccda/respond/panel_loads.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/contract.hpp"

namespace fccda {

PanelLoads::PanelLoads(const Surface& surface, std::span<const double> face_areas) : faces_(surface) {
  for (const double area : face_areas)
    kinds_.push_back({area, std::vector<PanelLoad>(faces_.size()), std::vector<bool>(faces_.size()), {}, std::vector<std::vector<Share>>(faces_.size())});
  before_.resize(faces_.size());
  pressure_.assign(faces_.size(), 0);
  peak_pressure_.assign(faces_.size(), 0);
}

std::vector<PanelLoads::Share> PanelLoads::shares_of(std::size_t panel, double face_area) const {
  if (!(faces_[panel].area < face_area)) return {{static_cast<int>(panel), 1}};
  const std::vector<int> patch = faces_.around(panel, std::sqrt(face_area / std::numbers::pi));
  double area = 0;
  for (const int p : patch) area += faces_[static_cast<std::size_t>(p)].area;
  std::vector<Share> shares;
  for (const int p : patch) shares.push_back({p, faces_[static_cast<std::size_t>(p)].area / area});
  return shares;
}

void PanelLoads::add(std::size_t kind, const Contact& contact, const Vec3d& impulse) {
  EXPECTS(kind < kinds_.size());
  if (contact.panel < 0) return;
  const auto panel = static_cast<std::size_t>(contact.panel);
  Kind& of = kinds_[kind];
  if (of.shares[panel].empty()) of.shares[panel] = shares_of(panel, of.face_area);
  if (!of.is_hit[panel]) of.hit.push_back(contact.panel);
  of.is_hit[panel] = true;
  of.pushes[panel] += {impulse, -dot(impulse, contact.normal)};
}

template <class Visit>
void PanelLoads::spread(const Visit& visit) const {
  for (const Kind& kind : kinds_)
    for (const int hit : kind.hit) {
      const PanelLoad& push = kind.pushes[static_cast<std::size_t>(hit)];
      for (const Share& share : kind.shares[static_cast<std::size_t>(hit)]) visit(static_cast<std::size_t>(share.panel), share.share * push);
    }
}

void PanelLoads::end_interval(double duration) {
  for (const int panel : pressed_) pressure_[static_cast<std::size_t>(panel)] = 0;
  pressed_.clear();
  spread([&](std::size_t panel, const PanelLoad& load) {
    before_[panel] += load;
    if (!(duration > 0)) return;
    if (pressure_[panel] == 0) pressed_.push_back(static_cast<int>(panel));
    pressure_[panel] += load.normal_impulse / (faces_[panel].area * duration);
  });
  for (const int pressed : pressed_) {
    const auto panel = static_cast<std::size_t>(pressed);
    peak_pressure_[panel] = std::max(peak_pressure_[panel], pressure_[panel]);
  }
  for (Kind& kind : kinds_) {
    for (const int hit : kind.hit) kind.pushes[static_cast<std::size_t>(hit)] = {}, kind.is_hit[static_cast<std::size_t>(hit)] = false;
    kind.hit.clear();
  }
}

void PanelLoads::rebuild_derived() {
  pressed_.clear();
  for (std::size_t panel = 0; panel < pressure_.size(); ++panel)
    if (pressure_[panel] != 0) pressed_.push_back(static_cast<int>(panel));
  for (Kind& kind : kinds_) {
    kind.is_hit.assign(faces_.size(), false);
    for (const int hit : kind.hit) {
      const auto panel = static_cast<std::size_t>(hit);
      kind.is_hit[panel] = true;
      if (kind.shares[panel].empty()) kind.shares[panel] = shares_of(panel, kind.face_area);
    }
  }
}

std::vector<PanelLoad> PanelLoads::since_start() const {
  std::vector<PanelLoad> loads = before_;
  spread([&](std::size_t panel, const PanelLoad& load) { loads[panel] += load; });
  return loads;
}

}  // namespace fccda
