/// The deck reference as Markdown, a page for each block of keys (docs/guide/deck/).
#pragma once

#include <string>
#include <vector>

namespace perimpact::deck {

struct Page {
  std::string file;  ///< "materials.md"
  std::string text;
};

/// An index and the pages of page_texts(), from the tables that also read the deck. Throws std::logic_error where the reader accepts
/// what a page lists as refused, and InputError where it refuses the example of that page.
std::vector<Page> reference_pages();

}  // namespace perimpact::deck
