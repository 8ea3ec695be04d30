#pragma once

#include "raylab/radiosity/hierarchical_scene.h"
#include "raylab/radiosity/picture_error.h"
#include "raylab/radiosity/scene_radiosity.h"

#include <string>
#include <variant>
#include <vector>

namespace raylab {

/// A scene solved within an error, and what was tried on the way.
struct RadiosityWithin {
    std::variant<SceneRadiosity, SceneHierarchy> solved;
    PictureError error;
    struct Attempt {
        std::string mesh;  // "equal patches"
        std::size_t patches;
        double error, seconds;
    };
    std::vector<Attempt> attempts;  // the last is the answer
};

/// Solves a scene so that its picture's estimated error (picture_error()) is at most `error`, by the cheaper of two
/// ways: equal patches with the whole matrix, or hierarchical radiosity. Coarse attempts tell how fine the next must be
/// and what it will take. Of the options the sizes of
/// patches and the tolerance of links are not asked. It throws an Error as scene_radiosity() does, and one that says
/// how near it came where patches and memory do not suffice.
RadiosityWithin radiosity_within(const Scene& scene, double error, const SceneRadiosityOptions& of_matrix,
                                 const SceneHierarchyOptions& of_links);

}  // namespace raylab
