/// Messages whose lengths, and whose receivers, only the sender knows.
#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "perimpact/ranks/ranks.hpp"

namespace perimpact {

/// Lists by rank: sent to it, or received from it.
template <class T>
using ListsByRank = std::map<int, std::vector<T>>;

/// Sends each list to its rank, and returns those received from others; empty lists are left out. Collective.
template <class T>
ListsByRank<T> exchange_lists(Ranks& ranks, const ListsByRank<T>& lists) {
  struct Announced {
    std::int64_t to, count;
  };
  std::vector<Announced> own;
  std::vector<Ranks::Outgoing> outgoing;
  for (const auto& [to, list] : lists) {
    if (list.empty()) continue;
    own.push_back({to, static_cast<std::int64_t>(list.size())});
    outgoing.push_back({to, std::as_bytes(std::span(list))});
  }
  const std::vector<Ranks::Bytes> of_all = ranks.gather_all(std::as_bytes(std::span(own)));
  ListsByRank<T> received;
  std::vector<Ranks::Incoming> incoming;
  for (std::size_t rank = 0; rank < of_all.size(); ++rank) {
    std::vector<Announced> announced(of_all[rank].size() / sizeof(Announced));
    if (!announced.empty()) std::memcpy(announced.data(), of_all[rank].data(), of_all[rank].size());
    for (const Announced& message : announced) {
      if (message.to != ranks.rank()) continue;
      std::vector<T>& list = received[static_cast<int>(rank)];
      list.resize(static_cast<std::size_t>(message.count));
      incoming.push_back({static_cast<int>(rank), std::as_writable_bytes(std::span(list))});
    }
  }
  ranks.exchange(outgoing, incoming);
  return received;
}

}  // namespace perimpact
