#include "raylab/base/nearest_name.h"

#include "raylab/base/numbered_name.h"

#include "catch.h"

#include <vector>

using namespace raylab;

namespace {

const std::vector<std::string> cases{"EDGE-SHOT", "TIR-EDGE", "SKEW-HIT"}, chapters{"02_spheres", "07_recursion"};

}  // namespace

TEST_CASE("a name with a slip is met with the one that was meant, in any letter case") {
    CHECK(with_suggestion("EDGE-SHOOT", cases) == "\"EDGE-SHOOT\" (did you mean \"EDGE-SHOT\"?)");
    CHECK(with_suggestion("edge-shot", cases) == "\"edge-shot\" (did you mean \"EDGE-SHOT\"?)");
    CHECK(with_suggestion("Tri-Edge", cases) == "\"Tri-Edge\" (did you mean \"TIR-EDGE\"?)");
    CHECK(with_suggestion("WOBBLE", cases) == "\"WOBBLE\"");
    CHECK(with_suggestion("EDGE", {}) == "\"EDGE\"");
}

TEST_CASE("a folder is meant by its number, its name, or both") {
    for (const auto* word : {"7", "07", "007", "recursion", "Recursion", "07_recursion", "07_RECURSION"})
        CHECK(means_folder(word, "07_recursion"));
    CHECK(means_folder("7b", "07b_trace"));
    for (const auto* word : {"", "0", "70", "07b", "recurs", "_recursion", "02"})
        CHECK_FALSE(means_folder(word, "07_recursion"));
}

TEST_CASE("a slip in a folder's name is found with its number and without") {
    CHECK(with_suggested_folder("recursoin", chapters) == "\"recursoin\" (did you mean \"recursion\"?)");
    CHECK(with_suggested_folder("07_recursio", chapters) == "\"07_recursio\" (did you mean \"07_recursion\"?)");
    CHECK(with_suggested_folder("77", chapters) == "\"77\"");
}
