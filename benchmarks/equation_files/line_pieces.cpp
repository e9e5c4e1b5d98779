// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/equation_files/line_pieces.hpp"

#include <cstddef>

namespace fde::bench {
namespace {

bool continues_character(char c) { return (static_cast<unsigned char>(c) & 0xc0U) == 0x80U; }

// The characters of a file, with their positions.
class FileCursor {
 public:
  FileCursor(std::string_view text, int line) : text_(text), position_{line, 1} {
    constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
    if (is_at(byte_order_mark)) text_.remove_prefix(byte_order_mark.size());
  }

  [[nodiscard]] TextPosition position() const { return position_; }
  [[nodiscard]] bool is_at(std::string_view expected) const { return text_.starts_with(expected); }
  [[nodiscard]] char at(std::size_t place) const { return place < text_.size() ? text_[place] : '\0'; }

  // Passes a character of the file.
  void advance() {
    if (text_.empty()) return;
    position_ = is_at("\n") ? TextPosition{position_.line + 1, 1}
                            : TextPosition{position_.line, position_.column + 1};
    do {
      text_.remove_prefix(1);
    } while (continues_character(at(0)));
  }
  void advance(std::size_t characters) {
    for (std::size_t i = 0; i < characters; ++i) advance();
  }
  void skip_blanks() {
    while (is_at(" ") || is_at("\t") || is_at("\r") || is_at("\n")) advance();
  }

 private:
  std::string_view text_;
  TextPosition position_;
};

// Passes escapes that stand for nothing: a backslash at the end of a line.
void skip_line_ends(FileCursor& cursor) {
  while (cursor.is_at("\\") &&
         (cursor.at(1) == ' ' || cursor.at(1) == '\t' || cursor.at(1) == '\r' || cursor.at(1) == '\n')) {
    cursor.advance();
    cursor.skip_blanks();
  }
}

// The characters of an escape in the file: \n, \u002d, \U0000002d.
std::size_t length_of_escape(const FileCursor& cursor) {
  return cursor.at(1) == 'u' ? 6 : cursor.at(1) == 'U' ? 10 : 2;
}

}  // namespace

std::vector<LinePiece> line_pieces(std::string_view lines, TextPosition opening, std::string_view value) {
  FileCursor cursor(lines, opening.line);
  for (int column = 1; column < opening.column; ++column) cursor.advance();
  const bool is_basic = cursor.is_at("\"");
  const bool has_lines = cursor.is_at(R"(""")") || cursor.is_at("'''");
  cursor.advance(has_lines ? 3 : 1);
  if (has_lines && cursor.is_at("\r\n")) cursor.advance();
  if (has_lines && cursor.is_at("\n")) cursor.advance();
  std::vector<LinePiece> pieces;
  for (std::size_t byte = 0; byte < value.size();) {
    if (is_basic) skip_line_ends(cursor);
    if (cursor.is_at("\r\n") && value[byte] == '\n') cursor.advance();
    const auto place = cursor.position();
    const bool is_beside =
        !pieces.empty() && pieces.back().position.line == place.line &&
        pieces.back().position.column + static_cast<int>(byte - pieces.back().first) == place.column;
    if (!is_beside) pieces.push_back({byte, place});
    cursor.advance(is_basic && cursor.is_at("\\") ? length_of_escape(cursor) : 1);
    do {
      ++byte;
    } while (byte < value.size() && continues_character(value[byte]));
  }
  return pieces;
}

}  // namespace fde::bench
