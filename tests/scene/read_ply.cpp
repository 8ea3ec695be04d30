#include "catch.h"
#include "raylab/base/bytes.h"
#include "raylab/scene/mesh/read_mesh.h"

using namespace raylab;

namespace {

const std::string xyz = "property float x\nproperty float y\nproperty float z\n";
const std::string three = "element vertex 3\n" + xyz;
const std::string one_face = "element face 1\nproperty list uchar int vertex_indices\n";
const std::string triangle = "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";

Mesh ply(const std::string& bytes) { return read_mesh_bytes(bytes, MeshFormat::ply, "a.ply"); }

std::string text(const std::string& header, const std::string& body) {
    return "ply\nformat ascii 1.0\n" + header + "end_header\n" + body;
}

// Three vertices of doubles, of which one number is given.
std::string doubles(double number) {
    std::string bytes = "ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty double x\nproperty double y\n"
                        "property double z\nelement face 1\nproperty list uchar uchar vertex_index\nend_header\n";
    for (const double value : {0., 0., 0., 1., 0., 0., 0., 1., number})
        append_number(bytes, value, std::endian::little);
    return bytes + std::string{3, 0, 1, 2};
}

}  // namespace

TEST_CASE("PLY: properties stand in any order and type, elements in any order") {
    const auto mesh =
        ply(text("element face 1\nproperty list int uint8 vertex_index\nelement vertex 3\nproperty int z\n"
                 "property double y\nproperty uchar x\n",
                 "3 2 0 1\n3 2 1\n6 5 4\n9 8 7\n"));
    CHECK(mesh.vertices == std::vector<Vec3f>{{1, 2, 3}, {4, 5, 6}, {7, 8, 9}});
    CHECK(mesh.faces[0].a == 2);
}

TEST_CASE("PLY: the last line may lack its end, whichever element it is of") {
    CHECK(ply(text(one_face + three, "3 0 1 2\n0 0 0\n1 0 0\n0 1 0")).vertices.size() == 3);
    CHECK(ply(text(three + one_face, "0 0 0\n1 0 0\n0 1 0\n3 0 1 2")).faces.size() == 1);
}

TEST_CASE("PLY: normals are kept where all three of their properties are there") {
    const std::string normals = "property float nx\nproperty float ny\n";
    const auto with = ply(text("element vertex 3\n" + xyz + normals + "property float nz\n" + one_face,
                               "0 0 0 0 0 1\n1 0 0 0 0 2\n0 1 0 0 0 3\n3 0 1 2\n"));
    CHECK(with.normals == std::vector<Vec3f>{{0, 0, 1}, {0, 0, 2}, {0, 0, 3}});
    const auto without =
        ply(text("element vertex 3\n" + xyz + normals + one_face, "0 0 0 0 0\n1 0 0 0 0\n0 1 0 0 0\n3 0 1 2\n"));
    CHECK(without.normals.empty());
}

TEST_CASE("PLY: doubles are rounded to the nearest float, and refused where that is none") {
    CHECK(ply(doubles(0.1)).vertices[2].z == 0.1f);
    CHECK(ply(doubles(1e-300)).vertices[2].z == 0.0f);
    CHECK(ply(doubles(0x1.fffffefffffffp127)).vertices[2].z == 0x1.fffffep127f);
    for (const double number : {0x1.ffffffp127, -1e300, std::numeric_limits<double>::infinity(), std::nan("")}) {
        INFO(number);
        CHECK_THROWS_WITH(ply(doubles(number)), Catch::Contains("(vertex 2): expected three finite numbers"));
    }
}

TEST_CASE("PLY: bytes cut short are missed where they are passed over, too") {
    std::string bytes =
        "ply\nformat binary_little_endian 1.0\nelement face 1\nproperty list uchar uchar vertex_index\nelement vertex "
        "3\n" +
        xyz + "element more 1\nproperty list uchar double of\nproperty double further\nend_header\n" +
        std::string{3, 0, 1, 2};
    for (const float value : {0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 0.f})
        append_number(bytes, value, std::endian::little);
    bytes += '\1';  // of a double
    for (const double value : {6.0, 7.0}) append_number(bytes, value, std::endian::little);
    CHECK(ply(bytes).faces.size() == 1);
    for (std::size_t left = 1; left < 8; ++left) {
        INFO(left << " bytes of the last number");
        CHECK_THROWS_WITH(ply(bytes.substr(0, bytes.size() - left)), Catch::Contains("expected 8 more bytes"));
    }
}

TEST_CASE("PLY: bytes begin right after the line end of the header, whatever ends its lines") {
    for (const std::string end : {"\n", "\r\n", "\r"}) {
        std::string bytes;
        for (const std::string line :
             {"ply", "format binary_big_endian 1.0", "element vertex 3", "property char x", "property char y",
              "property char z", "element face 1", "property list uchar uchar vertex_index", "end_header"})
            bytes += line + end;
        bytes += std::string{'\n', 1, 2, 3, 4, 5, 6, 7, 8, 3, 0, 1, 2};  // the first number looks like a line end
        CHECK(ply(bytes).vertices[0] == Vec3f(10, 1, 2));
    }
}

TEST_CASE("PLY: what a mesh needs must be there") {
    CHECK_THROWS_WITH(ply(text(three, "0 0 0\n1 0 0\n0 1 0\n")),
                      "a.ply:7: expected an element face with a list vertex_indices of integers, found none");
    CHECK_THROWS_WITH(ply(text(one_face, "3 0 1 2\n")),
                      "a.ply:5: expected an element vertex with x, y and z, found none");
    CHECK_THROWS_WITH(ply(text(three + "element face 1\nproperty list uchar float vertex_indices\n", triangle)),
                      Catch::Contains("a list vertex_indices of integers"));
}

TEST_CASE("PLY: a row holds what the header says, neither less nor more") {
    CHECK_THROWS_WITH(ply(text(three + one_face, "0 0\n1 0 0\n0 1 0\n3 0 1 2\n")),
                      "a.ply:10: expected more values on the line, found 2");
    CHECK_THROWS_WITH(ply(text(three + one_face, "0 0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n")),
                      "a.ply:10: expected the end of the line, found '0'");
    CHECK_THROWS_WITH(ply(text(three + one_face, "0 0 0\n1 0 0\n0 1 0\n4 0 1 2\n")),
                      "a.ply:13: expected a list of at most 3 items (what is left), found 4");
    CHECK_THROWS_WITH(ply(text(three + one_face, "0 0 0\n1 0 0\n0 1 0\n          ")),
                      "a.ply:13: expected face 0, found the end of the file");
    CHECK_THROWS_WITH(ply(text(three + one_face, triangle + "9\n")),
                      "a.ply:14: expected the end of the file, found '9'");
}

TEST_CASE("PLY: more elements and properties than any file has are refused at the line of the first too many") {
    std::string properties = "ply\nformat ascii 1.0\nelement vertex 1\n", elements = "ply\nformat ascii 1.0\n";
    for (int i = 0; i < 80'000; ++i) properties += "property float p" + std::to_string(i) + "\n";
    for (int i = 0; i < 80'000; ++i) elements += "element e" + std::to_string(i) + " 0\nproperty float x\n";
    CHECK_THROWS_WITH(
        ply(properties + "end_header\n1\n"),
        Catch::Contains("a.ply:1028: expected at most 1024 properties of an element, found 'property float"));
    CHECK_THROWS_WITH(ply(elements + "end_header\n"),
                      Catch::Contains("a.ply:515: expected at most 256 elements, found 'element e256 0'"));
}

TEST_CASE("PLY: a header that does not follow the grammar is refused") {
    const auto refused = [](const std::string& header, const std::string& message) {
        INFO(header);
        CHECK_THROWS_WITH(ply(text(header, "")), Catch::Contains(message));
    };
    refused("element vertex\n", "expected 'element NAME COUNT', found 'element vertex'");
    refused("property float x\n", "found 'property'");
    refused(three + "property float x\n", "expected a property not named before, found 'x'");
    refused(three + three, "expected an element not named before, found 'vertex'");
    refused("element vertex 3\nproperty half x\n", "expected a type such as float, uchar or int32, found 'half'");
    refused("element vertex 3\nproperty list float int x\n",
            "expected an integer type for the length of a list, found 'float'");
    refused("element vertex 3\nproperty list uchar int\n", "expected 'property list COUNT_TYPE TYPE NAME'");
    refused("element empty 1000000000000\n" + three, "expected a property of element 'empty' before the header's end");
    refused("format ascii 1.0\n", "found 'format'");
    CHECK_THROWS_WITH(ply("ply\nformat binary_middle_endian 1.0\n"), Catch::EndsWith("found 'binary_middle_endian'"));
    CHECK_THROWS_WITH(ply("ply\nformat ascii 2.0\n"), "a.ply:2: expected version 1.0, found '2.0'");
    CHECK_THROWS_WITH(ply("ply\nelement vertex 3\n"), Catch::Contains("the end of the file"));
    CHECK_THROWS_WITH(ply("ply\n" + three + "end_header\n"),
                      Catch::Contains("expected a format before the header's end"));
}
