/// The words of a text file with their line numbers, and the errors that name them.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace fccda {

class Words {
 public:
  /// `text` must outlive this. `first_line`: which line of the file it starts in.
  Words(std::string_view text, std::string file, std::size_t first_line = 1);

  std::string_view next();          ///< empty at the end of the file
  std::string_view next_in_line();  ///< empty at the end of the line, which it does not pass; a backslash before it joins two lines
  std::string rest_of_line();       ///< without white space at its ends and with ? for bytes that no terminal shows; does not pass the line's end
  void skip_line();                 ///< goes to the start of the next line
  bool at_end();                    ///< after white space

  /// The next bytes as they are, fewer where the file ends: for files that have both text and binary numbers. Lines in them are not counted.
  std::string_view bytes(std::size_t count);
  std::size_t remaining() const { return text_.size() - at_; }  ///< bytes up to the end of the file

  /// The word as a finite number, in any notation that C++ reads; throws InputError for anything else. `what` is what the sentence calls it.
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

/// A name from a file as it can stand in a message: cut where long, with ? for bytes that not every terminal shows.
std::string excerpt(std::string_view word, std::size_t longest = 80);

/// A word in quotes as it can be shown in a message: cut where long, without bytes that no terminal shows.
std::string shown(std::string_view word);

/// Whether two words are the same but for capitals. `lower` is written without any.
bool is_word(std::string_view word, std::string_view lower);

}  // namespace fccda
