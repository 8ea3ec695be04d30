#include "streams/program.h"

#include "catch.h"

// Messages that tell the name that was meant.

using namespace raylab;

TEST_CASE("a name with a slip or in other letters is met with the one that was meant") {
    const auto meant = [](const std::string& name) { return "(did you mean \"" + name + "\"?)"; };
    check_could_not(in_shell({"Rendr"}), meant("render"));
    check_could_not(in_shell({"render", still_life, "--sampels", "2", "-o", "a.png"}), meant("--samples"));
    check_could_not(in_shell({"chart", "ray_triangel"}), meant("ray_triangle"));
    check_could_not(in_shell({"chapter", "recursoin"}), meant("recursion"));
    check_could_not(in_shell({"chapter", "07", "--case", "tir-edge"}), meant("TIR-EDGE"));
    check_could_not(in_shell({"stability", "edge-shot"}), meant("EDGE-SHOT"));
    check_could_not(in_shell({"check", "ray_sphear"}), meant("ray_sphere"));
    check_could_not(in_shell({"needs", still_life, "more"}), "expected no more words, found \"more\"");
}

TEST_CASE("a chapter is found by its name in any letter case") {
    CHECK(in_shell({"chapter", "Recursion", "--list"}).output == in_shell({"chapter", "07", "--list"}).output);
}
