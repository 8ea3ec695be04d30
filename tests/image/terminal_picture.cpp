#include "catch.h"

#include "raylab/image/picture_files/files.h"
#include "raylab/image/picture_files/terminal_picture.h"

#include "raylab/base/base64.h"

using namespace raylab;

TEST_CASE("a terminal shows pictures as it announces, and none where it announces nothing") {
    using enum TerminalPictures;
    CHECK(terminal_pictures({.term = "xterm-kitty", .color_term = "truecolor"}) == kitty);
    CHECK(terminal_pictures({.term = "xterm-256color", .kitty_window = "3"}) == kitty);
    CHECK(terminal_pictures({.term = "xterm-256color", .term_program = "ghostty"}) == kitty);
    CHECK(terminal_pictures({.term = "xterm-256color", .term_program = "iTerm.app"}) == iterm);
    CHECK(terminal_pictures({.term = "xterm-256color", .term_program = "WezTerm"}) == iterm);
    CHECK(terminal_pictures({.term = "xterm-256color", .color_term = "truecolor"}) == half_blocks);
    CHECK(terminal_pictures({.term = "xterm-256color", .color_term = "24bit"}) == half_blocks);
    CHECK(terminal_pictures({.term = "xterm-256color"}) == none);
    CHECK(terminal_pictures({.color_term = "truecolor"}) == none);
    CHECK(terminal_pictures({.term = "dumb", .color_term = "truecolor"}) == none);
    CHECK(terminal_pictures({.term = "xterm-kitty", .no_color = "1"}) == none);
}

TEST_CASE("a multiplexer gets no pictures, but colours") {
    CHECK(terminal_pictures({.term = "tmux-256color", .color_term = "truecolor", .kitty_window = "3"}) ==
          TerminalPictures::half_blocks);
    CHECK(terminal_pictures({.term = "screen", .kitty_window = "3"}) == TerminalPictures::none);
}

TEST_CASE("half blocks show two pixels a character, the upper one in front, and means where the picture is too wide") {
    Image image(2, 3, {0, 0, 0});
    image.at(0, 0) = {1, 0, 0};
    image.at(0, 1) = {0, 1, 0};
    image.at(1, 2) = {0, 0, 1};
    const std::string black = "2;0;0;0m";
    CHECK(terminal_picture(image, TerminalPictures::half_blocks, 80) ==
          "\033[38;2;255;0;0m\033[48;2;0;255;0m▀\033[38;" + black + "\033[48;" + black + "▀\033[0m\n" +  //
              "\033[38;" + black + "\033[48;" + black + "▀\033[38;2;0;0;255m\033[48;2;0;0;255m▀\033[0m\n");
    CHECK(terminal_picture(Image(4, 4, {1, 1, 1}), TerminalPictures::half_blocks, 2) ==
          "\033[38;2;255;255;255m\033[48;2;255;255;255m▀\033[38;2;255;255;255m\033[48;2;255;255;255m▀\033[0m\n");
}

TEST_CASE("for kitty a PNG file comes in pieces of 4096 bytes, of which the last says that it is the last") {
    Image image(80, 80);
    for (int y = 0; y < 80; ++y)
        for (int x = 0; x < 80; ++x)  // so irregular that its file is long
            image.at(x, y) = {static_cast<float>(x * y % 97) / 97, static_cast<float>(x * x % 89) / 89, 0.5f};
    auto text = terminal_picture(image, TerminalPictures::kitty, 40);
    REQUIRE(text.starts_with("\033_Ga=T,f=100,q=2,c=40,m=1;"));
    std::string coded;
    std::size_t pieces = 0, last = 0;
    while (text.starts_with("\033_G")) {
        const auto data = text.find(';') + 1, end = text.find("\033\\");
        CHECK(end - data <= 4096);
        last += text.substr(0, data).ends_with("m=0;");
        coded += text.substr(data, end - data);
        text = text.substr(end + 2);
        ++pieces;
    }
    CHECK(text == "\n");
    CHECK(pieces > 1);
    CHECK(last == 1);
    CHECK(coded == base64(png_bytes(image)));
}

TEST_CASE("for iTerm2 a picture is one file in the line, and where nothing is shown there is no text") {
    const Image image(3, 2, {1, 0, 0});
    const auto bytes = png_bytes(image);
    CHECK(terminal_picture(image, TerminalPictures::iterm, 40) ==
          "\033]1337;File=inline=1;size=" + std::to_string(bytes.size()) + ";width=3:" + base64(bytes) + "\a\n");
    CHECK(terminal_picture(image, TerminalPictures::none, 40).empty());
}
