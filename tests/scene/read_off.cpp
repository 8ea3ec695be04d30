#include "catch.h"
#include "raylab/scene/mesh/read_mesh.h"

using namespace raylab;

namespace {

const std::string vertices = "0 0 0\n1 0 0\n0 1 0\n";

Mesh off(const std::string& text) { return read_mesh_bytes(text, MeshFormat::off, "a.off"); }

}  // namespace

TEST_CASE("OFF: comments and empty lines may stand anywhere") {
    CHECK(off("# one\n\nOFF # two\n3 1 0 # three\n#\n0 0 0 # four\n\n1 0 0\n0 1 0\n  \n3 0 1 2#five\n#six")
              .faces.size() == 1);
}

TEST_CASE("OFF: the counts may stand on the keyword's line, and that of edges may lack") {
    CHECK(off("OFF 3 1 0\n" + vertices + "3 0 1 2\n").faces.size() == 1);
    CHECK(off("OFF\n3 1\n" + vertices + "3 0 1 2\n").faces.size() == 1);
}

TEST_CASE("OFF: normals are kept, colours and texture coordinates are passed over") {
    const auto mesh =
        off("STCNOFF\n3 1 0\n0 0 0 0 0 2  1 1 1 1  0 0\n1 0 0 0 0 3  1 1 1 1  0 0\n0 1 0 0 1 0  1 1 1 1  0 0\n3 0 1 2 "
            "255 0 0\n");
    CHECK(mesh.normals == std::vector<Vec3f>{{0, 0, 2}, {0, 0, 3}, {0, 1, 0}});
    CHECK(off("COFF\n3 1 0\n0 0 0 9 9 9\n1 0 0\n0 1 0 1 1 1 1\n3 0 1 2\n").normals.empty());
}

TEST_CASE("OFF: a face may hold a colour, and no more") {
    CHECK(off("OFF\n3 1 0\n" + vertices + "3 0 1 2 0.5 0.5 0.5 1\n").faces.size() == 1);
    CHECK_THROWS_WITH(off("OFF\n3 1 0\n" + vertices + "3 0 1 2 1 1 1 1 1\n"),
                      "a.off:6: expected a colour of at most 4 numbers, found '1'");
    CHECK_THROWS_WITH(off("OFF\n3 1 0\n" + vertices + "3 0 1 2 red\n"),
                      "a.off:6: expected a finite number that fits a float, found 'red'");
}

TEST_CASE("OFF: a count is believed only as far as the file has room for it") {
    CHECK_THROWS_WITH(
        off("OFF\n4000000000 1 0\n" + vertices + "3 0 1 2\n"),
        "a.off:2: expected at most 4 vertices (what the rest of the file has room for), found 4000000000");
    CHECK_THROWS_WITH(off("OFF\n-3 1 0\n" + vertices),
                      "a.off:2: expected at most 3 vertices (what the rest of the file has room for), found -3");
}

TEST_CASE("OFF: the last line may lack its end") {
    CHECK(off("OFF\n3 1 0\n" + vertices + "3 0 1 2").faces.size() == 1);
}

TEST_CASE("OFF: what the counts do not promise is refused") {
    CHECK_THROWS_WITH(off("OFF\n3 1 0\n" + vertices + "3 0 1 2\n3 2 1 0\n"),
                      "a.off:7: expected the end of the file, found '3'");
    CHECK_THROWS_WITH(off("OFF\n3 2 0\n" + vertices + "3 0 1 2\n"),
                      "a.off:6: expected a face, found the end of the file");
    CHECK_THROWS_WITH(off("OFF\n3 1 0\n0 0 0 1\n1 0 0\n0 1 0\n3 0 1 2\n"),
                      "a.off:3: expected the end of the vertex, found '1'");
}

TEST_CASE("OFF: formats that only look like it are refused") {
    for (const std::string keyword : {"4OFF", "nOFF", "NCOFF", "ply", "off", "OFF490 518 0"}) {
        INFO(keyword);
        CHECK_THROWS_WITH(off(keyword + "\n3 1 0\n"), Catch::Contains("a.off:1: expected OFF, or NOFF"));
    }
    CHECK_THROWS_WITH(off("OFF BINARY\n"), "a.off:1: expected OFF in text, found 'BINARY'");
}
