#include "raylab/base/outputs.h"

#include "base/device.h"
#include "base/names_in.h"
#include "catch.h"

#include "raylab/base/error.h"
#include "raylab/base/file.h"

#include <sys/stat.h>
#include <unistd.h>

#include <set>

using namespace raylab;
using raylab::test::names_in;
namespace fs = std::filesystem;

namespace {

std::string refusal(const Outputs::Plan& plan) {
    try {
        const Outputs outputs(plan);
    } catch (const Error& error) {
        return error.what();
    }
    return "nothing: all was accepted";
}

}  // namespace

TEST_CASE("a name of 255 bytes can be written, one of 256 is refused before any work") {
    const ScratchFolder scratch;
    const std::string name(251, 'x');
    write_file(scratch.path() / (name + ".png"), "long");
    CHECK(read_file(scratch.path() / (name + ".png")) == "long");
    CHECK_THAT(refusal({.files = {scratch.path() / "new" / (name + "y.png")}}),
               Catch::Matchers::Contains("names of at most 255 bytes"));
}

TEST_CASE("outputs that cannot be written are refused, each in a line that names it") {
    const ScratchFolder scratch;
    const auto folder = scratch.path();
    write_file(folder / "file", "");
    const std::vector<std::pair<fs::path, std::string>> expected = {
        {"", "found none"},
        {folder, "found a folder"},
        {folder / "file/below", "which is none"},
        {folder / "new/", "found a folder's"},
    };
    for (const auto& [path, fragment] : expected) {
        INFO(path);
        CHECK_THAT(refusal({.files = {path}}),
                   Catch::Matchers::StartsWith(path.string() + ": expected") && Catch::Matchers::Contains(fragment));
    }
    CHECK_THAT(refusal({.folders = {folder / "file"}}), Catch::Matchers::Contains("which is none"));
    CHECK(names_in(folder) == std::set<std::string>{"file"});
}

TEST_CASE("an output that is an input or another output is refused, however its name is spelled") {
    const ScratchFolder scratch;
    const auto folder = scratch.path();
    const auto input = folder / "input";
    write_file(input, "kept");
    fs::create_symlink("input", folder / "soft");
    fs::create_hard_link(input, folder / "hard");
    fs::create_directory_symlink(".", folder / "here");
    for (const auto& name :
         {folder / "input", folder / "./input", folder / "soft", folder / "hard", folder / "here/input"}) {
        INFO(name);
        CHECK_THAT(refusal({.files = {name}, .inputs = {input}}),
                   Catch::Matchers::Contains("an output that is no input"));
        CHECK_THAT(refusal({.files = {input, name}}), Catch::Matchers::Contains("a place of its own"));
    }
    for (const auto& name : {folder / "new", folder / "./new", folder / "here/new", folder / "new/below"}) {
        INFO(name);
        CHECK_THAT(refusal({.files = {folder / "new", name}}), Catch::Matchers::Contains("a place of its own"));
    }
    CHECK_THAT(refusal({.files = {folder / "new"}, .folders = {folder / "new/er"}}),
               Catch::Matchers::Contains("the folder"));
    CHECK(refusal({.files = {folder / "one", folder / "two"}, .inputs = {input}}) == "nothing: all was accepted");
}

TEST_CASE("an output in a folder that is an input is refused, and one beside it is not") {
    const ScratchFolder scratch;
    const auto input = scratch.path() / "input";
    fs::create_directory(input);
    for (const auto& name : {input / "new", scratch.path() / "other/../input/new", input / "deep/er/new"})
        CHECK_THAT(refusal({.files = {name}, .inputs = {input}}), Catch::Matchers::Contains("outside of the inputs"));
    for (const auto& name : {scratch.path() / "input.png", input / "../new"})
        CHECK(refusal({.files = {name}, .inputs = {input}}) == "nothing: all was accepted");
}

TEST_CASE("outputs are in place together, and not before") {
    const ScratchFolder scratch;
    const auto one = scratch.path() / "one", two = scratch.path() / "new/deep/two";
    Outputs outputs({.files = {one, two}, .folders = {scratch.path() / "many"}});
    write_file(outputs[one], "1");
    write_file(outputs[two], "2");
    write_file(outputs.staged(scratch.path() / "many").path / "sub/three", "3");
    CHECK_FALSE(fs::exists(one));
    CHECK_FALSE(fs::exists(scratch.path() / "new"));
    CHECK_FALSE(fs::exists(scratch.path() / "many"));
    outputs.commit();
    CHECK(read_file(one) == "1");
    CHECK(read_file(two) == "2");
    CHECK(read_file(scratch.path() / "many/sub/three") == "3");
    CHECK(names_in(scratch.path()) ==
          std::set<std::string>{"one", "new", "new/deep", "new/deep/two", "many", "many/sub", "many/sub/three"});
}

TEST_CASE("outputs that are never complete leave nothing") {
    const ScratchFolder scratch;
    const auto one = scratch.path() / "one", two = scratch.path() / "new/two";
    {
        Outputs outputs({.files = {one, two}, .folders = {scratch.path() / "many"}});
        write_file(outputs[one], "1");
        write_file(outputs.staged(scratch.path() / "many").path / "three", "3");
        CHECK_THROWS_WITH(
            write_file_with(outputs[two], [](const fs::path& temporary) { throw Error({temporary}, "luck", "none"); }),
            two.string() + ": expected luck, found none");
    }
    CHECK(names_in(scratch.path()).empty());
}

TEST_CASE("where a device takes no more, no other output is put in place") {
    const ScratchFolder scratch;
    const auto full = scratch.path() / "full";
    if (!made_device(full, makedev(1, 7))) return;
    Outputs outputs({.files = {scratch.path() / "new/file", full}});
    write_file(outputs[scratch.path() / "new/file"], "kept back");
    write_file(outputs[full], "too much");
    CHECK_THROWS_AS(outputs.commit(), Error);
    CHECK_FALSE(fs::exists(scratch.path() / "new"));
}

TEST_CASE("a file staged for a folder is refused where it would replace an input") {
    const ScratchFolder scratch;
    const auto input = scratch.path() / "input";
    write_file(input, "kept");
    Outputs outputs({.folders = {scratch.path()}, .inputs = {input}});
    write_file(outputs.staged(scratch.path()).path / "input", "new");
    CHECK_THROWS_WITH(outputs.commit(), Catch::Matchers::Contains("an output that is no input"));
    CHECK(read_file(input) == "kept");
}

TEST_CASE("a file staged for a folder reaches a link's target on another file system") {
    const ScratchFolder scratch;
    const fs::path memory = "/dev/shm";
    struct stat here {
    }, there{};
    const bool other = stat(scratch.path().c_str(), &here) == 0 && stat(memory.c_str(), &there) == 0 &&
                       here.st_dev != there.st_dev && access(memory.c_str(), W_OK) == 0;
    if (!other) {
        WARN("no other file system here");
        return;
    }
    const Temporary far(Temporary::Kind::folder, memory);
    fs::create_symlink(far.path() / "target", scratch.path() / "link");
    Outputs outputs({.folders = {scratch.path()}});
    write_file(outputs.staged(scratch.path()).path / "link", "across");
    outputs.commit();
    CHECK(fs::is_symlink(scratch.path() / "link"));
    CHECK(read_file(far.path() / "target") == "across");
}
