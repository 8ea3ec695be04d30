#include "raylab/base/command_line.h"

#include "catch.h"

#include "raylab/base/common_options.h"
#include "raylab/base/error.h"

using namespace raylab;

namespace {

const CommandLine command_line{.program = "raylab measure",
                               .about = "",
                               .positionals = {{"CASE", "", Positional::Count::any}},
                               .options = {{"--seed", "S", "", "1"}, {"--only", "NAME", "", "", Option::Repeat::all}}};

using Words = std::vector<std::string>;

}  // namespace

TEST_CASE("an option takes one word, and what follows is a positional") {
    const Arguments arguments = parse(command_line, {"--seed", "2", "EDGE-SHOT", "--only", "a", "RANGE"});
    CHECK(arguments.text("--seed") == "2");
    CHECK(arguments.all("--only") == Words{"a"});
    CHECK(arguments.all("CASE") == Words{"EDGE-SHOT", "RANGE"});
}

TEST_CASE("of an option given again the last counts, or all where it says so") {
    const Arguments arguments = parse(command_line, {"--seed", "2", "--only", "a", "--seed", "3", "--only", "b"});
    CHECK(arguments.integer("--seed", 0, 9) == 3);
    CHECK(arguments.all("--only") == Words{"a", "b"});
}

TEST_CASE("two numbers with a separator are digits alone, and nothing stands around them") {
    CHECK(two_integers("640x480", 'x') == std::array{640, 480});
    CHECK(two_integers("0,07", ',') == std::array{0, 7});
    for (const auto* text : {" 8x8", "8x8 ", "8 x8", "8x 8", "+8x8", "8x+8", "-8x8", "8x-8", "8x", "x8", "x", "", "8",
                             "8x8x8", "8,8", "8x0x10", "8.0x8", "99999999999x1", "8x8\n"}) {
        INFO(text);
        CHECK_FALSE(two_integers(text, 'x'));
    }
}

TEST_CASE("an option without its value is refused by name") {
    CHECK_THROWS_WITH(parse(command_line, {"RANGE", "--seed"}),
                      "raylab measure: expected a value for --seed, found nothing");
}

TEST_CASE("threads and seeds are read in one way: 0 threads are all cores, and a seed is one that JSON keeps") {
    const CommandLine both{
        .program = "raylab measure", .about = "", .options = {threads_option(), {"--seed", "S", "", ""}}};
    CHECK(threads_of(parse(both, {})) == 0);
    CHECK(threads_of(parse(both, {"--threads", "3"})) == 3);
    CHECK_THROWS_AS(threads_of(parse(both, {"--threads", "-1"})), Error);
    CHECK_FALSE(seed_if_given(parse(both, {})));
    CHECK(seed_if_given(parse(both, {"--seed", "9007199254740991"})) == largest_seed);
    CHECK_THROWS_AS(seed_if_given(parse(both, {"--seed", "9007199254740992"})), Error);
}
