#include "io/deck/reference_markdown.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.hpp"
#include "fixtures/temporary_folder.hpp"
#include "io/deck/key_path.hpp"
#include "io/deck/reference.hpp"
#include "io/deck/reference_text.hpp"

namespace fs = std::filesystem;
using namespace perimpact::deck;

namespace {

const fs::path guide = PROJECT_FOLDER "/docs/guide/deck";

const std::string& page_named(const std::vector<Page>& pages, const std::string& file) {
  const auto found = std::find_if(pages.begin(), pages.end(), [&](const Page& page) { return page.file == file; });
  REQUIRE_MESSAGE(found != pages.end(), file);
  return found->text;
}

std::size_t count_of(const std::string& text, const std::string& word) {
  std::size_t count = 0;
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++count;
  return count;
}

}  // namespace

TEST_CASE("deck reference: the guide has exactly the generated pages (perimpact describe --markdown docs/guide/deck writes them)") {
  std::set<std::string> generated;
  for (const Page& page : reference_pages()) {
    generated.insert(page.file);
    const bool is_up_to_date = fs::exists(guide / page.file) && fixtures::text_of(guide / page.file) == page.text;
    CHECK_MESSAGE(is_up_to_date, page.file);
  }
  CHECK(fixtures::files_in(guide) == generated);
}

TEST_CASE("deck reference: every key is on the page of its map, and only there") {
  const std::vector<Page> pages = reference_pages();
  for (const Entry& entry : reference()) {
    if (entry.key() == any_name) continue;
    const PageText* owner = page_of(entry.parent());
    CHECK_MESSAGE((owner != nullptr || entry.parent() == top_level || entry.parent() == "bodies" || entry.parent() == "impactors"), entry.path);
    const std::string row = "| `" + std::string(entry.key()) + "` | ";
    CHECK_MESSAGE(page_named(pages, owner ? owner->name + ".md" : "index.md").find(row) != std::string::npos, entry.path);
  }
}

TEST_CASE("deck reference: keys that all materials share, and those of solids in several maps, are described once") {
  const std::vector<Page> pages = reference_pages();
  for (const char* key : {"youngs_modulus", "density", "critical_stretch", "fracture_energy", "ice", "plasticity"})
    CHECK_MESSAGE(count_of(page_named(pages, "materials.md"), "| `" + std::string(key) + "` |") == 1, key);
  for (const char* key : {"size", "diameter` | number [m], above 0 | required | Diameter. |\n\n#", "weld"})
    CHECK_MESSAGE(count_of(page_named(pages, "shapes.md"), "| `" + std::string(key)) == 1, key);
  CHECK(page_named(pages, "materials.md").find("(with model: linear-peridynamic-solid, correspondence) Influence function") != std::string::npos);
}

TEST_CASE("deck reference: every page has examples, which the reader accepts without a warning, and links to related pages") {
  for (const PageText& page : page_texts()) {
    CAPTURE(page.name);
    CHECK(!page.title.empty());
    CHECK(page.text.ends_with('.'));
    CHECK(!page.examples.empty());
    CHECK(!page.related.empty());
    for (const Example& example : page.examples) {
      const fixtures::TemporaryFolder folder;
      for (const auto& [name, contents] : example.files) fixtures::put(folder / name, contents);
      CHECK_MESSAGE(read_example(example, folder.path()).warnings.empty(), example.fragment);
    }
  }
}

TEST_CASE("deck reference: the examples of a page use each of its maps") {
  for (const PageText& page : page_texts()) {
    for (const std::string& map : page.maps) {
      std::vector<std::string_view> keys = keys_of(map);
      while (keys.back() == any_name) keys.pop_back();
      const std::string key = std::string(keys.back()) + ":";
      CHECK_MESSAGE(std::any_of(page.examples.begin(), page.examples.end(), [&](const Example& each) { return each.fragment.find(key) != std::string::npos; }),
                    map);
    }
  }
}

TEST_CASE("deck reference: an example with an unknown key or a contradiction is refused") {
  CHECK_THROWS_AS(read_example({"", "contact: {impactors: {frictoin: 1}}\n", {}}), fccda::InputError);
  const std::string contradiction[] = {"contact.impactors.variant=literal"};
  CHECK_THROWS_AS(read_example({"", "contact: {impactors: {friction: 0.1}}\n", {}}, {}, contradiction), fccda::InputError);
}
