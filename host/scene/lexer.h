// SPDX-License-Identifier: Apache-2.0
// Cuts scene text into words, quoted strings and brackets.
#pragma once

#include <string>
#include <string_view>

#include "scene/source.h"

namespace lobe {

enum class TokenKind { end, word, quoted, open, close };

struct Token {
    TokenKind kind = TokenKind::end;
    std::string_view text;  // a quoted string without its quotes, escapes untouched
    Place place;
};

class Lexer {
  public:
    explicit Lexer(const SourceFile& file, std::size_t offset = 0) : file_(file), at_(offset) {}

    // The next token; `end` for ever at the end. Throws Error (scene) for an unterminated string.
    Token next();
    // The next token, which stays the next.
    const Token& peek();

  private:
    Token scan();
    void skip_blanks();
    Token quoted();

    const SourceFile& file_;
    std::size_t at_;
    Token ahead_;
    bool has_ahead_ = false;
};

// The characters a quoted string stands for (\n, \t, \", \\ ... as in C; others stay as they are).
std::string unescape(std::string_view text);

}  // namespace lobe
