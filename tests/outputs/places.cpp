#include "base/device.h"
#include "base/fifo.h"
#include "catch.h"
#include "outputs/workplace.h"

#include "raylab/base/file.h"

// Tests of outputs that are no plain new files, for every writer of the program.

using namespace raylab;
namespace fs = std::filesystem;

namespace {

struct Writer {
    std::vector<std::string> words;  // with the word OUTPUT
    std::string extension;
};

const std::vector<Writer> writers = {
    {{"render", "scene.toml", "-o", "OUTPUT"}, ".png"},
    {{"render", "scene.toml", "-o", "OUTPUT"}, ".exr"},
    {{"render", "scene.toml", "--json", "OUTPUT"}, ""},
    {{"tree", "scene.toml", "--pixel", "4,4", "-o", "OUTPUT"}, ".svg"},
    {{"tree", "tree.json", "--against", "other.json", "-o", "OUTPUT"}, ".json"},
    {{"compare", "a.png", "b.png", "-o", "OUTPUT"}, ".png"},
    {{"compare", "a.png", "b.png", "--json", "OUTPUT"}, ""},
    {{"trace", "mesh.off", "--rays", "rays", "-o", "OUTPUT"}, ""},
    {{"export", "scene.toml", "-o", "OUTPUT"}, ".pov"},
    {{"needs", "scene.toml", "--json", "OUTPUT"}, ""},
    {{"stability", "accelerators", "--rays", "100", "--structure", "bvh", "--json", "OUTPUT"}, ""},
};

}  // namespace

TEST_CASE(
    "every writer writes through a FIFO and to a symlink's target, keeps permissions, and takes a name of 255 bytes") {
    const Workplace workplace;
    for (const auto& [words, extension] : writers) {
        INFO(words_of(words) << " to " << extension);
        const auto in_folder = [&](const std::string& name) { return workplace.path() / (name + extension); };
        const auto target = in_folder("target"), link = in_folder("link"),
                   longest = in_folder(std::string(255 - extension.size(), 'x'));
        fs::create_symlink(target.filename(), link);
        CHECK(workplace.lab(words, link.filename()).code == 0);
        CHECK(fs::is_symlink(link));
        REQUIRE(fs::is_regular_file(target));
        fs::permissions(target, static_cast<fs::perms>(0640));
        CHECK(workplace.lab(words, link.filename()).code == 0);
        CHECK(fs::status(target).permissions() == static_cast<fs::perms>(0640));
        CHECK(workplace.lab(words, longest.filename()).code == 0);
        CHECK(fs::exists(longest));
        const auto fifo = in_folder("fifo");
        const auto got = read_through_fifo(fifo, [&] { CHECK(workplace.lab(words, fifo.filename()).code == 0); });
        CHECK(fs::is_fifo(fifo));
        CHECK(got.substr(0, 4) == read_file(target).substr(0, 4));  // the seconds that follow may differ
        for (const auto& file : {target, link, longest, fifo}) fs::remove(file);
    }
}

TEST_CASE("every writer leaves a device what it is") {
    const Workplace workplace;
    for (const auto& [words, extension] : writers) {
        INFO(words_of(words));
        const auto null = workplace.path() / ("null" + extension), full = workplace.path() / ("full" + extension);
        if (!made_device(null, makedev(1, 3)) || !made_device(full, makedev(1, 7))) return;
        CHECK(workplace.lab(words, null.filename()).code == 0);
        CHECK(fs::is_character_file(null));
        const auto result = workplace.lab(words, full.filename());
        CHECK(result.code == 2);
        CHECK_THAT(result.errors,
                   Catch::Matchers::Contains(full.filename().string() + ": expected a place that can be written"));
        CHECK(fs::is_character_file(full));
        fs::remove(null);
        fs::remove(full);
    }
}

TEST_CASE("an output that leads to standard output is written there, before what is printed at the end") {
    const Workplace workplace;
    fs::create_symlink("/proc/self/fd/1", workplace.path() / "stdout");  // /dev/stdout leads there
    const std::string needs = RAYLAB_BUILD "/raylab needs scene.toml";
    const auto command = needs + " --json stdout > both && " + needs + " --json - > json && " + needs + " > text";
    REQUIRE(run_process("sh", {"-c", command}, {.folder = workplace.path()}).succeeded());
    const auto kept = [&](const char* name) { return read_file(workplace.path() / name); };
    CHECK(kept("both") == kept("json") + kept("text"));
}
