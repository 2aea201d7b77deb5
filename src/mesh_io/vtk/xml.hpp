/// Sequential (pull) reader of XML tags, as far as data files need them: elements, attributes, text, comments and processing instructions;
/// no entities or document types. Time and memory do not depend on the nesting depth.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace fccda {

struct XmlTag {
  enum class Kind : std::uint8_t { opening, closing, alone, end_of_file };  ///< <a>, </a>, <a/>
  Kind kind = Kind::end_of_file;
  std::string_view name;
  std::string_view attributes;  ///< text between the name and the end of the tag
  std::size_t line = 0;         ///< where it begins

  /// The raw value of an attribute; empty where there is none.
  std::string_view operator[](std::string_view attribute) const;
};

class XmlTags {
 public:
  /// `text` must outlive this object and the tags.
  XmlTags(std::string_view text, std::string file);

  /// The next tag, comments excluded. Throws InputError where a tag is not closed.
  XmlTag next();

  std::string_view text() const { return text_before_; }       ///< before the latest tag
  std::size_t line_of_text() const { return line_of_text_; }   ///< line where that text begins
  std::string_view rest() const { return text_.substr(at_); }  ///< text after the latest tag

  /// Throws InputError: "file:line: sentence".
  [[noreturn]] void fail(std::size_t line, const std::string& sentence) const;

 private:
  void pass(std::size_t end);
  void pass_behind(std::string_view mark, const char* what);
  std::size_t end_of_tag() const;

  std::string_view text_;
  std::string file_;
  std::size_t at_ = 0;
  std::size_t line_ = 1;
  std::string_view text_before_;
  std::size_t line_of_text_ = 1;
};

}  // namespace fccda
