#include "without_comments.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

namespace raylab::grading {

namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

// What names and numbers consist of; bytes beyond ASCII are of names.
bool is_of_word(char c) {
    return is_digit(c) || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || (c & 0x80) != 0;
}

class CommentRemover {
public:
    explicit CommentRemover(std::string_view text) : text_(text) {}

    std::string result() && {
        while (at_ < text_.size())
            if (const auto joined = splice_at(at_))
                at_ += joined;
            else
                read(text_[at_++]);
        return std::move(result_);
    }

private:
    enum class Within { code, line_comment, comment, string, character };

    // The length of a backslash with the end of its line; compilers take one with blanks between them, too.
    std::size_t splice_at(std::size_t at) const {
        if (at >= text_.size() || text_[at] != '\\') return 0;
        const auto end = text_.find_first_not_of(" \t\r\f\v", at + 1);
        return end != text_.npos && text_[end] == '\n' ? end + 1 - at : 0;
    }

    bool word_goes_on() const {
        auto next = at_;
        while (const auto joined = splice_at(next)) next += joined;
        return next < text_.size() && is_of_word(text_[next]);
    }

    void read(char c) {
        switch (within_) {
            case Within::code:
                return read_code(c);
            case Within::line_comment:
                if (c == '\n') result_ += c, begin(Within::code);
                return;
            case Within::comment:
                if (c == '/' && before_ == '*') return begin(Within::code);
                before_ = c;
                return;
            case Within::string:
                return read_literal(c, '"');
            case Within::character:
                return read_literal(c, '\'');
        }
    }

    void read_code(char c) {
        if (before_ == '/' && (c == '/' || c == '*')) {
            result_.back() = ' ';
            return begin(c == '/' ? Within::line_comment : Within::comment);
        }
        if (c == '"' && is_behind_raw_prefix() && take_raw_string()) return;
        result_ += c;
        const bool separates_digits = c == '\'' && word_ == Word::number && word_goes_on();
        if (c == '"') return begin(Within::string);
        if (c == '\'' && !separates_digits) return begin(Within::character);
        before_ = c;
        if (separates_digits || (c == '.' && word_ == Word::number)) return;
        if (!is_of_word(c)) {
            word_ = Word::none;
        } else if (word_ == Word::none) {
            word_ = is_digit(c) ? Word::number : Word::name;
            word_begin_ = result_.size() - 1;
        }
    }

    // A literal ends with its line at the latest: the ' of "don't" in an #error begins none that goes on.
    void read_literal(char c, char quote) {
        result_ += c;
        const bool is_escaped = before_ == '\\';
        if (c == '\n' || (c == quote && !is_escaped)) return begin(Within::code);
        before_ = is_escaped ? '\0' : c;
    }

    bool is_behind_raw_prefix() const {
        constexpr std::array<std::string_view, 5> prefixes{"R", "u8R", "uR", "UR", "LR"};
        if (word_ != Word::name || result_.size() - word_begin_ > 3) return false;
        return std::ranges::find(prefixes, std::string_view(result_).substr(word_begin_)) != prefixes.end();
    }

    // From its first quote to the first `)delimiter"`, without joining lines. It takes none where there is no such end,
    // or the delimiter is none: that does not compile. What is in it stays, since compilers disagree about one in a
    // directive: some begin to read code again where its line ends.
    bool take_raw_string() {
        constexpr std::size_t longest_delimiter = 16;
        const auto length = text_.substr(at_, longest_delimiter + 1).find('(');
        if (length == text_.npos || !raw_strings_end_) return false;
        const auto delimiter = text_.substr(at_, length);
        if (delimiter.find_first_of(" )\\\t\v\f\r\n\"") != text_.npos) return false;
        const auto close = ")" + std::string(delimiter) + "\"";
        const auto end = text_.find(close, at_ + length);
        raw_strings_end_ = end != text_.npos;  // or else the rest would be searched again and again
        if (!raw_strings_end_) return false;
        result_ += text_.substr(at_ - 1, end + close.size() - (at_ - 1));
        at_ = end + close.size();
        begin(Within::code);
        return true;
    }

    void begin(Within within) {
        within_ = within;
        before_ = '\0';
        word_ = Word::none;
    }

    enum class Word { none, name, number };

    std::string_view text_;
    std::size_t at_ = 0;
    std::string result_;
    Within within_ = Within::code;
    char before_ = '\0';          // the character before, of the same comment, literal or code
    Word word_ = Word::none;      // what the result ends in
    std::size_t word_begin_ = 0;  // where that stands
    bool raw_strings_end_ = true;
};

}  // namespace

std::string without_comments(const std::string& text) { return CommentRemover(text).result(); }

}  // namespace raylab::grading
