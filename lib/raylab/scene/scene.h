#pragma once

#include "raylab/geometry/affine.h"
#include "raylab/geometry/shapes.h"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

// A scene as one value: metres, degrees, seconds, linear RGB. Readers (TOML, NFF, mesh files) create it; nothing else
// needs to know which.

namespace raylab {

using Color = Vec3d;  // linear RGB, Rec. 709 primaries

struct ImageSize {
    int width = 640, height = 480;
};

/// A thin lens: points at distance `focus` along the view axis are sharp. Metres.
struct Lens {
    double radius, focus;
};

/// Eye rays have times between these, in seconds.
struct Shutter {
    double open, close;
};

struct Perspective {
    double fov_y = 40;  // degrees, between the top and the bottom edge of the picture; 0 < fov_y < 180
};

struct Orthographic {
    double height = 2;  // of the picture, in metres
};

struct Camera {
    Vec3d position{0, 0, 5}, target{0, 0, 0}, up{0, 1, 0};
    std::variant<Perspective, Orthographic> projection = Perspective{};
    std::optional<Lens> lens = {};        // absent: pinhole
    std::optional<Shutter> shutter = {};  // absent: all eye rays have the same time
};

struct Checker {
    Color a, b;
    double size;  // edge of a cell, in metres
};

using Pigment = std::variant<Color, Checker>;

/// A perfect mirror, and perfectly clear glass.
struct Sharp {};

/// Rays spread around the mirrored or the refracted direction with the density of cos^exponent (Phong's lobe).
struct Gloss {
    double exponent;
};

/// Microscopic facets mirror and refract; alpha = value^2 (Walter et al., "Microfacet Models for Refraction through
/// Rough Surfaces", 2007: GGX).
struct Roughness {
    double value;
};

using Polish = std::variant<Sharp, Gloss, Roughness>;

/// The coefficients of Whitted's model; kr + kt <= 1.
struct Material {
    std::string name;
    Color ambient{0, 0, 0};
    Pigment diffuse = Color{0.8, 0.8, 0.8};
    Color specular{0, 0, 0};
    double shininess = 1;
    double kr = 0, kt = 0, ior = 1;
    int priority = 0;  // where transparent objects overlap, the medium of the one with the highest priority counts
    Color emission{0, 0, 0};  // the radiance that it sends in all directions
    Polish polish = Sharp{};  // how kr and kt spread
};

struct PointLight {
    Vec3d position;
};

struct SpotLight {
    Vec3d position, target;
    double cone = 30;     // half angle in degrees; there is no light outside
    double exponent = 0;  // the intensity is cos^exponent inside; 0: uniform
};

struct DistantLight {
    Vec3d direction;  // the direction in which the light travels
};

struct Light {
    std::variant<PointLight, SpotLight, DistantLight> kind;
    Color color{1, 1, 1};
    Vec3d attenuation{1, 0, 0};  // constant, linear and quadratic coefficient
};

/// How the shading of a mesh's triangles is computed; where its vertices have no normals, all are flat.
enum class Shading {
    flat,     // with the triangle's own normal
    gouraud,  // at the vertices with their normals; colours are interpolated
    phong,    // with the interpolated normal of the vertices
};

/// A shape at its place; Primitive::object is its index. Groups and instances are flattened into objects, in the order
/// of the file; a mesh that is used often is one shared Mesh.
struct Object {
    Shape shape;
    Affine placement;       // the identity where the scene gives no transform
    std::size_t front = 0;  // indices into Scene::materials
    std::size_t back = 0;
    Sides sides = Sides::both;
    Shading shading = Shading::phong;   // used for meshes
    std::string path = {};              // "sphere 3", "pair[2]/sphere 0": a name for people
    std::optional<Motion> motion = {};  // the placement is the one of time 0; absent: at rest
};

/// The largest number of objects that readers make of one file: instances within instances grow exponentially, and
/// memory is finite.
inline constexpr std::size_t max_objects = std::size_t{1} << 20;

struct Background {
    Color color{0, 0, 0};
    Color ambient{0, 0, 0};
    // Straight up, along y; on the horizon and below it is `color` (background.h). Absent: `color` everywhere.
    std::optional<Color> zenith = {};
};

/// How light is followed.
enum class RenderModel {
    automatic,    // distributed if a lens, a motion in a shutter, gloss, roughness or emission is there, otherwise
                  // whitted
    whitted,      // one ray for each question (chapter 07)
    distributed,  // rays spread over pixel, lens, time, lobe and light (chapter 15)
    path,         // and over diffuse surfaces: all of the light
};

struct Scene {
    std::string source;  // the file it was read from
    RenderModel model = RenderModel::automatic;
    ImageSize image;
    Camera camera;
    Background background;
    std::vector<Material> materials;
    std::vector<Light> lights;
    std::vector<Object> objects;
    std::vector<std::filesystem::path> files_read = {};  // beside `source`: included scenes and meshes
};

}  // namespace raylab
