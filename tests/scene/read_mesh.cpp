#include "raylab/scene/mesh/read_mesh.h"

#include "catch.h"
#include "raylab/base/error.h"
#include "scene/same_mesh.h"

#include <array>
#include <limits>

using namespace raylab;

namespace {

Mesh pyramid(const std::string& file) { return read_mesh(RAYLAB_SOURCE "/tests/scene/meshes/" + file); }

// Catch2 shows what() where the message is another one.
void check_refused(const std::string& bytes, MeshFormat format, const std::string& message) {
    CHECK_THROWS_WITH(read_mesh_bytes(bytes, format, "mesh"), message);
}

constexpr float largest = std::numeric_limits<float>::max();

}  // namespace

TEST_CASE("the same mesh is read from every format") {
    const Mesh expected = pyramid("pyramid.off");
    REQUIRE(expected.vertices.size() == 5);
    REQUIRE(expected.faces.size() == 6);
    for (const auto* file : {"crlf.off", "colors.off", "normals.off", "pyramid.obj", "pyramid.ply",
                             "pyramid_little.ply", "pyramid_big.ply"}) {
        INFO(file);
        CHECK(same_vertices(pyramid(file), expected));
        CHECK(same_faces(pyramid(file), expected));
    }
    for (const auto* file : {"pyramid.stl", "pyramid_binary.stl", "solid_binary.stl"}) {
        INFO(file);
        CHECK(pyramid(file).vertices.size() == 5);  // equal ones are merged and numbered in order of appearance
        CHECK(same_triangles(pyramid(file), expected));
    }
}

TEST_CASE("the format is known by the file's extension, in upper and lower case") {
    CHECK(mesh_format("a/b.off") == MeshFormat::off);
    CHECK(mesh_format("B.OBJ") == MeshFormat::obj);
    CHECK(mesh_format("b.x.Ply") == MeshFormat::ply);
    CHECK(mesh_format("b.stl") == MeshFormat::stl);
    CHECK_THROWS_WITH(mesh_format("elephant.fbx"),
                      "elephant.fbx: expected a mesh file that ends in .off, .obj, .ply or .stl, found '.fbx'");
    CHECK_THROWS_AS(mesh_format("elephant"), Error);
}

TEST_CASE("a file that is not there is refused by name") {
    CHECK_THROWS_WITH(read_mesh("no/such.off"), "no/such.off: expected a file, found nothing there");
}

TEST_CASE("a decimal becomes the nearest float, rounded once") {
    // 1 + 2^-24 and slightly more: the nearest double is the tie 1 + 2^-24 itself, which would be rounded to 1.
    const std::string above_tie = "1.000000059604644775390625000000001";
    const auto mesh = read_mesh_bytes(
        "v " + above_tie + " 0.1 1e-46\nv -1e-60 +2 .5\nv 1e-45 3.4028235e38 5.\nf 1 2 3\n", MeshFormat::obj, "mesh");
    CHECK(mesh.vertices[0] == Vec3f(1.0f + 0x1p-23f, 0.1f, 0.0f));
    CHECK(mesh.vertices[1] == Vec3f(-0.0f, 2.0f, 0.5f));
    CHECK(mesh.vertices[2] == Vec3f(std::numeric_limits<float>::denorm_min(), largest, 5.0f));
}

TEST_CASE("what is no finite float is refused") {
    for (const std::string word :
         {"nan", "inf", "-inf", "1e39", "3.4028236e38", "1e999", "0x1p3", "1e5f", "1,5", "+-1", "-", "one"}) {
        INFO(word);
        check_refused("v 0 0 0\nv 0 " + word + " 0\n", MeshFormat::obj,
                      "mesh:2: expected a finite number that fits a float, found '" + word + "'");
    }
}

TEST_CASE("polygons are fanned from their first corner, in file order") {
    const auto mesh = read_mesh_bytes("OFF\n5 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 2 0\n3 4 2 0\n5 1 2 3 4 0\n",
                                      MeshFormat::off, "mesh");
    using Corners = std::array<std::uint32_t, 3>;
    std::vector<Corners> corners;
    for (const auto& [a, b, c] : mesh.faces) corners.push_back({a, b, c});
    CHECK(corners == std::vector<Corners>{{4, 2, 0}, {1, 2, 3}, {1, 3, 4}, {1, 4, 0}});
}

TEST_CASE("a triangle without area keeps its number") {
    const auto mesh =
        read_mesh_bytes("v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 1 2\nf 1 2 3\nf 3 2 1\n", MeshFormat::obj, "mesh");
    CHECK(mesh.faces.size() == 3);
}

TEST_CASE("a mesh without faces is refused") {
    check_refused("OFF\n1 0 0\n0 0 0\n", MeshFormat::off, "mesh:3: expected a mesh with at least one face, found none");
    check_refused("# nothing\n", MeshFormat::obj, "mesh:1: expected a mesh with at least one face, found none");
}

TEST_CASE("a message quotes what it found short and printable") {
    check_refused("OFF\n3 1 0\n" + std::string(1000, '\xff') + " 0 0\n", MeshFormat::off,
                  "mesh:3: expected a finite number that fits a float, found '" + std::string(40, '?') + "...'");
}
