#include "raylab/base/command_line.h"

#include "catch.h"

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

TEST_CASE("an option without its value is refused by name") {
    CHECK_THROWS_WITH(parse(command_line, {"RANGE", "--seed"}),
                      "raylab measure: expected a value for --seed, found nothing");
}
