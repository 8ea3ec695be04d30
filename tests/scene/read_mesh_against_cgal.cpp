#include "catch.h"

#include "raylab/scene/demo_meshes.h"
#include "raylab/scene/mesh/read_mesh.h"
#include "scene/cgal_soup.h"
#include "scene/same_mesh.h"

using namespace raylab;
namespace fs = std::filesystem;

namespace {

// Splits polygons into fans as the lab's readers do.
Mesh fanned(const Soup& soup) {
    Mesh mesh;
    for (const auto& [x, y, z] : soup.points) mesh.vertices.push_back({x, y, z});
    const auto index = [](std::size_t i) { return static_cast<std::uint32_t>(i); };
    for (const auto& polygon : soup.polygons)
        for (std::size_t last = 2; last < polygon.size(); ++last)
            mesh.faces.push_back({index(polygon[0]), index(polygon[last - 1]), index(polygon[last])});
    return mesh;
}

void check_as_cgal(const fs::path& file) {
    INFO(file);
    const auto soup = read_with_cgal(file);
    REQUIRE(soup);
    const Mesh ours = read_mesh(file), theirs = fanned(*soup);
    CHECK(same_vertices(ours, theirs));
    CHECK(same_faces(ours, theirs));
}

}  // namespace

TEST_CASE("CGAL reads the same meshes from small files of every format") {
    for (const auto& entry : fs::directory_iterator(RAYLAB_SOURCE "/tests/scene/meshes"))
        if (entry.path().extension() != ".md") check_as_cgal(entry.path());
}

TEST_CASE("CGAL reads the same vertices and triangles from the real meshes") {
    bool any = false;
    for (const auto& name : demo_mesh_names())
        if (const auto file = demo_mesh(name)) {
            any = true;
            check_as_cgal(*file);
        }
    if (!any) WARN("skipped: no meshes in the build folder (cmake/fetch_meshes.sh fetches them)");
}
