#include "catch.h"

#include "raylab/base/process.h"

#include <set>
#include <sstream>
#include <string>

// What a program leaves behind at the project's top level (a profile, a picture) is easily committed with the rest. Git
// is asked, since a student's own files may lie there.

TEST_CASE("nothing is committed at the project's top level but what belongs there") {
    const std::set<std::string> known{".ci",
                                      ".clang-format",
                                      ".devcontainer",
                                      ".git-blame-ignore-revs",
                                      ".gitignore",
                                      "CMakeLists.txt",
                                      "CMakePresets.json",
                                      "CONTRIBUTING.md",
                                      "LICENSE",
                                      "README.md",
                                      "chapters",
                                      "cmake",
                                      "exercises",
                                      "lib",
                                      "raylab",
                                      "reference_images",
                                      "slurm",
                                      "tests"};
    const auto listed = raylab::run_process("git", {"-C", RAYLAB_SOURCE, "ls-files"});
    if (!listed.succeeded()) {
        WARN("skipped: this is no git repository");
        return;
    }
    std::set<std::string> committed;
    std::istringstream files(listed.output);
    for (std::string file; std::getline(files, file);) committed.insert(file.substr(0, file.find('/')));
    for (const std::string& name : committed)
        if (!known.contains(name))
            FAIL_CHECK(name << " was added at the project's top level: take it out, or add it to this test's list");
    for (const std::string& name : known)
        if (!committed.contains(name)) FAIL_CHECK(name << " is missing at the project's top level");
}
