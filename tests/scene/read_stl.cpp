#include "catch.h"
#include "raylab/base/file.h"
#include "raylab/scene/read_mesh.h"

using namespace raylab;

namespace {

Mesh stl(const std::string& bytes) { return read_mesh_bytes(bytes, MeshFormat::stl, "a.stl"); }

std::string file(const std::string& name) { return read_file(RAYLAB_SOURCE "/tests/scene/meshes/" + name); }

std::string facet(const std::string& vertices) {
    return "facet normal 0 0 1\nouter loop\n" + vertices + "endloop\nendfacet\n";
}

const std::string triangle = facet("vertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n");

}  // namespace

TEST_CASE("STL: equal vertices become one, both zeros being equal, numbered as they appear") {
    const auto mesh = stl("solid\n" + triangle + facet("vertex 1 0 -0\nvertex -0 0 0\nvertex 0 0 1\n") + "endsolid\n");
    CHECK(mesh.vertices == std::vector<Vec3f>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
    CHECK(mesh.faces[1].a == 1);
    CHECK(mesh.faces[1].b == 0);
    CHECK(mesh.faces[1].c == 3);
}

TEST_CASE("STL: keywords may be upper case, solids may be several, the normal may be no number") {
    CHECK(stl("SOLID A\nFACET NORMAL nan nan nan\nOUTER LOOP\nVERTEX 0 0 0\nVERTEX 1 0 0\nVERTEX 0 1 "
              "0\nENDLOOP\nENDFACET\n"
              "ENDSOLID A\nsolid b\n" +
              triangle + "endsolid b\n")
              .faces.size() == 2);
}

TEST_CASE("STL: a text cut short anywhere is refused") {
    const auto whole = file("pyramid.stl");
    const auto last_word = whole.rfind("endsolid");
    for (std::size_t size = 0; size < last_word + 8; ++size) {
        INFO(size << " bytes");
        CHECK_THROWS(stl(whole.substr(0, size)));
    }
}

TEST_CASE("STL: a binary file cut short anywhere, or with a byte too many, is refused, 'solid' or not") {
    for (const auto* name : {"pyramid_binary.stl", "solid_binary.stl"}) {
        const auto whole = file(name);
        for (std::size_t size = 0; size < whole.size(); ++size) {
            INFO(name << ", " << size << " bytes");
            CHECK_THROWS(stl(whole.substr(0, size)));
        }
        CHECK_THROWS_WITH(stl(whole + '\0'), "a.stl: expected 384 bytes for the 6 facets it promises, found 385");
    }
}

TEST_CASE("STL: a number that is not finite is refused with its facet") {
    auto bytes = file("pyramid_binary.stl");
    bytes.replace(84 + 50 + 12, 4, "\xff\xff\xff\x7f", 4);  // NaN
    CHECK_THROWS_WITH(stl(bytes), Catch::StartsWith("a.stl byte 134 (facet 1): expected three finite numbers"));
}

TEST_CASE("STL: other lines than the grammar's are refused") {
    CHECK_THROWS_WITH(stl("solid\n" + facet("vertex 0 0 0\nvertex 1 0 0\n")),
                      "a.stl:6: expected 'vertex' and 3 numbers, found 'endloop'");
    CHECK_THROWS_WITH(stl("solid\n" + facet("vertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nvertex 1 1 0\n")),
                      "a.stl:7: expected 'endloop' alone, found 'vertex 1 1 0'");
    CHECK_THROWS_WITH(stl("solid\nendsolid\nfacet\n"),
                      "a.stl:3: expected 'solid', or the end of the file, found 'facet'");
    CHECK_THROWS_WITH(stl("ply\n"),
                      "a.stl: expected an STL file: 'solid' in text, or at least 84 bytes, found 4 bytes");
}
