#include "io/deck/named_files.hpp"

#include "io/deck/yaml_node.hpp"

namespace perimpact::deck {

namespace {

bool is_path(std::string_view key) { return key == "file" || key == "modes"; }

void collect(const YamlNode& node, std::vector<std::filesystem::path>& files) {
  for (const YamlNode::Entry& entry : node.entries) {
    if (is_path(entry.key) && entry.value.kind == YamlNode::Kind::word && !entry.value.text.empty()) files.emplace_back(entry.value.text);
    collect(entry.value, files);
  }
}

}  // namespace

std::vector<std::filesystem::path> named_files(std::string_view setup) {
  std::vector<std::filesystem::path> files;
  collect(parse_document(setup, "the deck"), files);
  return files;
}

}  // namespace perimpact::deck
