/// Tokenizer of text files that counts lines for error messages.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace fccda {

class Words {
 public:
  /// `text` must outlive this object. `first_line`: line number of the start of `text` in its file.
  Words(std::string_view text, std::string file, std::size_t first_line = 1);

  std::string_view next();          ///< empty at the end of the file
  std::string_view next_in_line();  ///< empty at the end of the line, which it does not pass; a backslash at the end joins two lines
  std::string rest_of_line();       ///< trimmed, with ? for unprintable bytes; does not pass the end of the line
  void skip_line();                 ///< moves to the start of the next line
  bool at_end();                    ///< after skipping white space

  /// The next raw bytes, fewer at the end of the file, for files that mix text and binary numbers. Lines in them are not counted.
  std::string_view bytes(std::size_t count);
  std::size_t remaining() const { return text_.size() - at_; }  ///< bytes to the end of the file

  /// The word as a finite number, in any notation that C++ reads; throws InputError for anything else. `what` names the quantity in the message.
  double number(std::string_view word, std::string_view what) const;

  /// Throws InputError: "file:line: sentence".
  [[noreturn]] void fail(const std::string& sentence) const;

 private:
  bool at_line_end() const;
  void pass_line_end();
  std::string_view take_word();

  std::string_view text_;
  std::string file_;
  std::size_t at_ = 0;
  std::size_t line_;
};

/// A name from a file prepared for a message: truncated where long, with ? for unprintable bytes.
std::string excerpt(std::string_view word, std::size_t longest = 80);

/// A quoted word for messages: truncated where long, with ? for unprintable bytes; "nothing" for an empty word.
std::string shown(std::string_view word);

/// Whether two words are equal without regard to case. `lower` must be in lower case.
bool is_word(std::string_view word, std::string_view lower);

}  // namespace fccda
