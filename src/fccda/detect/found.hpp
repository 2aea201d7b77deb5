/// What a detector finds in a share of the points, and how shares are put together, in their order.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "fccda/detect/contact.hpp"
#include "fccda/detect/points.hpp"
#include "fccda/detect/side_record.hpp"

namespace fccda {

/// Of a share of the points, for parallel loops.
template <class ContactOfDetector>
struct Found {
  std::vector<ContactOfDetector> contacts;                        ///< in point order
  SideRecord::Changes sides;                                      ///< of these points
  Effort effort;                                                  ///< of these points
  void clear() { contacts.clear(), sides.clear(), effort = {}; }  ///< for the next loop
};

/// Adds what the shares contain: contacts to `out`, changes to `sides`, work to `effort`.
template <class ContactOfDetector>
void gather(std::span<const Found<ContactOfDetector>> shares, std::vector<ContactOfDetector>& out, SideRecord& sides, Effort& effort) {
  std::vector<const SideRecord::Changes*> changes;
  for (const Found<ContactOfDetector>& found : shares) {
    out.insert(out.end(), found.contacts.begin(), found.contacts.end());
    changes.push_back(&found.sides);
    effort += found.effort;
  }
  sides.add(changes);
}

/// First points of the blocks, and the number of points.
template <Points P>
void list_blocks(const P& points, std::vector<std::size_t>& blocks) {
  blocks.clear();
  for (std::size_t b = 0; b < points.block_count(); ++b) blocks.push_back(points.block_begin(b));
  blocks.push_back(points.size());
}

}  // namespace fccda
