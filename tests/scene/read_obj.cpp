#include "catch.h"
#include "raylab/scene/mesh/read_mesh.h"

using namespace raylab;

namespace {

const std::string corners = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

Mesh obj(const std::string& text) { return read_mesh_bytes(text, MeshFormat::obj, "a.obj"); }

}  // namespace

TEST_CASE("OBJ: every form of index names the same vertex") {
    for (const std::string face :
         {"1 2 3", "-3 -2 -1", "1/1 2/1 3/1", "1//1 2//1 3//1", "1/1/1 2/-1/1 3/1/-1", "1/ 2/ 3//"}) {
        INFO(face);
        const auto mesh = obj(corners + "vt 0 0\nvn 0 0 1\nf " + face + "\n");
        REQUIRE(mesh.faces.size() == 1);
        CHECK(mesh.faces[0].a == 0);
        CHECK(mesh.faces[0].b == 1);
        CHECK(mesh.faces[0].c == 2);
    }
}

TEST_CASE("OBJ: a negative index counts back from where it stands") {
    const auto mesh = obj(corners + "f -3 -2 -1\nv 5 5 5\nf -3 -2 -1\n");
    CHECK(mesh.faces[0].a == 0);
    CHECK(mesh.faces[1].a == 1);
}

TEST_CASE("OBJ: an index that names nothing above it is refused") {
    for (const std::string index :
         {"0", "4", "-4", "1/2", "1//2", "1/0", "/1", "x", "1.5", "99999999999999999999", "-9223372036854775808"}) {
        INFO(index);
        CHECK_THROWS_WITH(
            obj(corners + "vt 0 0\nvn 0 0 1\nf 1 2 " + index + "\n"),
            Catch::StartsWith("a.obj:6: expected an index of the ") && Catch::EndsWith("found '" + index + "'"));
    }
    CHECK_THROWS_WITH(obj(corners + "f 1 2 1/2/3/4\n"), "a.obj:4: expected v, v/vt, v//vn or v/vt/vn, found '1/2/3/4'");
    CHECK_THROWS_WITH(obj("f 1 2 3\n" + corners),
                      "a.obj:1: expected an index of the 0 vertices above, from 1 or from -1 back, found '1'");
}

TEST_CASE("OBJ: normals are kept where each vertex has one, and only there") {
    const std::string two_faces = corners + "v 0 0 1\nvn 0 0 1\nvn 0 0 1\nvn 1 0 0\n";
    const auto smooth = obj(two_faces + "f 1//1 2//2 3//3\nf 3//3 2//1 4//1\n");  // normals 1 and 2 are the same
    CHECK(smooth.normals == std::vector<Vec3f>{{0, 0, 1}, {0, 0, 1}, {1, 0, 0}, {0, 0, 1}});
    CHECK(obj(two_faces + "f 1//1 2//1 3//1\nf 3//3 2//1 4//1\n").normals.empty());  // a crease at vertex 3
    CHECK(obj(two_faces + "f 1//1 2//1 3//1\nf 3 2 4\n").normals.empty());
}

TEST_CASE("OBJ: a backslash joins lines, and lines keep their numbers") {
    CHECK(obj(corners + "f 1 \\\n 2\\\r\n 3\n").faces.size() == 1);
    CHECK_THROWS_WITH(obj(corners + "f 1 \\\n 2 3\nf 1 2\n"),
                      "a.obj:6: expected a polygon of at least 3 corners, found 2");
}

TEST_CASE("OBJ: what does not concern polygons is passed over, free-form surfaces and other formats are refused") {
    CHECK(obj("mtllib a\\b.mtl\no x\ng a b#c\ns 1\nusemtl m\nvt 0 0 0\np 1\nl 1 2\n" + corners + "f 1 2 3\n")
              .faces.size() == 1);
    CHECK_THROWS_WITH(obj(corners + "surf 0 1 0 1 1 2 3\n"),
                      Catch::Contains("a.obj:4") && Catch::EndsWith("found 'surf'"));
    CHECK_THROWS_WITH(obj("OFF\n3 1 0\n"), Catch::Contains("a.obj:1") && Catch::EndsWith("found 'OFF'"));
}

TEST_CASE("OBJ: a vertex has three coordinates, and maybe a weight or a colour") {
    CHECK(obj("v 0 0 0 1\nv 1 0 0 0.5 0.5 0.5\nv 0 1 0\nf 1 2 3\n").vertices[1] == Vec3f(1, 0, 0));
    CHECK_THROWS_WITH(obj("v 0 0\n"), "a.obj:1: expected 3 numbers, found 'v 0 0'");
    CHECK_THROWS_WITH(obj("v 0 0 0 blue\n"), "a.obj:1: expected a finite number that fits a float, found 'blue'");
}
