#pragma once

#include "raylab/accelerator/light_buffer/light_pyramid.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace raylab {

/// The outline of a primitive as a light sees it: it lies within `blur` of the convex hull of some corners, all seen
/// from the light. Its answers are proofs: what they deny may yet be so.
///
/// A plane through the light with normal n has the whole shape on its one side, up to a little, where n . corner >= 0
/// for all corners, up to a little; how little is computed, and every rounding is added to it. So n itself may be any
/// vector, computed carelessly: a bad one proves nothing. Of all planes that might keep two convex cones apart, those
/// through an edge of one of them suffice. No corner is projected, so none is divided by a depth that may be zero or
/// negative.
class Silhouette {
public:
    /// A hull from the light; distances in metres.
    struct Hull {
        struct Edge {
            std::size_t from, to;
        };
        std::vector<Vec3d> corners = {};
        std::vector<Edge> edges = {};          // of a flat shape: all around
        std::vector<Vec3d> face_normals = {};  // one: it is flat
        double blur = 0;                       // how far beyond the hull it may reach; of a ball: by which it is off
        double ball = 0;                       // a ball's radius, about the one corner
        enum class Covers {
            perhaps,
            never
        } covers = Covers::never;  // whether it stops whatever crosses it, and is convex
    };
    explicit Silhouette(Hull hull);

    /// No point of the shape, blurred, is nearer to the light than this.
    double nearest() const { return nearest_; }

    /// Whether nothing of the blurred shape is inside the pyramid, surely.
    bool is_outside(const LightPyramid& pyramid) const;

    /// The same question, answered by the pyramid's own planes alone, as by a rectangle about the shape.
    bool is_outside_by_sides(const LightPyramid& pyramid) const;

    /// No point of the blurred shape inside the pyramid is less deep than this.
    double min_depth(const LightPyramid& pyramid) const;

    /// The depth beyond which every way to the light inside the pyramid is stopped by the shape, surely: even if it
    /// strays by as much as the blur, and ends half as much before the light.
    std::optional<double> cover_depth(const LightPyramid& pyramid) const;

private:
    struct Half {  // a plane through the light
        Vec3d normal;
        double bound;
    };

    bool is_ball() const { return hull_.ball > 0; }
    double smallest(const Vec3d& normal, double length) const;
    double smallest(const Vec3d& normal) const { return smallest(normal, glm::length(normal)); }
    double greatest(const Vec3d& normal) const { return -smallest(-normal); }
    Half half(const Vec3d& normal) const;
    void find_nearest();
    void find_halves();
    void find_cover();
    Half tangent(const LightPyramid& pyramid) const;
    bool is_outside_by_edges(const LightPyramid& pyramid) const;
    std::optional<double> cover_depth_of_flat(const LightPyramid& pyramid) const;
    std::optional<double> cover_depth_of_ball(const LightPyramid& pyramid) const;

    Hull hull_;
    double reach_;        // blur and ball
    double margin_ = 0;   // reach_ and the rounding error of a dot product with a unit vector
    double largest_ = 0;  // of the corners' lengths
    double nearest_ = 0, farthest_ = 0;
    std::vector<Half> outside_;     // directions c with n . c < bound, for any of them, hit nothing of the shape
    std::vector<Half> inside_;      // directions c with n . c > bound, for all of them, hit it; none: unknown
    Vec3d normal_{0};               // of what is flat, unit, away from the light
    double height_ = 0;             // of its plane over the light, at least
    Vec3d way_{0};                  // to a ball's centre, unit
    double sine_ = 0, cosine_ = 0;  // of the angle that half of it fills, or a little more
};

}  // namespace raylab
