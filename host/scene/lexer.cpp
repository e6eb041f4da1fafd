// SPDX-License-Identifier: Apache-2.0
#include "scene/lexer.h"

#include <algorithm>

namespace lobe {

namespace {

bool is_blank(char c) {
    return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f' || c == '\v';
}
bool ends_word(char c) { return is_blank(c) || c == '"' || c == '[' || c == ']' || c == '#'; }

}  // namespace

Token Lexer::next() {
    if (!has_ahead_) return scan();
    has_ahead_ = false;
    return ahead_;
}

const Token& Lexer::peek() {
    if (!has_ahead_) ahead_ = scan();
    has_ahead_ = true;
    return ahead_;
}

void Lexer::skip_blanks() {
    const std::string& text = file_.text;
    while (at_ < text.size()) {
        if (is_blank(text[at_])) {
            ++at_;
        } else if (text[at_] == '#') {
            at_ = std::min(text.find('\n', at_), text.size());
        } else {
            return;
        }
    }
}

Token Lexer::scan() {
    skip_blanks();
    const std::string_view text = file_.text;
    const Place place{&file_, at_};
    if (at_ >= text.size()) return {TokenKind::end, {}, place};
    if (text[at_] == '"') return quoted();
    if (text[at_] == '[') return {TokenKind::open, text.substr(at_++, 1), place};
    if (text[at_] == ']') return {TokenKind::close, text.substr(at_++, 1), place};
    const std::size_t begin = at_;
    while (at_ < text.size() && !ends_word(text[at_])) ++at_;
    return {TokenKind::word, text.substr(begin, at_ - begin), place};
}

Token Lexer::quoted() {
    const std::string_view text = file_.text;
    const Place place{&file_, at_};
    const std::size_t begin = ++at_;
    for (; at_ < text.size() && text[at_] != '\n'; ++at_) {
        if (text[at_] == '"') return {TokenKind::quoted, text.substr(begin, at_++ - begin), place};
        if (text[at_] == '\\' && at_ + 1 < text.size() && text[at_ + 1] != '\n') ++at_;
    }
    fail(place, "a string that does not end on its line", "close it with \"");
}

std::string unescape(std::string_view text) {
    std::string out;
    out.reserve(text.size());
    static const std::string_view letters = "nrtbf\\\"'", meanings = "\n\r\t\b\f\\\"'";
    for (std::size_t i = 0; i < text.size(); ++i) {
        const std::size_t known = text[i] == '\\' && i + 1 < text.size() ? letters.find(text[i + 1])
                                                                         : std::string_view::npos;
        if (known == std::string_view::npos) {
            out += text[i];
        } else {
            out += meanings[known];
            ++i;
        }
    }
    return out;
}

}  // namespace lobe
