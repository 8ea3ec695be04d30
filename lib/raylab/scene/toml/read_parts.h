#pragma once

#include "raylab/geometry/affine.h"
#include "raylab/scene/scene.h"
#include "raylab/scene/toml/node.h"

// The parts of a scene that depend on no other part, each read from its checked table.

namespace raylab::toml_file {

RenderModel read_model(const Node& node);
ImageSize read_image(const Node& node);
Camera read_camera(const Node& node);
Background read_background(const Node& node);
Material read_material(const Node& node, const std::string& name);
Light read_light(const Node& node);

/// The product of the steps under `transform`, or under another key, first to last; throws an Error for one that is not
/// invertible.
AffineSteps read_transform(const Node& node, const char* key = "transform");

/// Any shape except a mesh.
Shape read_shape(const Node& node);

}  // namespace raylab::toml_file
