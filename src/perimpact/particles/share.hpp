/// The part of a body that a rank owns, and the ghosts around it: particles of other ranks within reach of the stencil.
///
/// A rank has a lattice of its own, a window onto that of the whole body (Lattice::first): its box of cells (partition.hpp), and around it `reach` cells,
/// in x whole eights; or eights of points of a cloud (cloud_part.hpp). Only owned particles are summed and advanced. What is read of ghosts is refreshed from
/// their owners after it has changed there: what both ends of a bond compute is bitwise identical, so that nothing else of a bond is sent.
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <functional>
#include <initializer_list>
#include <memory>
#include <optional>
#include <span>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "base/pack.hpp"
#include "perimpact/particles/cell_box.hpp"
#include "perimpact/particles/cloud_part.hpp"
#include "perimpact/particles/lattice.hpp"
#include "perimpact/particles/partition.hpp"
#include "perimpact/ranks/ranks.hpp"

namespace perimpact {

/// Consecutive slots.
struct SlotRun {
  std::size_t first, count;
};
std::size_t slots_in(std::span<const SlotRun> runs);

/// How many numbers eights of slots have: the same number each, or as many as they have rows of bonds in a list.
struct NumbersOfEights {
  std::size_t each = 0;
  std::span<const std::size_t> begin;  ///< first of each eight, and one past the last; empty unless they vary

  std::size_t first(std::size_t eight) const { return begin.empty() ? eight * each : begin[eight]; }
  /// The numbers of a run of whole eights.
  SlotRun of(const SlotRun& run) const {
    const std::size_t eight = run.first / fccda::byte_lanes, begin_of_run = first(eight);
    return {begin_of_run, first(eight + run.count / fccda::byte_lanes) - begin_of_run};
  }
};

class Share {
 public:
  /// The whole body, in a run of one rank.
  Share();
  /// The share of this rank in a body on that lattice, of whose cells the rule is. A small body is divided among fewer ranks than there are, from `first_rank`
  /// on; the others own nothing of it.
  Share(Ranks& ranks, const Lattice& whole, const PartitionRule& rule, int first_rank = 0);
  /// That part of a cloud, which is of this rank.
  Share(Ranks& ranks, CloudPart part);

  Ranks& ranks() const { return *ranks_; }
  bool is_whole() const { return !plan_; }
  bool is_of_lattice() const { return plan_ && std::holds_alternative<LatticePart>(plan_->part); }  ///< and partial
  const Lattice& whole() const { return lattice_part().whole; }                                     ///< lattice of the whole body; requires a part of one
  Lattice lattice() const { return lattice_part().lattice; }                                        ///< that of this rank, with ghosts; requires a part of one
  CellBox owned_cells() const;                                                                      ///< of lattice(); requires a part of one
  CellBox interior() const { return lattice_part().interior; }  ///< cells of lattice() whose stencils reach no ghost, in x whole eights; requires a part of one
  /// The eights of a cloud that this rank has, owned and ghosts; requires a part of one.
  std::span<const std::uint32_t> eights() const { return cloud_part().eights; }
  bool reads_ghosts(std::size_t eight) const { return cloud_part().reads_ghosts[eight] != 0; }  ///< requires a part of a cloud
  std::span<const SlotRun> owned() const;                                                       ///< whole eights, ascending; requires a partial share
  std::size_t slots_of_whole() const;                                                           ///< requires a partial share
  int parts() const;                                                                            ///< number of ranks that own slots; requires a partial share
  CellBox part_of(int rank) const;                                                              ///< as MeasuredPart::cells; requires a partial share

  /// Sets the values of ghosts to those of their owners. `arrays`: by slot of lattice().
  template <class T>
  void refresh(std::initializer_list<T*> arrays) const {
    refresh(std::span<T* const>(arrays.begin(), arrays.size()));
  }
  template <class T>
  void refresh(std::span<T* const> arrays) const {
    begin_refresh(arrays);
    complete_refresh();
  }
  /// The same while computation goes on: ghosts must not be read before complete_refresh(), nor the arrays be moved. Loops over packs complete it after the
  /// particles that read no ghosts (force/pass.hpp).
  template <class T>
  void begin_refresh(std::initializer_list<T*> arrays) const {
    begin_refresh(std::span<T* const>(arrays.begin(), arrays.size()));
  }
  template <class T>
  void begin_refresh(std::span<T* const> arrays) const;
  void complete_refresh() const;
  bool is_refreshing() const { return plan_ && !plan_->under_way.empty(); }

  /// Sets flags of owned slots that another rank has set for its ghost there. Values other than 0 are flags.
  void collect_flags(std::uint8_t* flags) const;

  /// Slot in the whole body.
  std::size_t whole_slot(std::size_t slot) const;

  /// Calls visit(slot) for the ghosts that are refreshed, once each.
  template <class Visit>
  void for_each_ghost(const Visit& visit) const {
    if (!plan_) return;
    for (const Peer& peer : plan_->peers)
      for (const SlotRun& run : peer.receive)
        for (std::size_t k = 0; k < run.count; ++k) visit(run.first + k);
  }

  /// Sets the flags of the eights of ghosts to those of their owners; each ghost's, since an eight may be only partly within reach.
  std::vector<std::uint8_t> refreshed_flags(std::span<const std::uint8_t> of_eights) const {
    std::vector<std::uint8_t> of_slots(of_eights.size() * fccda::byte_lanes);
    for (std::size_t slot = 0; slot < of_slots.size(); ++slot) of_slots[slot] = of_eights[slot / fccda::byte_lanes];
    refresh({of_slots.data()});
    return of_slots;
  }

  /// Numbers of the eights of the whole body, from those of the owned eights of each rank; on the root, elsewhere empty. Collective.
  template <class T>
  std::vector<T> gather(std::span<const T> own, const NumbersOfEights& numbers) const;
  /// Sets the numbers of this rank from those of the whole body, which the root has. Ghosts have values by slot, but neither bonds nor sums of their own: only
  /// for numbers of 8 of each eight that are not integers they are set too, else to 0. Collective.
  template <class T>
  void take(std::span<const T> on_root, std::span<T> own, const NumbersOfEights& numbers) const;
  /// How many numbers the eights of the whole body have. Collective.
  std::size_t count_of_whole(const NumbersOfEights& numbers) const;
  /// Numbers of listed particles, as many of each, in the order of their slots in the whole body; on the root, elsewhere empty. `slots`: owned. Collective.
  template <class T>
  std::vector<T> gather_listed(std::span<const T> own, std::span<const std::uint32_t> slots) const;
  /// Sets the numbers of the listed particles of this rank from those of all, which the root has. Collective.
  template <class T>
  void take_listed(std::span<const T> on_root, std::span<T> own, std::span<const std::uint32_t> slots) const;
  /// Sets the numbers of the owned eights to those, `from`, of the eights `by` cells further on, which other ranks may own; they stay as they are where these
  /// are outside the body. `lattice`: of this rank; `by` is a multiple of eight along x. Collective.
  template <class T>
  void shift(const Lattice& lattice, std::span<const T> from, std::span<T> own, std::size_t per_eight, const std::array<int, 3>& by) const;
  /// The same share of a lattice that begins at another cell (Lattice::first).
  Share at(const std::array<int, 3>& first) const;
  /// The slot of this rank, or nothing if another rank owns it.
  std::optional<std::size_t> owned_slot(std::size_t whole_slot) const;
  /// The slot of this rank, ghosts and their surroundings included, or nothing if it has none.
  std::optional<std::size_t> local_slot(std::size_t whole_slot) const;
  /// The rank that owns a slot of the whole body.
  int owner_of(std::size_t whole_slot) const;
  /// Calls f(first, first in the whole body, count) for runs of the numbers of owned eights. Collective.
  template <class F>
  void for_each_owned_run(const NumbersOfEights& numbers, const F& f) const;

  std::size_t peers() const { return plan_ ? plan_->peers.size() : 0; }  ///< ranks with which ghosts are exchanged
  std::size_t ghosts() const;                                            ///< slots of other ranks that are refreshed
  std::size_t sent_slots() const;                                        ///< slots sent in a refresh, with repetition

 private:
  struct Peer {
    int rank;
    std::vector<SlotRun> send, receive;
  };
  struct LatticePart {
    Lattice whole, lattice;
    std::array<int, 3> offset{};  // of the own lattice's first cell in the whole
    CellBox owned;                // cells of the whole
    std::vector<CellBox> boxes;   // of all ranks, cells of the whole
    CellBox interior;             // of the own lattice
  };
  struct Plan {
    std::variant<LatticePart, CloudPart> part;
    std::vector<SlotRun> owned;  // whole eights
    std::vector<Peer> peers;
    mutable std::vector<std::function<void()>> under_way;  // complete the refreshes that have begun
  };
  const LatticePart& lattice_part() const;
  const CloudPart& cloud_part() const;
  /// Numbers on their way between this rank and each peer.
  template <class T>
  struct Messages {
    std::vector<std::vector<T>> sent, received;
    std::unique_ptr<Ranks::Exchange> exchange;
  };
  /// What this rank sends to each in a shift, and where what it receives belongs; with itself.
  struct Shifted {
    int rank;
    CellBox send, receive;  // cells of the own lattice
  };
  std::vector<Shifted> exchanged_in_shift(const Lattice& lattice, const std::array<int, 3>& by) const;
  std::vector<std::uint64_t> whole_slots(std::span<const std::uint32_t> slots) const;
  /// The places of the numbers in ascending order.
  static std::vector<std::size_t> order_of(std::span<const std::uint64_t> numbers);
  static std::size_t per_listed(std::size_t numbers, std::size_t particles) { return particles == 0 ? 0 : numbers / particles; }
  /// How many the ranks before this one have, if each calls with its count. Collective.
  std::size_t first_of_own(std::size_t count) const;
  std::size_t count_of_owned(const NumbersOfEights& numbers) const;
  /// The first of the numbers of owned eights among those of the whole body, where they vary. Collective.
  std::size_t first_of_varying(const NumbersOfEights& numbers) const;
  /// Begins to send the numbers in some runs of each peer, and to receive those for others.
  template <class T>
  Messages<T> begin(std::span<T* const> arrays, std::vector<SlotRun> Peer::*from, std::vector<SlotRun> Peer::*to) const;
  /// Waits for them, and passes them to take(values, count, to) by runs.
  template <class T, class Take>
  static void complete(const Plan& plan, Messages<T>& messages, std::span<T* const> arrays, std::vector<SlotRun> Peer::*to, const Take& take);
  /// Calls f(first, count) for the numbers of the eights of each row of a box of cells.
  template <class F>
  static void for_each_row_of_eights(const Lattice& lattice, const CellBox& box, std::size_t per_eight, const F& f);

  Ranks* ranks_;
  std::shared_ptr<const Plan> plan_;
};

inline std::size_t Share::whole_slot(std::size_t slot) const {
  if (!plan_) return slot;
  if (const auto* cloud = std::get_if<CloudPart>(&plan_->part))
    return std::size_t{cloud->eights[slot / fccda::byte_lanes]} * fccda::byte_lanes + slot % fccda::byte_lanes;
  const LatticePart& part = *std::get_if<LatticePart>(&plan_->part);
  std::array<int, 3> cell = part.lattice.cell(slot);
  for (std::size_t axis = 0; axis < 3; ++axis) cell[axis] += part.offset[axis];
  return part.whole.slot(cell[0], cell[1], cell[2]);
}

template <class F>
void Share::for_each_row_of_eights(const Lattice& lattice, const CellBox& box, std::size_t per_eight, const F& f) {
  const std::size_t eights = fccda::eights_of(static_cast<std::size_t>(box.size(0)));
  for (int k = box.low[2]; k < box.high[2]; ++k)
    for (int j = box.low[1]; j < box.high[1]; ++j) f(lattice.slot(box.low[0], j, k) / fccda::byte_lanes * per_eight, eights * per_eight);
}

template <class F>
void Share::for_each_owned_run(const NumbersOfEights& numbers, const F& f) const {
  const std::size_t first_if_varying = numbers.begin.empty() ? 0 : first_of_varying(numbers);
  for (const SlotRun& run : plan_->owned) {
    const auto [first, count] = numbers.of(run);
    f(first, numbers.begin.empty() ? numbers.first(whole_slot(run.first) / fccda::byte_lanes) : first_if_varying, count);
  }
}

template <class T>
std::vector<T> Share::gather(std::span<const T> own, const NumbersOfEights& numbers) const {
  if (!plan_) return {own.begin(), own.end()};
  std::vector<T> sent;
  for (const SlotRun& run : plan_->owned) {
    const auto [first, count] = numbers.of(run);
    sent.insert(sent.end(), own.begin() + static_cast<std::ptrdiff_t>(first), own.begin() + static_cast<std::ptrdiff_t>(first + count));
  }
  const std::vector<Ranks::Bytes> all = ranks_->gather(std::as_bytes(std::span<const T>(sent)));
  if (all.empty()) return {};
  std::size_t bytes = 0;
  for (const Ranks::Bytes& of_rank : all) bytes += of_rank.size();
  std::vector<T> whole(bytes / sizeof(T));
  if (const auto* cloud = std::get_if<CloudPart>(&plan_->part)) {
    std::byte* to = reinterpret_cast<std::byte*>(whole.data());
    for (int part = 0; part < cloud->partition.parts(); ++part) to = std::ranges::copy(all[static_cast<std::size_t>(cloud->partition.rank_of(part))], to).out;
    return whole;
  }
  const LatticePart& part = lattice_part();
  for (std::size_t rank = 0; rank < all.size(); ++rank) {
    const std::byte* from = all[rank].data();
    for_each_row_of_eights(part.whole, part.boxes[rank], numbers.each, [&](std::size_t first, std::size_t count) {
      if (count > 0) std::memcpy(whole.data() + first, from, count * sizeof(T));
      from += count * sizeof(T);
    });
  }
  return whole;
}

template <class T>
void Share::take(std::span<const T> on_root, std::span<T> own, const NumbersOfEights& numbers) const {
  if (!plan_) {
    std::copy(on_root.begin(), on_root.end(), own.begin());
    return;
  }
  const bool with_ghosts = std::is_floating_point_v<T> && numbers.begin.empty() && numbers.each == fccda::byte_lanes;
  if (!with_ghosts) std::fill(own.begin(), own.end(), T{});
  std::vector<SlotRun> runs;
  std::vector<std::uint64_t> runs_of_whole;  // first and count
  const auto add = [&](std::size_t first, std::size_t first_of_whole, std::size_t count) {
    runs.push_back({first, count});
    runs_of_whole.push_back(first_of_whole), runs_of_whole.push_back(count);
  };
  if (!with_ghosts) {
    for_each_owned_run(numbers, add);
  } else if (is_of_lattice()) {
    const Lattice& own_lattice = lattice_part().lattice;
    for_each_row_of_eights(own_lattice, {{0, 0, 0}, own_lattice.cells}, numbers.each, [&](std::size_t first, std::size_t count) {
      add(first, numbers.first(whole_slot(first / numbers.each * fccda::byte_lanes) / fccda::byte_lanes), count);
    });
  } else {
    for (std::size_t eight = 0; eight < eights().size(); ++eight) add(numbers.first(eight), numbers.first(eights()[eight]), numbers.each);
  }
  const std::vector<T> values = ranks_->distribute(on_root, std::span<const std::uint64_t>(runs_of_whole));
  auto from = values.begin();
  for (const SlotRun& run : runs) {
    std::copy_n(from, run.count, own.data() + run.first);
    from += static_cast<std::ptrdiff_t>(run.count);
  }
}

template <class T>
void Share::shift(const Lattice& lattice, std::span<const T> from, std::span<T> own, std::size_t per_eight, const std::array<int, 3>& by) const {
  const std::vector<Shifted> peers = exchanged_in_shift(lattice, by);
  std::vector<std::vector<T>> sent(peers.size()), received(peers.size());
  std::vector<Ranks::Outgoing> outgoing;
  std::vector<Ranks::Incoming> incoming;
  for (std::size_t p = 0; p < peers.size(); ++p) {
    const Shifted& peer = peers[p];
    for_each_row_of_eights(lattice, peer.send, per_eight, [&](std::size_t first, std::size_t count) {
      sent[p].insert(sent[p].end(), from.begin() + static_cast<std::ptrdiff_t>(first), from.begin() + static_cast<std::ptrdiff_t>(first + count));
    });
    received[p].resize(peer.receive.cells() / fccda::byte_lanes * per_eight);
    if (peer.rank == ranks_->rank()) {
      received[p].swap(sent[p]);
      continue;
    }
    outgoing.push_back({peer.rank, std::as_bytes(std::span(sent[p]))});
    incoming.push_back({peer.rank, std::as_writable_bytes(std::span(received[p]))});
  }
  ranks_->exchange(outgoing, incoming);
  for (std::size_t p = 0; p < peers.size(); ++p) {
    auto values = received[p].begin();
    for_each_row_of_eights(lattice, peers[p].receive, per_eight, [&](std::size_t first, std::size_t count) {
      std::copy_n(values, count, own.begin() + static_cast<std::ptrdiff_t>(first));
      values += static_cast<std::ptrdiff_t>(count);
    });
  }
}

template <class T>
std::vector<T> Share::gather_listed(std::span<const T> own, std::span<const std::uint32_t> slots) const {
  if (!plan_) return {own.begin(), own.end()};
  const std::vector<T> joined = ranks_->join(own);
  const std::vector<std::uint64_t> of_whole = whole_slots(slots);
  const std::vector<std::size_t> order = order_of(ranks_->join(std::span<const std::uint64_t>(of_whole)));
  const std::size_t per_slot = per_listed(joined.size(), order.size());  // this rank may have none
  std::vector<T> sorted;
  sorted.reserve(joined.size());
  for (const std::size_t at : order)
    sorted.insert(sorted.end(), joined.begin() + static_cast<std::ptrdiff_t>(at * per_slot), joined.begin() + static_cast<std::ptrdiff_t>((at + 1) * per_slot));
  return sorted;
}

template <class T>
void Share::take_listed(std::span<const T> on_root, std::span<T> own, std::span<const std::uint32_t> slots) const {
  if (!plan_) {
    std::copy(on_root.begin(), on_root.end(), own.begin());
    return;
  }
  const std::vector<std::uint64_t> of_whole = whole_slots(slots);
  const std::vector<std::size_t> order = order_of(ranks_->join(std::span<const std::uint64_t>(of_whole)));
  std::vector<T> by_rank(on_root.size());
  const std::size_t per_slot = per_listed(on_root.size(), order.size());
  for (std::size_t place = 0; place < order.size(); ++place) std::copy_n(on_root.data() + place * per_slot, per_slot, by_rank.data() + order[place] * per_slot);
  const std::uint64_t run[] = {first_of_own(slots.size()) * per_listed(own.size(), slots.size()), own.size()};
  std::ranges::copy(ranks_->distribute(std::span<const T>(by_rank), std::span<const std::uint64_t>(run)), own.begin());
}

template <class T>
Share::Messages<T> Share::begin(std::span<T* const> arrays, std::vector<SlotRun> Peer::*from, std::vector<SlotRun> Peer::*to) const {
  std::vector<std::vector<T>> sent(plan_->peers.size()), received(plan_->peers.size());
  std::vector<Ranks::Outgoing> outgoing;
  std::vector<Ranks::Incoming> incoming;
  for (std::size_t p = 0; p < plan_->peers.size(); ++p) {
    const Peer& peer = plan_->peers[p];
    sent[p].reserve(arrays.size() * slots_in(peer.*from));
    received[p].resize(arrays.size() * slots_in(peer.*to));
    for (const T* array : arrays)
      for (const SlotRun& run : peer.*from) sent[p].insert(sent[p].end(), array + run.first, array + run.first + run.count);
    outgoing.push_back({peer.rank, std::as_bytes(std::span(sent[p]))});
    incoming.push_back({peer.rank, std::as_writable_bytes(std::span(received[p]))});
  }
  auto exchange = ranks_->begin_exchange(outgoing, incoming);
  return {std::move(sent), std::move(received), std::move(exchange)};
}

template <class T, class Take>
void Share::complete(const Plan& plan, Messages<T>& messages, std::span<T* const> arrays, std::vector<SlotRun> Peer::*to, const Take& take) {
  messages.exchange->complete();
  for (std::size_t p = 0; p < plan.peers.size(); ++p) {
    const T* values = messages.received[p].data();
    for (T* array : arrays)
      for (const SlotRun& run : plan.peers[p].*to) {
        take(values, run.count, array + run.first);
        values += run.count;
      }
  }
}

template <class T>
void Share::begin_refresh(std::span<T* const> arrays) const {
  if (!plan_) return;
  auto messages = std::make_shared<Messages<T>>(begin(arrays, &Peer::send, &Peer::receive));
  plan_->under_way.push_back([plan = plan_.get(), messages, refreshed = std::vector<T*>(arrays.begin(), arrays.end())] {
    const auto copy = [](const T* values, std::size_t count, T* to) { std::copy_n(values, count, to); };
    complete(*plan, *messages, std::span<T* const>(refreshed), &Peer::receive, copy);
  });
}

}  // namespace perimpact
