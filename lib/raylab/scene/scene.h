#pragma once

#include "raylab/geometry/affine.h"
#include "raylab/geometry/shapes.h"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

// A scene as one value: metres, degrees, seconds, linear RGB. Readers (TOML, NFF, mesh files) make it, nothing else
// needs to know where it came from.

namespace raylab {

using Color = Vec3d;  // linear RGB, Rec. 709 primaries

struct ImageSize {
    int width = 640, height = 480;
};

struct Lens {
    double radius, focus;
};

struct Shutter {
    double open, close;
};

struct Perspective {
    double fov_y = 40;  // degrees, between the top and the bottom edge of the picture; 0 < fov_y < 180
};

struct Orthographic {
    double height = 2;  // metres, of the picture
};

struct Camera {
    Vec3d position{0, 0, 5}, target{0, 0, 0}, up{0, 1, 0};
    std::variant<Perspective, Orthographic> projection = Perspective{};
    std::optional<Lens> lens = {};        // absent: pinhole
    std::optional<Shutter> shutter = {};  // absent: an instant
};

struct Checker {
    Color a, b;
    double size;  // metres, edge of a cell
};

using Pigment = std::variant<Color, Checker>;

/// Whitted's terms; kr + kt <= 1.
struct Material {
    std::string name;
    Color ambient{0, 0, 0};
    Pigment diffuse = Color{0.8, 0.8, 0.8};
    Color specular{0, 0, 0};
    double shininess = 1;
    double kr = 0, kt = 0, ior = 1;
    int priority = 0;  // where transparent objects overlap, the matter of the highest one counts
    Color emission{0, 0, 0};
};

struct PointLight {
    Vec3d position;
};

struct SpotLight {
    Vec3d position, target;
    double cone = 30;     // degrees, half angle; nothing outside
    double exponent = 0;  // cos^exponent inside; 0: uniform
};

struct DistantLight {
    Vec3d direction;  // the way the light travels
};

struct Light {
    std::variant<PointLight, SpotLight, DistantLight> kind;
    Color color{1, 1, 1};
    Vec3d attenuation{1, 0, 0};  // constant, linear, quadratic
};

/// How light is reckoned on a mesh's triangles; where its vertices have no normals, all are flat.
enum class Shading {
    flat,     // by the triangle's own normal
    gouraud,  // at the vertices by theirs, and colours in between
    phong,    // by a normal between those of the vertices
};

/// A shape at its place: what a Primitive's `object` counts. Groups and instances are flattened into these, in the
/// order of the file; a mesh used often is one shared Mesh.
struct Object {
    Shape shape;
    Affine placement;       // identity where the scene gives no transform
    std::size_t front = 0;  // indices into Scene::materials
    std::size_t back = 0;
    Sides sides = Sides::both;
    Shading shading = Shading::phong;  // of a mesh
    std::string path = {};             // "sphere 3", "pair[2]/sphere 0": for people
    std::optional<Vec3d> motion = {};  // metres per second; absent: at rest
};

/// What readers make of one file at most: instances in instances grow exponentially, memory does not.
inline constexpr std::size_t most_objects = std::size_t{1} << 20;

struct Background {
    Color color{0, 0, 0};
    Color ambient{0, 0, 0};
};

struct Scene {
    std::string source;  // the file it was read from
    ImageSize image;
    Camera camera;
    Background background;
    std::vector<Material> materials;
    std::vector<Light> lights;
    std::vector<Object> objects;
    std::vector<std::filesystem::path> mesh_files = {};  // that were read for it
};

}  // namespace raylab
