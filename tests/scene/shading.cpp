#include "catch.h"

#include "raylab/scene/read_scene.h"

using namespace raylab;

namespace {

Scene with_meshes(const std::string& first, const std::string& second) {
    const std::string head = "[[shape]]\ntype = \"mesh\"\nfile = \"tetrahedron.off\"\n";
    return read_scene_text("raylab = 1\n" + head + first + "\n" + head + second + "\n",
                           RAYLAB_SOURCE "/tests/scene/files/a.toml");
}

const Mesh& mesh(const Scene& scene, std::size_t object) {
    return *std::get<std::shared_ptr<const Mesh>>(scene.objects.at(object).shape);
}

}  // namespace

TEST_CASE("a mesh file without normals is given some where its shading needs them") {
    const auto scene = with_meshes("", "shading = \"phong\"");
    CHECK(mesh(scene, 0).normals.empty());
    CHECK(mesh(scene, 1).normals.size() == 4);
    CHECK(scene.objects[0].shading == Shading::phong);
    CHECK(mesh(with_meshes("shading = \"gouraud\"", ""), 0).normals.size() == 4);
    CHECK(mesh(with_meshes("shading = \"flat\"", ""), 0).normals.empty());
}

TEST_CASE("a mesh file's own normals are kept, whatever its shading") {
    const auto scene =
        read_scene_text("raylab = 1\n[[shape]]\ntype = \"mesh\"\nfile = \"leaning_normals.off\"\nshading = \"phong\"\n",
                        RAYLAB_SOURCE "/tests/scene/files/a.toml");
    CHECK(mesh(scene, 0).normals == std::vector<Vec3f>(3, Vec3f{1, 0, 1}));
}

TEST_CASE("meshes of one file that both need normals share them") {
    const auto scene = with_meshes("shading = \"phong\"", "shading = \"gouraud\"");
    CHECK(&mesh(scene, 0) == &mesh(scene, 1));
    CHECK(scene.objects[0].shading == Shading::phong);
    CHECK(scene.objects[1].shading == Shading::gouraud);
}
