#include "streams/program.h"

#include "catch.h"
#include "compare/plain_exr.h"

#include "raylab/accelerator/trace_rays.h"
#include "raylab/base/file.h"

namespace fs = std::filesystem;
using namespace raylab;

namespace {

std::string file(const std::string& name) { return (streams_folder / name).string(); }

}  // namespace

ProcessResult in_shell(const std::vector<std::string>& words, const Around& around) {
    fs::create_directories(streams_folder);
    const auto script = around.prefix + " \"$@\" " + around.suffix;
    std::vector<std::string> all = {"-c", script, "sh", fs::path(RAYLAB_BUILD) / "raylab"};
    all.insert(all.end(), words.begin(), words.end());
    return run_process("sh", all, {.folder = streams_folder, .timeout = 120});
}

std::vector<ShortRun> short_runs() {
    using enum ShortRun::Json;
    const std::string mesh = RAYLAB_SOURCE "/tests/scene/meshes/pyramid.off";
    const auto rays = file("one.rays"), picture = file("picture.exr");
    write_file(rays, to_bytes(std::vector<Ray>{{{0, 0, 3}, {0, 0, -1}}}));
    write_file(picture, plain_exr(Image(8, 8)));
    const auto part = file("part.exr");
    in_shell({"render", still_life, "--model", "path", "--size", "8x8", "--samples", "2", "--part", "1/2", "-o", part});
    return {
        {{"help"}, has_none},
        {{"tour", "--quick", "--out", file("book")}, has_none},
        {{"chapter", "02", "--only", "stability", "--case", "FAR-SPHERE", "--quick", "--out", file("chapter")}},
        {{"slides", "02", "--quick", "--book", file("lecture")}, has_none},
        {{"chart"}, has_none},
        {{"stability", "--list"}, has_none},
        {{"stability", "accelerators", "--rays", "10", "--structure", "bvh8"}},
        {{"render", still_life, "--size", "8x8", "-o", file("a.png")}},
        {{"merge", part, "-o", file("sum.exr")}, has_none},
        {{"radiosity", RAYLAB_SOURCE "/chapters/14_radiosity/scene.toml", "--patches", "50"}},
        {{"radiosity", RAYLAB_SOURCE "/chapters/14_radiosity/scene.toml", "--mesh", "hierarchical", "--patches", "50"}},
        {{"radiosity", RAYLAB_SOURCE "/chapters/14_radiosity/scene.toml", "--mesh", "adaptive", "--patches", "50"}},
        {{"radiosity", RAYLAB_SOURCE "/chapters/14_radiosity/scene.toml", "--error", "0.4"}},
        {{"form-factor", RAYLAB_SOURCE "/chapters/14_radiosity/scene.toml", "--from", "polygon 0", "--to",
          "polygon 1"}},
        {{"needs", still_life}},
        {{"tree", still_life, "--pixel", "1,1", "-o", file("tree.dot")}},
        {{"compare", picture, picture}},
        {{"trace", mesh, "--rays", rays, "-o", file("one.hits")}},
        {{"bench", "--meshes", "bumpy_0", "--rays", "primary", "--peers", "auto", "--size", "4"}},
        {{"export", still_life, "-o", file("a.pov")}, has_none},
        {{"doctor"}, has_none},
        {{"check", "01", "--hint", "1"}, has_none},
        {{"watch", "02"}, has_none},
        {{"grade", "02", "--submission", RAYLAB_SOURCE "/exercises/02_ray_sphere/right/geometric.cpp"}, has_none}};
}
