/// The lines of a text file with their numbers, for formats in which lines and columns count.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace fccda {

class Lines {
 public:
  /// `text` must outlive this. A byte order mark is passed over.
  Lines(std::string_view text, std::string file);

  bool next();                                            ///< goes to the next line, the first at first; false where there is none
  std::string_view line() const { return line_; }         ///< without its end: a line feed, a carriage return or both
  std::size_t number() const { return number_; }          ///< of the line, counted from 1
  std::size_t file_size() const { return text_.size(); }  ///< [bytes]

  /// Throws InputError: "file:line: sentence", of the current line or of a given one.
  [[noreturn]] void fail(const std::string& sentence) const { fail_at(number_, sentence); }
  [[noreturn]] void fail_at(std::size_t number, const std::string& sentence) const;

 private:
  std::string_view text_;
  std::string file_;
  std::string_view line_;
  std::size_t at_ = 0;
  std::size_t number_ = 0;
};

/// In capitals, as formats that were born on punched cards compare their words.
std::string capitals(std::string_view text);

}  // namespace fccda
