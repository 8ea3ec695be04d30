#include "raylab/base/printable.h"

#include "catch.h"

using namespace raylab;

TEST_CASE("text without control characters is shown as it is") {
    for (const std::string text :
         {"", "a plain name.toml", "Müller, 中文, 🐘 \\u{7}", "no-break\u00a0space, \u2027, \u2065"})
        CHECK(printable(text) == text);
}

TEST_CASE("control characters are shown by their number: C0, DEL, C1") {
    CHECK(printable("a\nb\tc\x1b[2J") == "a\\u{a}b\\u{9}c\\u{1b}[2J");
    CHECK(printable(std::string_view("\0", 1)) == "\\u{0}");
    CHECK(printable("\x7f") == "\\u{7f}");
    CHECK(printable("\u0080\u009b\u009f\u00a0") == "\\u{80}\\u{9b}\\u{9f}\u00a0");
}

TEST_CASE("what breaks lines or turns the direction of writing is shown by its number") {
    CHECK(printable("\u2028\u2029") == "\\u{2028}\\u{2029}");
    CHECK(printable("\u202a\u202b\u202c\u202d\u202e") == "\\u{202a}\\u{202b}\\u{202c}\\u{202d}\\u{202e}");
    CHECK(printable("\u2066\u2067\u2068\u2069") == "\\u{2066}\\u{2067}\\u{2068}\\u{2069}");
    CHECK(printable("\u200e\u200f\u061c") == "\\u{200e}\\u{200f}\\u{61c}");
}

TEST_CASE("each byte that is not UTF-8 is shown: lone, cut short, overlong, a surrogate, beyond Unicode") {
    CHECK(printable("a\xff"
                    "b\x80") == "a\\xffb\\x80");
    CHECK(printable("\xe2\x80") == "\\xe2\\x80");
    CHECK(printable("\xc3(") == "\\xc3(");
    CHECK(printable("\xc0\x8a") == "\\xc0\\x8a");
    CHECK(printable("\xe0\x80\x8a") == "\\xe0\\x80\\x8a");
    CHECK(printable("\xf0\x80\x80\x8a") == "\\xf0\\x80\\x80\\x8a");
    CHECK(printable("\xed\xa0\x80") == "\\xed\\xa0\\x80");
    CHECK(printable("\xf4\x90\x80\x80") == "\\xf4\\x90\\x80\\x80");
    CHECK(printable("\xf4\x8f\xbf\xbf") == "\xf4\x8f\xbf\xbf");
}

TEST_CASE("of several lines the newlines and tabs stay") { CHECK(printable_lines("a\n\tb\r\n") == "a\n\tb\\u{d}\n"); }

TEST_CASE("what another program printed becomes a part of one line") {
    CHECK(on_one_line("\n  line 0:\n\tno such thing \n") == "line 0: no such thing");
}
