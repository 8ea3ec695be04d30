#include "raylab/report/plane/plane_view.h"

#include "raylab/report/plane/plane_hull.h"

#include <algorithm>
#include <cmath>

namespace raylab {

namespace {

Wires wires_of(const Vec3d& center, const std::array<Vec3d, 3>& half_axes) {
    Wires wires;
    for (std::size_t corner = 0; corner < 8; ++corner) {
        Vec3d point = center;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const std::size_t bit = std::size_t{1} << axis;
            point += (corner & bit) ? half_axes[axis] : -half_axes[axis];
            if (!(corner & bit)) wires.edges.push_back({corner, corner | bit});
        }
        wires.points.push_back(point);
    }
    return wires;
}

Wires wires_of(const Box& box, const Box& shown) {
    const Vec3d low = glm::clamp(convert<double>(box.min), convert<double>(shown.min), convert<double>(shown.max));
    const Vec3d high = glm::clamp(convert<double>(box.max), convert<double>(shown.min), convert<double>(shown.max));
    const Vec3d half = (high - low) * 0.5;
    return wires_of((low + high) * 0.5, {Vec3d{half.x, 0, 0}, Vec3d{0, half.y, 0}, Vec3d{0, 0, half.z}});
}

}  // namespace

PlaneView::PlaneView(int along, std::optional<double> slice, const Box& shown)
    : along_(along), slice_(slice), shown_(shown) {}

PlanePoint PlaneView::at(const Vec3d& p) const {
    if (along_ == 0) return {-p.z, p.y};
    if (along_ == 1) return {p.x, -p.z};
    return {p.x, p.y};
}

std::optional<PlaneFigure> PlaneView::figure(const Wires& wires) const {
    std::vector<PlanePoint> points;
    if (!slice_) {
        for (const Vec3d& point : wires.points) points.push_back(at(point));
    } else {
        const auto beyond = [&](std::size_t i) { return wires.points[i][along_] - *slice_; };
        for (const auto& [a, b] : wires.edges) {
            const double from = beyond(a), to = beyond(b);
            if ((from < 0) == (to < 0)) continue;
            points.push_back(at(wires.points[a] + (wires.points[b] - wires.points[a]) * (from / (from - to))));
        }
        if (points.empty()) return std::nullopt;
    }
    return PlanePolygon{convex_hull(points)};
}

std::optional<PlaneFigure> PlaneView::figure(const Bound& bound) const {
    if (const auto* box = std::get_if<Box>(&bound)) return figure(wires_of(*box, shown_));
    if (const auto* oriented = std::get_if<OrientedBox>(&bound)) {
        std::array<Vec3d, 3> axes;
        for (std::size_t i = 0; i < 3; ++i) axes[i] = convert<double>(oriented->half_axes[i]);
        return figure(wires_of(convert<double>(oriented->center), axes));
    }
    const Sphere& sphere = std::get<Sphere>(bound);
    const Vec3d center = convert<double>(sphere.center);
    const double away = slice_ ? center[along_] - *slice_ : 0,
                 squared = double{sphere.radius} * sphere.radius - away * away;
    if (squared < 0) return std::nullopt;
    return PlaneCircle{at(center), std::sqrt(squared)};
}

}  // namespace raylab
