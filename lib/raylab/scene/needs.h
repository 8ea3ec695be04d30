#pragma once

#include "raylab/scene/renderer.h"
#include "raylab/scene/scene.h"

#include <nlohmann/json_fwd.hpp>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

// What a picture of a scene needs, computed from the scene alone before any ray is traced, so that no more than that is
// modelled. Whatever is reported as not needed is proven so: without it the picture is the same.
//
// Light paths are written in Heckbert's notation (Adaptive radiosity textures for bidirectional ray tracing, SIGGRAPH
// 1990): L a light, D a diffuse surface (Lambert's term), S a specular one (a highlight, a mirror, a glass), E the eye;
// | or, ? perhaps, + once or more, * any number of times, {1,3} one to three times.

namespace raylab {

struct NeedsOptions {
    double threshold =
        // A ray that can add no more than this to its pixel is not followed; it is one step of an 8-bit picture.
        1.0 / 256;
    int depth_limit = 32;  // used where no threshold ends the recursion; the eye ray has depth 1
    enum class Split {
        as_given,  // a transmitting material reflects kr and transmits kt
        by_angle,  // ... divides kr + kt by the angle (Fresnel)
    } split = Split::as_given;
};

/// A finding and its reason, in words.
struct Note {
    std::string what, why;
};

/// A set of light paths, as a regular expression.
struct LightPath {
    std::string expression, sentence;
};

/// What has to be computed for one light.
struct LightNeeds {
    bool shines = false;       // some visible surface responds to it; false: it can be left out
    bool shadow_rays = false;  // something may stand between it and a point that it lights
    bool distance = false;     // its intensity falls with the distance
    bool cone = false;         // it shines into a cone
    std::string why = {};
};

/// What has to be computed for one material, where it is visible.
struct MaterialNeeds {
    bool seen = false;  // false: no side of any object that a ray can hit has it
    bool ambient = false, diffuse = false, highlight = false, emission = false;
    bool checker = false;  // its diffuse colour depends on the point
    // Its kr, or its kt (kr + kt at total internal reflection), is large enough to follow a ray.
    bool reflection = false, transmission = false;
    bool refraction = false;  // transmitted rays are refracted
};

/// What the recursion needs.
struct RecursionNeeds {
    bool reflection = false, transmission = false;  // some ray is followed that way
    // The largest fraction that a surface passes on: kr or kt, kr + kt at total internal reflection.
    double coefficient = 0;
    bool stopped_by_limit = false;  // rays never become negligible, so depth_limit ends them
    std::string why = {};
};

struct Needs {
    // The facts by which a renderer branches.
    bool eye_rays = false;   // false: every pixel shows the background
    bool shadows = false;    // some light needs shadow rays
    bool recursion = false;  // depth > 1
    // The greatest depth at which a ray is worth following; the eye ray has depth 1.
    int depth = 1;
    bool lens = false;                          // eye rays start from many points of a lens
    bool time = false;                          // eye rays are traced at many times
    std::vector<LightNeeds> lights = {};        // one for each light of the scene
    std::vector<MaterialNeeds> materials = {};  // one for each material of the scene
    RecursionNeeds passed_on = {};
    std::size_t primitives = 0;                // each triangle of a mesh counted
    std::string accelerator = {};              // the name from suited_accelerator()
    Renderer renderer = Renderer::whitted;     // the simplest renderer that draws it by Whitted's model
    RenderModel model = RenderModel::whitted;  // by which `raylab render` draws it

    // The explanation in words.
    std::vector<LightPath> paths = {};         // the paths that the model follows here
    std::vector<LightPath> missed_paths = {};  // those that Whitted's does not, which need another method's chapter
    std::vector<Note> asked = {}, left_out = {};
    std::vector<Note> missed = {};      // what else differs in the picture of Whitted's method from reality
    std::vector<Note> dimensions = {};  // of models that spread rays: what a sample's random numbers are for
    std::vector<Note> unreached = {};   // ... and the light that they do not find
    std::vector<Note> warnings = {};    // probable mistakes in the scene
};

Needs needs_of(const Scene& scene, const NeedsOptions& options = {});

/// The number of primitives of a scene, with each triangle of a mesh counted.
std::size_t primitive_count(const Scene& scene);

/// The accelerator that suits the scene: a list for one or two primitives, a list of boxes for a handful, otherwise a
/// tree, whose boxes move where most primitives do. How many rays will ask it may be known: very many pay for planes
/// that cut triangles, where these leave their boxes mostly empty.
std::string suited_accelerator(const Scene& scene, double rays = 0);

/// The name that was asked for; of "auto" the one that suits.
std::string chosen_accelerator(const std::string& name, const Scene& scene, double rays);

/// The needs as a page of text for people.
std::string to_text(const Needs& needs, const Scene& scene);

nlohmann::ordered_json to_json(const Needs& needs, const Scene& scene);

}  // namespace raylab
