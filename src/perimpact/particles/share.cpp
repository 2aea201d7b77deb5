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

std::vector<SlotRun> runs_of(const Lattice& lattice, const CellBox& box) {
  std::vector<SlotRun> runs;
  for (int k = box.low[2]; k < box.high[2] && box.size(0) > 0; ++k)
    for (int j = box.low[1]; j < box.high[1]; ++j) runs.push_back({lattice.slot(box.low[0], j, k), static_cast<std::size_t>(box.size(0))});
  return runs;
}

/// Rounds the runs of a row up to whole eights; they begin with one.
std::vector<SlotRun> in_whole_eights(std::vector<SlotRun> runs) {
  for (SlotRun& run : runs) run.count = fccda::in_eights(run.count);
  return runs;
}

/// Of ascending eights.
std::vector<SlotRun> runs_of(std::span<const std::uint32_t> eights) {
  std::vector<SlotRun> runs;
  for (const std::uint32_t eight : eights) {
    const std::size_t first = std::size_t{eight} * fccda::byte_lanes;
    if (runs.empty() || runs.back().first + runs.back().count != first) runs.push_back({first, 0});
    runs.back().count += fccda::byte_lanes;
  }
  return runs;
}

}  // namespace

std::size_t slots_in(std::span<const SlotRun> runs) {
  return std::accumulate(runs.begin(), runs.end(), std::size_t{0}, [](std::size_t sum, const SlotRun& run) { return sum + run.count; });
}

Share::Share() : ranks_(&alone()) {}

Share::Share(Ranks& ranks, const Lattice& whole, const PartitionRule& rule, int first_rank) : ranks_(&alone()) {
  EXPECTS(rule.cells == whole.cells);
  if (ranks.size() == 1) return;
  ranks_ = &ranks;
  const std::vector<CellBox> boxes = boxes_of_ranks(rule, ranks.size(), first_rank);
  LatticePart part{.whole = whole, .lattice = whole, .owned = boxes[static_cast<std::size_t>(ranks.rank())]};
  const CellBox local = with_ghosts(part.owned, rule);
  part.offset = local.low;
  for (std::size_t axis = 0; axis < 3; ++axis) part.lattice.cells[axis] = local.size(axis), part.lattice.first[axis] = whole.first[axis] + local.low[axis];
  const CellBox owned = shifted(part.owned, part.offset);
  part.boxes = boxes;
  part.interior = without_rim(owned, part.lattice.cells, rule);
  std::vector<Peer> peers;
  for (const ExchangedCells& cells : exchanged_cells(boxes, ranks.rank(), rule.reach))
    peers.push_back({cells.rank, runs_of(part.lattice, shifted(cells.send, part.offset)), runs_of(part.lattice, shifted(cells.receive, part.offset))});
  std::vector<SlotRun> runs = in_whole_eights(runs_of(part.lattice, owned));
  plan_ = std::make_shared<const Plan>(Plan{.part = std::move(part), .owned = std::move(runs), .peers = std::move(peers)});
}

Share::Share(Ranks& ranks, CloudPart part) : ranks_(&ranks) {
  EXPECTS(ranks.size() > 1);
  const CloudPartition& partition = part.partition;
  const int own = partition.part_of(ranks.rank());
  const auto first = std::ranges::lower_bound(part.eights, partition.begin(own));
  std::vector<SlotRun> owned;
  if (own < partition.parts())
    owned.push_back(
        {static_cast<std::size_t>(first - part.eights.begin()) * fccda::byte_lanes, (partition.end(own) - partition.begin(own)) * fccda::byte_lanes});
  std::vector<Peer> peers;
  for (const CloudPart::Exchanged& eights : part.exchanged) peers.push_back({eights.rank, runs_of(eights.send), runs_of(eights.receive)});
  plan_ = std::make_shared<const Plan>(Plan{.part = std::move(part), .owned = std::move(owned), .peers = std::move(peers)});
}

const Share::LatticePart& Share::lattice_part() const {
  EXPECTS(is_of_lattice());
  return *std::get_if<LatticePart>(&plan_->part);
}

const CloudPart& Share::cloud_part() const {
  EXPECTS(plan_ && !is_of_lattice());
  return *std::get_if<CloudPart>(&plan_->part);
}

CellBox Share::owned_cells() const { return shifted(lattice_part().owned, lattice_part().offset); }

std::span<const SlotRun> Share::owned() const {
  EXPECTS(plan_);
  return plan_->owned;
}

std::size_t Share::slots_of_whole() const {
  EXPECTS(plan_);
  return is_of_lattice() ? lattice_part().whole.slots() : cloud_part().partition.eights() * fccda::byte_lanes;
}

void Share::complete_refresh() const {
  if (!plan_) return;
  for (const std::function<void()>& complete : std::exchange(plan_->under_way, {})) complete();
}

CellBox Share::part_of(int rank) const {
  EXPECTS(plan_);
  if (is_of_lattice()) return lattice_part().boxes[static_cast<std::size_t>(rank)];
  const CloudPartition& partition = cloud_part().partition;
  const int part = partition.part_of(rank);
  return {{static_cast<int>(partition.begin(part)), 0, 0}, {static_cast<int>(partition.end(part)), 1, 1}};
}

int Share::parts() const {
  EXPECTS(plan_);
  return is_of_lattice() ? count_parts(lattice_part().boxes) : cloud_part().partition.parts();
}

std::size_t Share::count_of_owned(const NumbersOfEights& numbers) const {
  std::size_t count = 0;
  for (const SlotRun& run : owned()) count += numbers.of(run).count;
  return count;
}

std::size_t Share::count_of_whole(const NumbersOfEights& numbers) const {
  if (numbers.begin.empty()) return numbers.first(slots_of_whole() / fccda::byte_lanes);
  return static_cast<std::size_t>(ranks_->sum(static_cast<std::int64_t>(count_of_owned(numbers))));
}

std::size_t Share::first_of_varying(const NumbersOfEights& numbers) const {
  const std::uint64_t own = count_of_owned(numbers);
  const std::vector<std::uint64_t> counts = ranks_->join_all(std::span<const std::uint64_t>(&own, 1));
  const CloudPartition& partition = cloud_part().partition;
  std::size_t before = 0;
  for (int part = 0; part < partition.part_of(ranks_->rank()); ++part) before += counts[static_cast<std::size_t>(partition.rank_of(part))];
  return before;
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

std::vector<Share::Shifted> Share::exchanged_in_shift(const Lattice& lattice, const std::array<int, 3>& by) const {
  const LatticePart* part = plan_ ? &lattice_part() : nullptr;
  const CellBox all{{0, 0, 0}, part ? part->whole.cells : lattice.cells};
  const std::array<int, 3> offset = part ? part->offset : std::array<int, 3>{};
  const std::vector<CellBox> boxes = part ? part->boxes : std::vector<CellBox>{all};
  const CellBox& owned = boxes[static_cast<std::size_t>(ranks_->rank())];
  const std::array<int, 3> back = {-by[0], -by[1], -by[2]};
  EXPECTS(by[0] % static_cast<int>(fccda::byte_lanes) == 0);
  const auto sources_of = [&](const CellBox& box) { return intersection(shifted(box, back), all); };
  std::vector<Shifted> exchanged;
  for (std::size_t other = 0; other < boxes.size(); ++other) {
    const CellBox send = intersection(sources_of(boxes[other]), owned), receive = intersection(sources_of(owned), boxes[other]);
    if (send.cells() + receive.cells() > 0) exchanged.push_back({static_cast<int>(other), shifted(send, offset), shifted(shifted(receive, by), offset)});
  }
  return exchanged;
}

Share Share::at(const std::array<int, 3>& first) const {
  if (!plan_) return *this;
  LatticePart part = lattice_part();
  part.whole.first = first;
  for (std::size_t axis = 0; axis < 3; ++axis) part.lattice.first[axis] = first[axis] + part.offset[axis];
  Share share = *this;
  share.plan_ = std::make_shared<const Plan>(Plan{.part = std::move(part), .owned = plan_->owned, .peers = plan_->peers});
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
  const bool is_owned = !plan_ || (is_of_lattice() ? lattice_part().owned.contains(lattice_part().whole.cell(slot)) : owner_of(slot) == ranks_->rank());
  return is_owned ? local_slot(slot) : std::nullopt;
}

std::optional<std::size_t> Share::local_slot(std::size_t slot) const {
  if (!plan_) return slot;
  if (!is_of_lattice()) {
    const std::span<const std::uint32_t> own = eights();
    const auto place = std::ranges::lower_bound(own, slot / fccda::byte_lanes);
    if (place == own.end() || *place != slot / fccda::byte_lanes) return std::nullopt;
    return static_cast<std::size_t>(place - own.begin()) * fccda::byte_lanes + slot % fccda::byte_lanes;
  }
  const LatticePart& part = lattice_part();
  std::array<int, 3> cell = part.whole.cell(slot);
  for (std::size_t axis = 0; axis < 3; ++axis) cell[axis] -= part.offset[axis];
  if (!part.lattice.contains(cell[0], cell[1], cell[2])) return std::nullopt;
  return part.lattice.slot(cell[0], cell[1], cell[2]);
}

int Share::owner_of(std::size_t slot) const {
  if (!plan_) return ranks_->rank();
  if (!is_of_lattice()) return cloud_part().partition.owner_of(slot / fccda::byte_lanes);
  const LatticePart& part = lattice_part();
  const std::array<int, 3> cell = part.whole.cell(slot);
  return static_cast<int>(std::ranges::find_if(part.boxes, [&](const CellBox& box) { return box.contains(cell); }) - part.boxes.begin());
}

std::size_t Share::ghosts() const {
  std::size_t slots = 0;
  if (plan_)
    for (const Peer& peer : plan_->peers) slots += slots_in(peer.receive);
  return slots;
}

std::size_t Share::sent_slots() const {
  std::size_t slots = 0;
  if (plan_)
    for (const Peer& peer : plan_->peers) slots += slots_in(peer.send);
  return slots;
}

}  // namespace perimpact
