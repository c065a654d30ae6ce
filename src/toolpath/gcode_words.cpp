#include "toolpath/gcode_words.h"

#include <array>
#include <charconv>
#include <cmath>
#include <string>
#include <system_error>

#include "toolpath/gcode.h"

namespace evenload {
namespace {

// No axis, feed or speed comes near it, and sums and squares of such numbers stay finite.
constexpr double kLargestNumber = 1e9;

bool is_space(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_letter(char c) { return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z'); }
char upper(char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; }

std::string shown(char c) {
  if (c > ' ' && c <= '~') return std::string("'") + c + "'";
  constexpr char kHex[] = "0123456789ABCDEF";
  const auto byte = static_cast<unsigned char>(c);
  return std::string("with the code 0x") + kHex[byte / 16] + kHex[byte % 16];
}

class WordReader {
 public:
  explicit WordReader(GCodeBlock& block) : text_(block.text), block_(block) {}

  void read() {
    skip_spaces();
    if (peek() == '/') {
      block_.optional = true;
      ++at_;
      if (is_digit(peek())) ++at_;  // the number of the switch
    }
    while (skip_spaces_and_comments()) {
      const char c = peek();
      if (is_letter(c)) {
        word(upper(c));
      } else if (c == ':') {
        word('O');
      } else if (c == '#' || c == '[') {
        fail_on_parameters();
      } else {
        fail("the character " + shown(c) + " is no part of a G-code word: take it out.");
      }
    }
  }

 private:
  [[noreturn]] void fail(const std::string& sentence) const {
    throw GCodeError(block_.line, sentence);
  }
  [[noreturn]] void fail_on_parameters() const {
    fail("parameters and expressions cannot be run: post the program with plain numbers.");
  }
  char peek() const { return at_ < text_.size() ? text_[at_] : '\0'; }
  bool ended() const { return at_ >= text_.size(); }
  void skip_spaces() {
    while (!ended() && is_space(text_[at_])) ++at_;
  }
  // False at the line's end.
  bool skip_spaces_and_comments() {
    while (true) {
      skip_spaces();
      if (ended() || peek() == ';') return false;
      if (peek() != '(') return true;
      const std::size_t end = text_.find(')', at_);
      if (end == std::string_view::npos) {
        block_.open_comment = true;
        return false;
      }
      at_ = end + 1;
    }
  }

  void word(char letter) {
    const std::size_t begin = at_++;
    skip_spaces();
    if (peek() == '#' || peek() == '[') fail_on_parameters();
    if (letter == 'O' && (is_letter(peek()) || peek() == '<')) fail_on_flow();
    const double value = number(letter);
    block_.words.push_back({letter, value, text_.substr(begin, end_of_number_ - begin)});
    if (letter == 'O' && at_ + 1 < text_.size() && is_letter(text_[at_]) &&
        is_letter(text_[at_ + 1]))
      fail_on_flow();
  }
  [[noreturn]] void fail_on_flow() const {
    fail("O words that call, repeat or choose cannot be run: post the program without them.");
  }

  double number(char letter) {
    bool digits = false, point = false, split = false;
    const std::size_t begin = at_;
    if (peek() == '+' || peek() == '-') ++at_;
    end_of_number_ = at_;
    while (!ended()) {
      const char c = text_[at_];
      if (is_space(c)) {
        ++at_;
        continue;
      }
      if (c != '.' && !is_digit(c)) break;
      if (c == '.' && point)
        fail("the number of " + std::string(1, letter) + " has two decimal points.");
      if (end_of_number_ != at_) split = true;
      (c == '.' ? point : digits) = true;
      end_of_number_ = ++at_;
    }
    if (!digits)
      fail(std::string(1, letter) + " has no number behind it: write it as in " + letter + "1.5.");
    // Behind a space it is a word of its own.
    if (end_of_number_ == at_ && upper(peek()) == 'E' && at_ + 1 < text_.size() &&
        (is_digit(text_[at_ + 1]) || text_[at_ + 1] == '-' || text_[at_ + 1] == '+'))
      fail("the number of " + std::string(1, letter) +
           " has an exponent, which no controller reads: write it as a plain decimal.");
    std::string_view raw = text_.substr(begin, end_of_number_ - begin);
    std::string joined;
    if (split) {
      for (const char c : raw)
        if (!is_space(c)) joined += c;
      raw = joined;
    }
    if (raw.front() == '+') raw.remove_prefix(1);
    double value = 0;
    const std::from_chars_result result =
        std::from_chars(raw.data(), raw.data() + raw.size(), value, std::chars_format::fixed);
    if (result.ec != std::errc() || !(std::abs(value) <= kLargestNumber))
      fail("the number of " + std::string(1, letter) + " is beyond what can be computed with.");
    return value;
  }

  std::string_view text_;
  GCodeBlock& block_;
  std::size_t at_ = 0;
  std::size_t end_of_number_ = 0;
};

}  // namespace

GCodeBlocks::GCodeBlocks(std::string_view text) : rest_(text) {
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  if (rest_.substr(0, kByteOrderMark.size()) == kByteOrderMark)
    rest_.remove_prefix(kByteOrderMark.size());
}

bool GCodeBlocks::skip(GCodeBlock& block) {
  if (rest_.empty()) return false;
  const std::size_t end = rest_.find_first_of("\r\n");
  std::string_view text = rest_.substr(0, end);
  if (end == std::string_view::npos) {
    rest_ = {};
  } else {
    const bool pair = rest_[end] == '\r' && end + 1 < rest_.size() && rest_[end + 1] == '\n';
    rest_.remove_prefix(end + (pair ? 2 : 1));
  }
  while (!text.empty() && is_space(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_space(text.back())) text.remove_suffix(1);
  block.line = ++line_;
  block.text = text;
  block.kind = GCodeBlock::Kind::kWords;
  if (!text.empty() && text.front() == '%') block.kind = GCodeBlock::Kind::kPercent;
  if (!text.empty() && text.front() == '$') block.kind = GCodeBlock::Kind::kSetting;
  block.optional = block.open_comment = false;
  block.words.clear();
  return true;
}

bool GCodeBlocks::next(GCodeBlock& block) {
  if (!skip(block)) return false;
  if (block.kind == GCodeBlock::Kind::kWords) WordReader(block).read();
  return true;
}

}  // namespace evenload
