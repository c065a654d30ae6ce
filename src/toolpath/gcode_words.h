// The text of a G-code program cut into lines and words, without their meaning.
//
// Letters of either case, spaces anywhere, comments in parentheses and behind a semicolon. Numbers
// are decimal, without exponents. Throws GCodeError for characters that are no part of a word,
// letters without a number, parameters, expressions and O-word flow.
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

namespace evenload {

struct GCodeWord {
  char letter = 0;        // A to Z; a program number written with a colon counts as O
  double value = 0;       // finite
  std::string_view text;  // as written
};

struct GCodeBlock {
  enum class Kind { kWords, kPercent, kSetting };
  int line = 0;  // from 1
  Kind kind = Kind::kWords;
  bool optional = false;      // it begins with "/"
  bool open_comment = false;  // a comment that does not end on its line
  std::string_view text;      // of the line, without the spaces around it
  std::vector<GCodeWord> words;
};

class GCodeBlocks {
 public:
  // `text` must outlive the words made from it.
  explicit GCodeBlocks(std::string_view text);
  // The next line into `block`; false behind the last.
  bool next(GCodeBlock& block);
  // The same without looking at the line's words.
  bool skip(GCodeBlock& block);

 private:
  std::string_view rest_;
  int line_ = 0;
};

}  // namespace evenload
