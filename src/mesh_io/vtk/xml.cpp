#include "mesh_io/vtk/xml.hpp"

#include <algorithm>
#include <utility>

#include "base/error.hpp"
#include "mesh_io/file/text.hpp"

namespace fccda {
namespace {

constexpr std::string_view blanks = " \t\r\n";

}  // namespace

std::string_view XmlTag::operator[](std::string_view attribute) const {
  std::string_view rest = attributes;
  for (;;) {
    const std::size_t equals = rest.find('=');
    if (equals == std::string_view::npos) return {};
    const std::string_view found = trimmed(rest.substr(0, equals), blanks);
    const std::size_t open = rest.find_first_of("\"'", equals);
    if (open == std::string_view::npos) return {};
    const std::size_t close = rest.find(rest[open], open + 1);
    if (close == std::string_view::npos) return {};
    if (found == attribute) return rest.substr(open + 1, close - open - 1);
    rest.remove_prefix(close + 1);
  }
}

XmlTags::XmlTags(std::string_view text, std::string file) : text_(text), file_(std::move(file)) {}

void XmlTags::fail(std::size_t line, const std::string& sentence) const { throw InputError(file_ + ":" + std::to_string(line) + ": " + sentence); }

void XmlTags::pass(std::size_t end) {
  line_ += static_cast<std::size_t>(std::count(text_.begin() + static_cast<std::ptrdiff_t>(at_), text_.begin() + static_cast<std::ptrdiff_t>(end), '\n'));
  at_ = end;
}

void XmlTags::pass_behind(std::string_view mark, const char* what) {
  const std::size_t end = text_.find(mark, at_);
  if (end == std::string_view::npos) fail(line_, std::string(what) + " is not closed; the file is truncated: export it again.");
  pass(end + mark.size());
}

/// The position of the closing > of the tag at at_, outside quoted values.
std::size_t XmlTags::end_of_tag() const {
  char quote = 0;
  for (std::size_t k = at_; k < text_.size(); ++k) {
    const char c = text_[k];
    if (quote != 0) {
      if (c == quote) quote = 0;
    } else if (c == '"' || c == '\'') {
      quote = c;
    } else if (c == '>') {
      return k;
    }
  }
  fail(line_, "a tag is not closed; the file is truncated: export it again.");
}

XmlTag XmlTags::next() {
  for (;;) {
    const std::size_t begin = std::min(text_.find('<', at_), text_.size());
    text_before_ = text_.substr(at_, begin - at_);
    line_of_text_ = line_;
    pass(begin);
    if (begin == text_.size()) return {XmlTag::Kind::end_of_file, {}, {}, line_};
    const std::string_view tag = text_.substr(begin);
    if (tag.starts_with("<!--")) {
      pass_behind("-->", "a comment");
    } else if (tag.starts_with("<?")) {
      pass_behind("?>", "a tag <?");
    } else if (tag.starts_with("<!")) {
      fail(line_, "document types and CDATA (`<!`) are not supported; export the file again.");
    } else {
      break;
    }
  }
  XmlTag tag;
  tag.line = line_;
  const std::size_t end = end_of_tag();
  std::string_view inside = text_.substr(at_ + 1, end - at_ - 1);
  tag.kind = inside.starts_with('/') ? XmlTag::Kind::closing : inside.ends_with('/') ? XmlTag::Kind::alone : XmlTag::Kind::opening;
  if (tag.kind == XmlTag::Kind::closing) inside.remove_prefix(1);
  if (tag.kind == XmlTag::Kind::alone) inside.remove_suffix(1);
  const std::size_t length = std::min(inside.find_first_of(blanks), inside.size());
  tag.name = inside.substr(0, length);
  tag.attributes = inside.substr(length);
  pass(end + 1);
  return tag;
}

}  // namespace fccda
