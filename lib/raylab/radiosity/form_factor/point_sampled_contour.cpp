#include "raylab/radiosity/form_factor/point_sampled_contour.h"

#include "raylab/radiosity/form_factor/contour_form_factor.h"
#include "raylab/radiosity/form_factor/convex_polygon.h"

namespace raylab {

double point_sampled_contour(std::span<const PolygonPoint> points, const Vec3d& normal, std::span<const Vec3d> to) {
    double sent = 0, area = 0;
    for (const PolygonPoint& point : points) {
        sent += point.area * contour_form_factor(point.position, normal, to);
        area += point.area;
    }
    return sent / area;
}

double point_sampled_contour(std::span<const Vec3d> from, std::span<const Vec3d> to, int per_side) {
    return point_sampled_contour(gauss_points(from, per_side), polygon_normal(from), to);
}

}  // namespace raylab
