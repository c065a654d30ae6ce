// One line of a G-code program: its words by letter, and what its codes ask for.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "toolpath/gcode.h"
#include "toolpath/gcode_words.h"

namespace evenload {

// Turns of one arc, repeats or pecks of one cycle: more is a slip of the pen, and would fill the
// memory.
inline constexpr int kMostRepeats = 1000;

inline std::string text_of(std::string_view text) { return std::string(text); }

// The words of one line, by letter, and which of them have been used.
class GCodeLine {
 public:
  explicit GCodeLine(const GCodeBlock& block) : block_(block) {
    for (std::size_t i = 0; i < block.words.size(); ++i) {
      const char letter = block.words[i].letter;
      if (letter == 'G' || letter == 'M') continue;
      const std::uint32_t bit = bit_of(letter);
      if (present_ & bit)
        throw GCodeError(block.line, std::string("the line has two words ") + letter +
                                         ": take one of them out.");
      present_ |= bit;
      index_[letter - 'A'] = static_cast<std::uint32_t>(i);
    }
  }

  int line() const { return block_.line; }
  [[noreturn]] void fail(const std::string& sentence) const {
    throw GCodeError(block_.line, sentence);
  }
  bool has(char letter) const { return (present_ & bit_of(letter)) != 0; }
  bool has_any(std::string_view letters) const {
    for (const char letter : letters)
      if (has(letter)) return true;
    return false;
  }
  bool has_axes() const { return has_any("XYZ"); }
  const GCodeWord& word(char letter) const { return block_.words[index_[letter - 'A']]; }
  double take(char letter) {
    used_ |= bit_of(letter);
    return word(letter).value;
  }
  double take_not_negative(char letter) {
    const double value = take(letter);
    if (value < 0) fail(text_of(word(letter).text) + " is below zero.");
    return value;
  }
  void ignore(std::string_view letters) {
    for (const char letter : letters) used_ |= bit_of(letter);
  }
  // A whole number from `low` to kMostRepeats, or `otherwise` without the word.
  int take_count(char letter, int low, int otherwise) {
    if (!has(letter)) return otherwise;
    const double value = take(letter);
    if (value != std::floor(value) || value < low || value > kMostRepeats)
      fail(text_of(word(letter).text) + " must be a whole number from " + std::to_string(low) +
           " to " + std::to_string(kMostRepeats) + ".");
    return static_cast<int>(value);
  }
  // The words that nothing has used, with spaces between them; they count as used then.
  std::string take_the_rest() {
    std::string rest;
    for (const GCodeWord& word : block_.words) {
      if (word.letter == 'G' || word.letter == 'M' || (used_ & bit_of(word.letter))) continue;
      if (!rest.empty()) rest += ' ';
      rest += text_of(word.text);
    }
    used_ = present_;
    return rest;
  }
  bool all_used() const { return (present_ & ~used_) == 0; }
  const std::vector<GCodeWord>& words() const { return block_.words; }

 private:
  static std::uint32_t bit_of(char letter) { return 1U << (letter - 'A'); }

  const GCodeBlock& block_;
  std::array<std::uint32_t, 26> index_{};
  std::uint32_t present_ = 0, used_ = 0;
};

// What the G and M codes of one line ask for besides the modes they set.
struct GCodeLineCodes {
  int motion = -1;     // tenths
  int non_modal = -1;  // tenths
  bool ends_cycle = false;
  int stop = -1;    // tenths
  int spindle = 0;  // M3, M4, M5
  bool tool_change = false;
  bool changes_units = false;
  std::string unknown;          // the texts of the codes without a meaning here
  bool unknown_g = false;       // one of them is a G code ...
  bool unknown_moves = false;   // ... that may move the tool ...
  bool unknown_motion = false;  // ... and does so on the lines after it too
};

}  // namespace evenload
