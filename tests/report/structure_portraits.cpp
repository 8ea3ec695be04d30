#include "raylab/report/structure/structure_portraits.h"

#include "catch.h"
#include "raylab/experiment/generate/generate.h"
#include "raylab/experiment/structure/structure_workload.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

using namespace raylab;
namespace fs = std::filesystem;

namespace {

std::string text_of(const fs::path& file) {
    std::ifstream in(file);
    return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace

TEST_CASE("a page shows of every structure a ray's way and its tree, and what pixels cost") {
    const ChapterRun run{.out = fs::path(RAYLAB_BUILD) / "tests" / "portraits", .effort = ChapterRun::Effort::quick};
    fs::create_directories(run.out);
    const Scene scene = mesh_scene(std::make_shared<Mesh>(icosphere(1)), "ball");
    const auto methods = structure_methods(accelerator_names());
    Page page({"portraits", "Portraits", "How does it look?"}, run);
    tell_portraits(run, page, methods, scene, {{-3, 0.1f, 0.2f}, {1, 0, 0}});
    page.write(run.out);
    const std::string html = text_of(run.out / "index.html");
    for (const StructureMethod& method : methods) {
        std::string name = method.name;
        std::ranges::replace(name, '_', '-');
        INFO(name);
        for (const std::string drawing : {"way_of_" + name + ".svg", "tree_of_" + name + ".svg"}) {
            CHECK(text_of(run.out / drawing).find(method.name) != std::string::npos);
            CHECK(html.find(drawing) != std::string::npos);
        }
        const bool has_nodes = !method.make(scene)->outline().nodes.empty();
        CHECK((text_of(run.out / ("tree_of_" + name + ".svg")).find("class=\"node\"") != std::string::npos) ==
              has_nodes);
    }
    const Image maps = tests_of_each(run, methods, scene);
    CHECK(maps.width() > static_cast<int>(methods.size()) * 120);
}
