#include "catch.h"
#include "streams/program.h"

#include "raylab/base/file.h"

#include <algorithm>

using namespace raylab;

namespace {

// A name that turns the screen red, overwrites the line, writes from right to left, and is not UTF-8.
const std::string hostile = "a\x1b[31m\rb\nc\u202ed\u2066e\u009b\x7f\xff";
const std::string shown = "a\\u{1b}[31m\\u{d}b\\u{a}c\\u{202e}d\\u{2066}e\\u{9b}\\u{7f}\\xff";

// Whether a text has only bytes that are allowed in text for people: newlines, printable characters, and UTF-8.
bool is_plain(const std::string& text) {
    return std::ranges::none_of(text, [](unsigned char c) { return (c < 0x20 && c != '\n') || c == 0x7f; }) &&
           text.find("\u202e") == std::string::npos && text.find("\u009b") == std::string::npos;
}

}  // namespace

TEST_CASE("every command that reads a file shows a hostile name of it by numbers, on one line") {
    for (const std::vector<std::string>& words :
         std::vector<std::vector<std::string>>{{"render", hostile + ".toml", "-o", "x.png"},
                                               {"needs", hostile + ".toml"},
                                               {"tree", hostile + ".toml", "--pixel", "1,1", "-o", "x.svg"},
                                               {"export", hostile + ".toml", "-o", "x.pov"},
                                               {"compare", hostile, hostile},
                                               {"trace", hostile + ".off", "--rays", hostile, "-o", "x"},
                                               {"bench", "--meshes", hostile + ".off"},
                                               {"chapter", hostile},
                                               {"chart", hostile},
                                               {"stability", hostile},
                                               {"stability", "accelerators", "--replay", hostile},
                                               {"tour", "--seed", hostile},
                                               {"check", "01", "--answer", hostile},
                                               {"check", hostile},
                                               {hostile}}) {
        INFO(words[0]);
        const auto result = in_shell(words);
        check_could_not(result, shown);
        CHECK(is_plain(result.errors));
        CHECK(is_plain(result.output));
    }
}

TEST_CASE("names in a scene do not reach the terminal as they are, nor break its lines") {
    const auto scene = streams_folder / "hostile.toml";
    const std::string name = "\"gl\\u001b[31m\\n\\u202eass\"";
    const std::string text =
        "raylab = 1\n[camera]\nposition = [0, 0, 5]\ntarget = [0, 0, 0]\nup = [0, 1, 0]\nfov_y = 40\n"
        "[[light]]\ntype = \"point\"\nposition = [0, 5, 5]\ncolor = [1, 1, 1]\n"
        "[material." +
        name +
        "]\ndiffuse = [0.1, 0.1, 0.1]\nkr = 0.2\nkt = 0.7\nior = 1.5\n"
        "[[shape]]\ntype = \"sphere\"\ncenter = [0, 0, 0]\nradius = 1\nmaterial = " +
        name + "\n";
    write_file(scene, text);
    for (const std::vector<std::string>& words :
         std::vector<std::vector<std::string>>{{"needs", scene},
                                               {"radiosity", scene, "--patches", "50"},
                                               {"tree", scene, "--pixel", "320,240", "-o", "x.svg"},
                                               {"export", scene, "-o", "x.pov"}}) {
        INFO(words[0]);
        const auto result = in_shell(words);
        CHECK(result.code == 0);
        CHECK(is_plain(result.output + result.errors));
        CHECK_THAT(result.output, !Catch::Contains("31m\n"));
    }
}

TEST_CASE("what a tree's file holds does not reach the terminal as it is, nor breaks its lines") {
    const auto ours = streams_folder / "ours.json", theirs = streams_folder / "theirs.json";
    REQUIRE(in_shell({"tree", still_life, "--pixel", "300,250", "-o", ours}).code == 0);
    auto text = read_file(ours);
    const auto at = text.find("sphere ");
    REQUIRE(at != std::string::npos);
    write_file(theirs, text.replace(at, 6, "\\u001b[31m\\n\\u202ered"));
    const auto result = in_shell({"tree", ours, "--against", theirs});
    CHECK(result.code == 1);
    CHECK(is_plain(result.output));
    CHECK_THAT(result.output, Catch::Contains("\\u{1b}[31m\\u{a}\\u{202e}red"));
}

TEST_CASE("a message about an output names it, not the temporary beside it") {
    for (const auto& [file, words] : std::vector<std::pair<std::string, std::vector<std::string>>>{
             {"f.png", {"render", still_life, "--size", "64x64", "-o"}},
             {"f.exr", {"render", still_life, "--size", "64x64", "-o"}},
             {"f.svg", {"tree", still_life, "--pixel", "300,250", "-o"}},
             {"f.pov", {"export", still_life, "-o"}},
             {"f.json", {"needs", still_life, "--json"}}}) {
        INFO(file);
        auto all = words;
        all.push_back("some/folder/" + file);
        const auto result = in_shell(all, {.prefix = "trap '' XFSZ; ulimit -f 0;"});
        check_could_not(result, "some/folder/" + file + ": expected ");
        CHECK_THAT(result.errors, !Catch::Contains("/."));
    }
}

TEST_CASE("a size or a pixel is digits, and nothing around them") {
    for (const auto* size : {" 8x8", "8x8 ", "+8x8", "8x 8", "8 x8", "08x8 ", "8x8\n", "0x8", "-8x8", "99999x1"}) {
        INFO(size);
        check_could_not(in_shell({"render", still_life, "-o", "x.png", "--size", size}), "expected ");
    }
    for (const auto* pixel : {" 1,1", "1,1 ", "+1,1", "1, 1", "-1,1"}) {
        INFO(pixel);
        check_could_not(in_shell({"tree", still_life, "-o", "x.svg", "--pixel", pixel}), "expected --pixel X,Y inside");
    }
}
