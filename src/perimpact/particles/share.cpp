#include "perimpact/particles/share.hpp"

#include <algorithm>
#include <numeric>

#include "base/contract.hpp"
#include "base/pack.hpp"
#include "perimpact/particles/partition.hpp"

namespace perimpact {

namespace {

CellBox shifted(const CellBox& box, const std::array<int, 3>& by) {
  CellBox other = box;
  for (std::size_t axis = 0; axis < 3; ++axis) other.low[axis] -= by[axis], other.high[axis] -= by[axis];
  return other;
}

}  // namespace

Share::Share() : ranks_(&alone()) {}

Share::Share(Ranks& ranks, const Lattice& whole, int reach, bool keeps_columns, int first_rank) : ranks_(&alone()) {
  if (ranks.size() == 1) return;
  ranks_ = &ranks;
  const PartitionRule rule{whole.cells, reach, keeps_columns};
  const std::vector<CellBox> boxes = boxes_of_ranks(rule, ranks.size(), first_rank);
  Plan plan{.whole = whole, .lattice = whole, .owned = boxes[static_cast<std::size_t>(ranks.rank())]};
  const CellBox local = with_ghosts(plan.owned, rule);
  plan.offset = local.low;
  for (std::size_t axis = 0; axis < 3; ++axis) plan.lattice.cells[axis] = local.size(axis), plan.lattice.first[axis] = whole.first[axis] + local.low[axis];
  for (const ExchangedCells& cells : exchanged_cells(boxes, ranks.rank(), reach))
    plan.peers.push_back({cells.rank, shifted(cells.send, plan.offset), shifted(cells.receive, plan.offset)});
  plan.boxes = boxes;
  plan.interior = without_rim(shifted(plan.owned, plan.offset), plan.lattice.cells, rule);
  plan_ = std::make_shared<const Plan>(std::move(plan));
}

const Lattice& Share::whole() const {
  EXPECTS(plan_);
  return plan_->whole;
}

Lattice Share::lattice() const {
  EXPECTS(plan_);
  return plan_->lattice;
}

CellBox Share::owned() const {
  EXPECTS(plan_);
  return shifted(plan_->owned, plan_->offset);
}

CellBox Share::interior() const {
  EXPECTS(plan_);
  return plan_->interior;
}

void Share::complete_refresh() const {
  if (!plan_) return;
  for (const std::function<void()>& complete : std::exchange(plan_->under_way, {})) complete();
}

int Share::parts() const {
  EXPECTS(plan_);
  return count_parts(plan_->boxes);
}

void Share::collect_flags(std::uint8_t* flags) const {
  if (!plan_) return;
  const std::span<std::uint8_t* const> arrays(&flags, 1);
  auto messages = begin(arrays, &Peer::receive, &Peer::send);
  complete(*plan_, messages, arrays, &Peer::send, [](const std::uint8_t* values, std::size_t count, std::uint8_t* to) {
    for (std::size_t k = 0; k < count; ++k)
      if (values[k] != 0) to[k] = values[k];
  });
}

std::vector<Share::Peer> Share::peers_of_shift(const Lattice& lattice, const std::array<int, 3>& by) const {
  const CellBox all{{0, 0, 0}, plan_ ? plan_->whole.cells : lattice.cells};
  const std::array<int, 3> offset = plan_ ? plan_->offset : std::array<int, 3>{};
  const std::vector<CellBox> boxes = plan_ ? plan_->boxes : std::vector<CellBox>{all};
  const CellBox& owned = boxes[static_cast<std::size_t>(ranks_->rank())];
  const std::array<int, 3> back = {-by[0], -by[1], -by[2]};
  EXPECTS(by[0] % static_cast<int>(fccda::byte_lanes) == 0);
  const auto sources_of = [&](const CellBox& box) { return intersection(shifted(box, back), all); };
  std::vector<Peer> peers;
  for (std::size_t other = 0; other < boxes.size(); ++other) {
    const CellBox send = intersection(sources_of(boxes[other]), owned), receive = intersection(sources_of(owned), boxes[other]);
    if (send.cells() + receive.cells() > 0) peers.push_back({static_cast<int>(other), shifted(send, offset), shifted(shifted(receive, by), offset)});
  }
  return peers;
}

Share Share::at(const std::array<int, 3>& first) const {
  if (!plan_) return *this;
  Plan plan = *plan_;
  plan.whole.first = first;
  for (std::size_t axis = 0; axis < 3; ++axis) plan.lattice.first[axis] = first[axis] + plan.offset[axis];
  Share share = *this;
  share.plan_ = std::make_shared<const Plan>(std::move(plan));
  return share;
}

std::vector<std::uint64_t> Share::whole_slots(std::span<const std::uint32_t> slots) const {
  std::vector<std::uint64_t> of_whole;
  of_whole.reserve(slots.size());
  for (const std::uint32_t slot : slots) of_whole.push_back(whole_slot(slot));
  return of_whole;
}

std::vector<std::size_t> Share::order_of(std::span<const std::uint64_t> numbers) {
  std::vector<std::size_t> order(numbers.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(order, {}, [&](std::size_t at) { return numbers[at]; });
  return order;
}

std::size_t Share::first_of_own(std::size_t count) const {
  const std::uint64_t own = count;
  const std::vector<std::uint64_t> counts = ranks_->join_all(std::span(&own, 1));
  return static_cast<std::size_t>(std::accumulate(counts.begin(), counts.begin() + ranks_->rank(), std::uint64_t{0}));
}

std::optional<std::size_t> Share::owned_slot(std::size_t slot) const {
  if (plan_ && !plan_->owned.contains(plan_->whole.cell(slot))) return std::nullopt;
  return local_slot(slot);
}

std::optional<std::size_t> Share::local_slot(std::size_t slot) const {
  if (!plan_) return slot;
  std::array<int, 3> cell = plan_->whole.cell(slot);
  for (std::size_t axis = 0; axis < 3; ++axis) cell[axis] -= plan_->offset[axis];
  if (!plan_->lattice.contains(cell[0], cell[1], cell[2])) return std::nullopt;
  return plan_->lattice.slot(cell[0], cell[1], cell[2]);
}

int Share::owner_of(std::size_t slot) const {
  if (!plan_) return ranks_->rank();
  const std::array<int, 3> cell = plan_->whole.cell(slot);
  return static_cast<int>(std::ranges::find_if(plan_->boxes, [&](const CellBox& box) { return box.contains(cell); }) - plan_->boxes.begin());
}

std::size_t Share::ghosts() const {
  std::size_t cells = 0;
  if (plan_)
    for (const Peer& peer : plan_->peers) cells += peer.receive.cells();
  return cells;
}

std::size_t Share::sent_cells() const {
  std::size_t cells = 0;
  if (plan_)
    for (const Peer& peer : plan_->peers) cells += peer.send.cells();
  return cells;
}

}  // namespace perimpact
