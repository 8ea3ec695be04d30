#pragma once

#include "raylab/scene/scene.h"

#include <cstdint>
#include <vector>

namespace raylab {

/// A flat piece of a scene's surface, from which patches are cut.
struct Facet {
    std::vector<Vec3d> corners;  // 3 or 4 in one plane, convex, counter-clockwise seen from the front; metres
    std::uint32_t object, part;  // of the scene: an index in Scene::objects, a triangle of a mesh or a Part
    std::uint32_t occluder;      // an index in PolygonalModel::scene.objects: the polygon that it belongs to
    std::uint32_t smooth;        // facets of one number meet without an edge, so their vertices are shared
};

/// A scene made of polygons alone, since a patch is flat. Shadow rays and eye rays ask this scene, so what sends light,
/// what stops it and what is seen are one geometry.
struct PolygonalModel {
    Scene scene;  // every object is a polygon or a triangle at rest, with the materials, sides and path of its original
    std::vector<Facet> facets;
    double error = 0;  // how far a facet may lie from the surface it stands for, metres
};

/// Replaces each shape by flat pieces. A curved one gets pieces of at most `edge` metres, with their corners on the
/// surface, and at least twelve around. It throws an Error for an infinite plane, whose pieces have no end, and for
/// more than a million pieces.
PolygonalModel polygonal_model(const Scene& scene, double edge);

}  // namespace raylab
