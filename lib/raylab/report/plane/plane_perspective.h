#pragma once

#include "raylab/report/plane/plane_view.h"
#include "raylab/scene/camera.h"

#include <optional>

namespace raylab {

/// Looks at space through a camera, in perspective. The plane is the one at distance 1 before the eye.
class PlanePerspective {
public:
    explicit PlanePerspective(const CameraFrame& frame) : frame_(frame) {}

    /// How far a point lies before the eye; only what is positive can be drawn.
    double depth(const Vec3d& point) const { return dot(point - frame_.eye, frame_.forward); }

    PlanePoint at(const Vec3d& point) const {
        const Vec3d way = point - frame_.eye;
        return {dot(way, frame_.right) / depth(point), dot(way, frame_.up) / depth(point)};
    }

    /// The outline of a convex piece; absent where it reaches behind the eye.
    std::optional<PlaneFigure> figure(const Wires& wires) const;

private:
    CameraFrame frame_;
};

}  // namespace raylab
