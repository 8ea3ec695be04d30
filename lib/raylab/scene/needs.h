#pragma once

#include "raylab/scene/renderer.h"
#include "raylab/scene/scene.h"

#include <nlohmann/json_fwd.hpp>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

// What a picture of a scene needs, from the scene alone, before any ray: model no more than that. Whatever is said not
// to be needed is proven so: without it the picture is the same.
//
// Light paths are written as Heckbert does (Adaptive radiosity textures for bidirectional ray tracing, SIGGRAPH 1990):
// L a light, D a diffuse surface (Lambert's term), S a specular one (a highlight, a mirror, a glass), E the eye;
// | or, ? perhaps, + once or more, * any number of times, {1,3} one to three times.

namespace raylab {

struct NeedsOptions {
    double threshold =
        1.0 / 256;         // a ray that can add no more to its pixel is not followed: a step of an 8-bit picture
    int depth_limit = 32;  // where no threshold ends the recursion; the eye ray has depth 1
    enum class Split {
        as_given,  // what transmits reflects kr and transmits kt
        by_angle,  // ... shares kr + kt out by the angle (Fresnel)
    } split = Split::as_given;
};

/// Something, and why: in words.
struct Note {
    std::string what, why;
};

/// A set of light paths, as a regular expression.
struct LightPath {
    std::string expression, sentence;
};

/// What one light asks for.
struct LightNeeds {
    bool shines = false;       // something seen answers to it; false: leave it out
    bool shadow_rays = false;  // something may stand between it and a point that it lights
    bool distance = false;     // it grows weaker with the distance
    bool cone = false;         // it shines into a cone
    std::string why = {};
};

/// What one material asks for, where it is seen.
struct MaterialNeeds {
    bool seen = false;  // false: on no side of any object that a ray can meet
    bool ambient = false, diffuse = false, highlight = false, emission = false;
    bool checker = false;                           // its diffuse colour depends on the point
    bool reflection = false, transmission = false;  // its kr, its kt (kr + kt on total reflection) is worth a ray
    bool refraction = false;                        // transmitted rays are bent
};

/// The recursion.
struct RecursionNeeds {
    bool reflection = false, transmission = false;  // some ray goes on that way
    double coefficient = 0;         // the largest share that a surface passes on: kr or kt, kr + kt on total reflection
    bool stopped_by_limit = false;  // no depth makes the rays negligible: depth_limit ends them
    std::string why = {};
};

struct Needs {
    // What a renderer branches on.
    bool eye_rays = false;                // false: every pixel shows the background
    bool shadows = false;                 // some light asks for shadow rays
    bool recursion = false;               // depth > 1
    int depth = 1;                        // the largest at which a ray is worth following; the eye ray has depth 1
    bool lens = false;                    // eye rays through many points of a lens
    bool time = false;                    // eye rays at many times
    std::vector<LightNeeds> lights = {};  // one for each of the scene's
    std::vector<MaterialNeeds> materials = {};  // one for each of the scene's
    RecursionNeeds passed_on = {};
    std::size_t primitives = 0;    // meshes taken apart
    std::string accelerator = {};  // as suited_accelerator has it
    Renderer renderer = Renderer::whitted;  // the least that draws it

    // In words.
    std::vector<LightPath> paths = {};         // what Whitted's method models here
    std::vector<LightPath> missed_paths = {};  // what the scene has besides: another method's chapters
    std::vector<Note> asked = {}, left_out = {};
    std::vector<Note> missed = {};    // what else Whitted's method shows otherwise than it is
    std::vector<Note> warnings = {};  // what is probably a mistake in the scene
};

Needs needs_of(const Scene& scene, const NeedsOptions& options = {});

/// How many primitives a scene has, meshes taken apart.
std::size_t primitive_count(const Scene& scene);

/// The accelerator that suits the scene: a list of one or two primitives, of boxes for a handful, else a tree.
std::string suited_accelerator(const Scene& scene);

/// For people, a page of lines.
std::string to_text(const Needs& needs, const Scene& scene);

nlohmann::ordered_json to_json(const Needs& needs, const Scene& scene);

}  // namespace raylab
