#include "raylab/report/plane/plane_perspective.h"

#include "raylab/report/plane/plane_hull.h"

#include <algorithm>

namespace raylab {

std::optional<PlaneFigure> PlanePerspective::figure(const Wires& wires) const {
    const auto is_behind = [&](const Vec3d& point) { return !(depth(point) > 0); };
    if (std::ranges::any_of(wires.points, is_behind)) return std::nullopt;
    std::vector<PlanePoint> points;
    for (const Vec3d& point : wires.points) points.push_back(at(point));
    return PlanePolygon{convex_hull(points)};
}

}  // namespace raylab
