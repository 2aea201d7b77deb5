/// Line reader with line numbers, for line- and column-based formats.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace fccda {

class Lines {
 public:
  /// `text` must outlive this object. A byte order mark is skipped.
  Lines(std::string_view text, std::string file);

  bool next();                                            ///< moves to the next line (initially the first); false at the end of the file
  std::string_view line() const { return line_; }         ///< without its line end: a line feed, a carriage return or both
  std::size_t number() const { return number_; }          ///< line number, from 1
  std::size_t file_size() const { return text_.size(); }  ///< [bytes]

  /// Throws InputError "file:line: sentence", for the current or a given line.
  [[noreturn]] void fail(const std::string& sentence) const { fail_at(number_, sentence); }
  [[noreturn]] void fail_at(std::size_t number, const std::string& sentence) const;

 private:
  std::string_view text_;
  std::string file_;
  std::string_view line_;
  std::size_t at_ = 0;
  std::size_t number_ = 0;
};

/// The text in upper case, for comparison of keywords without regard to case.
std::string capitals(std::string_view text);

}  // namespace fccda
