#include "catch.h"
#include "could_not.h"
#include "outputs/workplace.h"

#include "raylab/base/file.h"

// Tests every command with an output, and every way in which one can be wrong: exit code 2, one line, and an unchanged
// folder.

using namespace raylab;
namespace fs = std::filesystem;

namespace {

/// A command line with the word OUTPUT for one output.
struct Command {
    std::vector<std::string> words;
    std::string extension = ".json";  // of the files that it accepts as OUTPUT
    std::string input = {};           // a file that it reads, which it must not replace
};

const std::vector<Command> to_files = {
    {{"render", "scene.toml", "-o", "OUTPUT"}, ".png", "scene.toml"},
    {{"render", "scene.toml", "-o", "OUTPUT"}, ".exr", "scene.toml"},
    {{"render", "scene.toml", "--json", "OUTPUT"}, ".json", "scene.toml"},
    {{"render", "scene.toml", "--json", "OUTPUT"}, ".json", "mesh.off"},
    {{"render", "scene.toml", "-o", "picture.png", "--json", "OUTPUT"}, ".json", "scene.toml"},
    {{"tree", "scene.toml", "--pixel", "1,1", "-o", "OUTPUT"}, ".svg", "scene.toml"},
    {{"tree", "scene.toml", "--pixel", "1,1", "-o", "OUTPUT"}, ".json", "mesh.off"},
    {{"tree", "tree.json", "--against", "other.json", "-o", "OUTPUT"}, ".json", "tree.json"},
    {{"tree", "tree.json", "--against", "other.json", "--json", "OUTPUT"}, ".json", "other.json"},
    {{"compare", "a.png", "b.png", "-o", "OUTPUT"}, ".png", "a.png"},
    {{"compare", "a.png", "b.png", "--json", "OUTPUT"}, ".json", "b.png"},
    {{"trace", "mesh.off", "--rays", "rays", "-o", "OUTPUT"}, ".hits", "rays"},
    {{"trace", "mesh.off", "--rays", "rays", "-o", "hits", "--json", "OUTPUT"}, ".json", "mesh.off"},
    {{"export", "scene.toml", "-o", "OUTPUT"}, ".pov", "scene.toml"},
    {{"needs", "scene.toml", "--json", "OUTPUT"}, ".json", "scene.toml"},
    {{"chart", "ray_sphere", "--quick", "--json", "OUTPUT"}},
    {{"stability", "FMA-SWITCH", "--quick", "--json", "OUTPUT"}},
    {{"stability", "accelerators", "--rays", "100", "--structure", "bvh", "--json", "OUTPUT"}},
    {{"stability", "accelerators", "--replay", "replay.json", "--json", "OUTPUT"}, ".json", "replay.json"},
    {{"chapter", "02", "--only", "story", "--quick", "--json", "OUTPUT"}},
    {{"chapter", "02", "--scene", "scene.toml", "--only", "story", "--json", "OUTPUT"}, ".json", "scene.toml"},
    {{"check", "02", "--answer", "answer.cpp", "--verdict-only", "--json", "OUTPUT"}, ".json", "answer.cpp"},
    {{"grade", "02", "--submission", "answer.cpp", "-o", "OUTPUT"}, ".json", "answer.cpp"},
    {{"grade", "02", "--submission", "answer.cpp", "--key", "course.key", "-o", "OUTPUT"}, ".key", "course.key"},
    {{"grade", "--scene", "scene.toml", "--reference", "a.png", "--picture", "b.png", "-o", "OUTPUT"}, ".png", "b.png"},
    {{"grade", "--scene", "scene.toml", "--reference", "a.png", "--picture", "b.png", "-o", "OUTPUT"}, ".png", "a.png"},
    {{"tour", "--quick", "--out", "book", "--json", "OUTPUT"}},
    {{"bench", "--meshes", "mesh.off", "--peers", "bvh", "--size", "2", "--json", "OUTPUT"}, ".json", "mesh.off"},
};

const std::vector<Command> to_folders = {
    {{"chart", "ray_sphere", "--quick", "-o", "OUTPUT"}},
    {{"stability", "accelerators", "--rays", "100", "--structure", "bvh", "--out", "OUTPUT"}},
    {{"chapter", "02", "--only", "story", "--quick", "--out", "OUTPUT"}},
    {{"check", "02", "--answer", "answer.cpp", "--out", "OUTPUT"}},
    {{"tour", "--quick", "--out", "OUTPUT"}},
    {{"bench", "--meshes", "mesh.off", "--peers", "bvh", "--size", "2", "--out", "OUTPUT"}},
};

/// `named` is what the line must mention.
void check_refused(const Workplace& workplace, const Command& command, const std::string& output,
                   const std::string& named) {
    const auto before = workplace.contents();
    const auto result = workplace.lab(command.words, output);
    INFO(words_of(command.words) << "\nwith " << output);
    check_could_not(result, named);
    CHECK(result.errors.find(".raylab-") == std::string::npos);
    CHECK(workplace.contents() == before);
}

}  // namespace

TEST_CASE("no command takes an output that cannot be written, and none leaves anything") {
    const Workplace workplace;
    fs::create_directory(workplace.path() / "folder.d");
    write_file(workplace.path() / "file", "no folder");
    for (const auto& command : to_files) {
        const auto read_only = "read_only" + command.extension, folder = "a_folder" + command.extension;
        write_file(workplace.path() / read_only, "kept");
        fs::permissions(workplace.path() / read_only, static_cast<fs::perms>(0444));
        fs::create_directory(workplace.path() / folder);
        const auto too_long = std::string(256 - command.extension.size(), 'x') + command.extension;
        for (const auto& output :
             {read_only, folder, "file/below" + command.extension, "new/" + too_long, std::string("new/")})
            check_refused(workplace, command, output, output);
        fs::remove(workplace.path() / read_only);
        fs::remove(workplace.path() / folder);
    }
}

TEST_CASE("no command replaces what it reads, however that is spelled") {
    const Workplace workplace;
    for (const auto& command : to_files) {
        if (command.input.empty()) continue;
        const auto soft = "soft" + command.extension, hard = "hard" + command.extension;
        fs::create_symlink(command.input, workplace.path() / soft);
        fs::create_hard_link(workplace.path() / command.input, workplace.path() / hard);
        for (const auto& output : {command.input, "./" + command.input, soft, hard})
            check_refused(workplace, command, output, output);
        fs::remove(workplace.path() / soft);
        fs::remove(workplace.path() / hard);
    }
}

TEST_CASE("a result is not written among the submissions that are graded") {
    const Workplace workplace;
    fs::create_directory(workplace.path() / "class");
    fs::copy_file(workplace.path() / "answer.cpp", workplace.path() / "class/nearest_sphere_hit.cpp");
    for (const auto* output : {"class/nearest_sphere_hit.cpp", "class/result.json", "./class/../class/new/result"})
        check_refused(workplace, {{"grade", "02", "--submission", "class", "-o", "OUTPUT"}}, output, output);
    for (const auto* output : {"class", "class/report", "class/nearest_sphere_hit.cpp"})
        check_refused(workplace, {{"grade", "02", "--class", "class", "-o", "OUTPUT"}}, output, output);
}

TEST_CASE("two outputs of a command are two files") {
    const Workplace workplace;
    const std::vector<Command> twice = {
        {{"render", "scene.toml", "-o", "a.png", "--json", "OUTPUT"}},
        {{"tree", "scene.toml", "--pixel", "1,1", "-o", "a.png", "--json", "OUTPUT"}},
        {{"compare", "b.png", "b.png", "-o", "a.png", "--json", "OUTPUT"}},
        {{"trace", "mesh.off", "--rays", "rays", "-o", "a.png", "--json", "OUTPUT"}},
    };
    for (const auto& command : twice)
        for (const std::string same : {"a.png", "./a.png", "a.png/below"})
            check_refused(workplace, command, same, same);
    for (const std::string same : {"index.html", "./index.html", "index.html/below"})
        check_refused(workplace, {{"tour", "--quick", "--out", ".", "--json", "OUTPUT"}}, same, same);
}

TEST_CASE("no command takes a folder that cannot be made") {
    const Workplace workplace;
    write_file(workplace.path() / "file", "no folder");
    for (const auto& command : to_folders)
        for (const std::string output : {"file", "file/below"}) check_refused(workplace, command, output, output);
}

TEST_CASE("a command that fails at its work leaves no folder that it would have made") {
    const Workplace workplace;
    write_file(workplace.path() / "broken", "nothing of the kind");
    const std::vector<Command> failing = {
        {{"render", "broken.toml", "-o", "OUTPUT"}, ".png"},
        {{"tree", "broken", "--pixel", "1,1", "-o", "OUTPUT"}, ".svg"},
        {{"compare", "broken", "b.png", "--json", "OUTPUT"}},
        {{"trace", "mesh.off", "--rays", "broken", "-o", "OUTPUT"}},
        {{"export", "broken", "-o", "OUTPUT"}, ".pov"},
        {{"needs", "broken", "--json", "OUTPUT"}},
        {{"stability", "accelerators", "--replay", "broken", "--json", "OUTPUT"}},
        {{"chapter", "02", "--scene", "broken", "--only", "story", "--out", "new", "--json", "OUTPUT"}},
        {{"check", "02", "--answer", "broken.cpp", "--out", "new", "--json", "OUTPUT"}},
    };
    for (const auto& command : failing)
        check_refused(workplace, command, "new/deep/output" + command.extension, "broken");
}
