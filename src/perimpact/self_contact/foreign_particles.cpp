#include "perimpact/self_contact/foreign_particles.hpp"

#include <algorithm>
#include <limits>

namespace perimpact {

namespace {

struct Box {
  Vec3d low, high;

  Box grown(double by) const { return {low - Vec3d{by, by, by}, high + Vec3d{by, by, by}}; }
  bool overlaps(const Box& other) const {
    for (std::size_t c = 0; c < 3; ++c)
      if (!(low[c] <= other.high[c] && other.low[c] <= high[c])) return false;
    return true;
  }
  bool contains(const Vec3d& place) const { return overlaps({place, place}); }
};

/// Consecutive particles, which are near one another in a body whose fragments have not dispersed; few blocks, since all ranks receive their boxes.
constexpr std::size_t most_blocks = 64, least_in_block = 256;

std::size_t block_of(std::size_t count) { return std::max(least_in_block, (count + most_blocks - 1) / most_blocks); }

std::vector<Box> boxes_of(const VectorArray& positions) {
  constexpr double far = std::numeric_limits<double>::infinity();
  const std::size_t block = block_of(positions.slots());
  std::vector<Box> boxes;
  for (std::size_t first = 0; first < positions.slots(); first += block) {
    Box& box = boxes.emplace_back(Box{{far, far, far}, {-far, -far, -far}});
    for (std::size_t c = 0; c < 3; ++c)
      for (std::size_t p = first; p < std::min(first + block, positions.slots()); ++p)
        box.low[c] = std::min(box.low[c], positions.component(c)[p]), box.high[c] = std::max(box.high[c], positions.component(c)[p]);
  }
  return boxes;
}

}  // namespace

void ForeignParticles::find(Ranks& ranks, const VectorArray& positions, double reach, const std::function<Particle(std::size_t own)>& describe) {
  all_.clear(), sent_.clear(), received_.clear();
  const std::size_t count = positions.slots(), block = block_of(count);
  const std::vector<Box> own = boxes_of(positions);
  const std::vector<Ranks::Bytes> boxes_of_all = ranks.gather_all(std::as_bytes(std::span(own)));
  ListsByRank<Particle> described;
  for (int rank = 0; rank < ranks.size(); ++rank) {
    if (rank == ranks.rank()) continue;
    const Ranks::Bytes& bytes = boxes_of_all[static_cast<std::size_t>(rank)];
    std::vector<Box> its(bytes.size() / sizeof(Box));
    if (!its.empty()) std::memcpy(its.data(), bytes.data(), bytes.size());
    std::vector<std::uint32_t> sent;
    for (std::size_t b = 0; b < own.size(); ++b) {
      std::vector<Box> near;
      for (const Box& box : its)
        if (box.grown(reach).overlaps(own[b])) near.push_back(box.grown(reach));
      if (near.empty()) continue;
      for (std::size_t p = b * block; p < std::min((b + 1) * block, count); ++p)
        if (std::ranges::any_of(near, [&](const Box& box) { return box.contains(positions.at(p)); })) sent.push_back(static_cast<std::uint32_t>(p));
    }
    if (sent.empty()) continue;
    for (const std::uint32_t p : sent) described[rank].push_back(describe(p));
    sent_[rank] = std::move(sent);
  }
  const ListsByRank<Particle> lists = exchange_lists(ranks, described);
  for (const auto& [from, list] : lists) all_.insert(all_.end(), list.begin(), list.end());
  std::ranges::sort(all_, {}, &Particle::id);
  for (const auto& [from, list] : lists)
    for (const Particle& particle : list)
      received_[from].push_back(static_cast<std::uint32_t>(std::ranges::lower_bound(all_, particle.id, {}, &Particle::id) - all_.begin()));
}

void ForeignParticles::keep(Ranks& ranks, std::span<const std::uint8_t> used) {
  ListsByRank<std::uint32_t> wanted;  // places in the list of the owner
  for (auto& [from, foreign] : received_) {
    std::vector<std::uint32_t> kept;
    for (std::size_t k = 0; k < foreign.size(); ++k) {
      if (!used[foreign[k]]) continue;
      kept.push_back(foreign[k]);
      wanted[from].push_back(static_cast<std::uint32_t>(k));
    }
    foreign = std::move(kept);
  }
  std::erase_if(received_, [](const auto& of_rank) { return of_rank.second.empty(); });
  const ListsByRank<std::uint32_t> requests = exchange_lists(ranks, wanted);
  Indices sent;
  for (const auto& [to, places] : requests)
    for (const std::uint32_t place : places) sent[to].push_back(sent_.at(to)[place]);
  sent_ = std::move(sent);
}

}  // namespace perimpact
