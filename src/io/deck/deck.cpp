#include "io/deck/deck.hpp"

#include <fstream>
#include <iterator>
#include <utility>

#include "io/deck/consistency.hpp"
#include "io/deck/deprecated_keys.hpp"
#include "io/deck/overrides.hpp"
#include "io/deck/reader.hpp"

namespace perimpact::deck {

namespace fs = std::filesystem;

namespace {

std::string content_of(const fs::path& file) {
  std::error_code ignored;
  if (fs::is_directory(file, ignored)) refuse(file.string(), "this is a folder; give the deck in it, for example " + (file / "deck.yaml").string() + ".");
  if (!fs::exists(file, ignored)) refuse(file.string(), "there is no such file; check the path of the deck.");
  if (fs::is_fifo(file, ignored) || fs::is_socket(file, ignored))
    refuse(file.string(), "this is a pipe, not a file; write the deck to a file, since a run can be resumed with it only.");
  std::ifstream stream(file, std::ios::binary);
  try {
    if (stream) return {std::istreambuf_iterator<char>(stream), {}};
  } catch (const std::ios_base::failure&) {
    // opened but not readable: a disk error, or a device instead of a file
  }
  refuse(file.string(), "this file cannot be read; check its permissions.");
}

}  // namespace

YamlNode read_deck_tree(const fs::path& file) { return parse_document(content_of(file), file.string()); }

Deck read_deck(const fs::path& file, std::span<const std::string> overrides) {
  return read_deck_text(content_of(file), file.string(), file.parent_path(), overrides);
}

Deck read_deck_text(std::string_view text, const std::string& name, const fs::path& folder, std::span<const std::string> overrides) {
  YamlNode document = parse_document(text, name);
  for (const std::string& change : overrides) apply_override(document, change);
  return deck_of_tree(std::move(document), name, folder);
}

Deck deck_of_tree(YamlNode document, const std::string& name, const fs::path& folder, const SurfacesInMemory& surfaces) {
  std::vector<std::string> warnings = rename_deprecated_keys(document);  // may throw; first, as GCC 12 destroys members of an unfinished Setup wrongly
  Deck deck{.setup = {}, .places = Places(name), .warnings = std::move(warnings)};
  Reader(document, "", name, deck.places).read(deck.setup);
  make_consistent(deck.setup, deck.places, folder, surfaces);
  return deck;
}

}  // namespace perimpact::deck
