#include "raylab/base/file.h"

#include "base/device.h"
#include "base/fifo.h"
#include "base/names_in.h"
#include "catch.h"

#include "raylab/base/error.h"
#include "raylab/base/temporary.h"

#include <fstream>
#include <set>

using namespace raylab;
using raylab::test::names_in;
namespace fs = std::filesystem;

namespace {

fs::perms mode_of(const fs::path& file) { return fs::status(file).permissions(); }

}  // namespace

TEST_CASE("what is written to a FIFO reaches its reader, and the FIFO stays") {
    const ScratchFolder scratch;
    const auto fifo = scratch.path() / "fifo";
    CHECK(read_through_fifo(fifo, [&] { write_file(fifo, "through"); }) == "through");
    CHECK(fs::is_fifo(fifo));
    CHECK(names_in(scratch.path()) == std::set<std::string>{"fifo"});
}

TEST_CASE("a device is written to, and stays a device") {
    const ScratchFolder scratch;
    const auto null = scratch.path() / "null", full = scratch.path() / "full";
    if (!made_device(null, makedev(1, 3)) || !made_device(full, makedev(1, 7))) return;
    write_file(null, "gone");
    CHECK(fs::is_character_file(null));
    CHECK_THROWS_WITH(write_file(full, "too much"),
                      full.string() + ": expected a place that can be written, found No space left on device");
    CHECK(fs::is_character_file(full));
}

TEST_CASE("a symlink stays, and the file it leads to is replaced or made") {
    const ScratchFolder scratch;
    const auto folder = scratch.path();
    fs::create_directory(folder / "far");
    write_file(folder / "far/there", "old");
    fs::create_symlink("far/there", folder / "link");
    fs::create_symlink("link", folder / "link_to_link");
    fs::create_symlink("far/not_yet", folder / "dangling");
    write_file(folder / "link_to_link", "new");
    write_file(folder / "dangling", "made");
    CHECK(read_file(folder / "far/there") == "new");
    CHECK(read_file(folder / "far/not_yet") == "made");
    CHECK(names_in(folder) ==
          std::set<std::string>{"far", "far/there", "far/not_yet", "link", "link_to_link", "dangling"});
    for (const char* link : {"link", "link_to_link", "dangling"}) CHECK(fs::is_symlink(folder / link));
    fs::create_symlink("circle", folder / "circle");
    CHECK_THROWS_WITH(write_file(folder / "circle", ""), Catch::Matchers::Contains("a circle of them"));
}

TEST_CASE("a file that is replaced keeps its permissions, a new one has the usual ones") {
    const ScratchFolder scratch;
    const auto file = scratch.path() / "file";
    write_file(file, "old");
    std::ofstream(scratch.path() / "usual");
    CHECK(mode_of(file) == mode_of(scratch.path() / "usual"));
    for (const auto mode : {0600, 0640, 0755}) {
        fs::permissions(file, static_cast<fs::perms>(mode));
        write_file(file, "new");
        CHECK(mode_of(file) == static_cast<fs::perms>(mode));
    }
}

TEST_CASE("a read-only file is refused, for root too, and stays as it is") {
    const ScratchFolder scratch;
    const auto file = scratch.path() / "file";
    write_file(file, "kept");
    fs::permissions(file, static_cast<fs::perms>(0444));
    CHECK_THROWS_WITH(write_file(file, "new"),
                      Catch::Matchers::Contains("file: expected a file that may be written, found a read-only one"));
    CHECK(read_file(file) == "kept");
    CHECK(names_in(scratch.path()) == std::set<std::string>{"file"});
}
