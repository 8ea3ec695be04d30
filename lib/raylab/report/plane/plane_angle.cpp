#include "raylab/report/plane/plane_angle.h"
#include "raylab/geometry/degree.h"

#include <cmath>

namespace raylab {

namespace {

double direction(PlanePoint from, PlanePoint to) { return std::atan2(to.y - from.y, to.x - from.x) / degree; }

}  // namespace

PlaneDrawing::Arc angle_arc(PlanePoint corner, PlanePoint from, PlanePoint to, double radius, const PlaneStyle& style) {
    const double first = direction(corner, from);
    const double turn = std::remainder(direction(corner, to) - first, 360.0);
    return {corner, radius, first, first + turn, style};
}

PlaneDrawing::Path right_angle(PlanePoint corner, PlanePoint one, PlanePoint other, double size,
                               const PlaneStyle& style) {
    const auto toward = [&](PlanePoint p) {
        const double length = std::hypot(p.x - corner.x, p.y - corner.y);
        return PlanePoint{size * (p.x - corner.x) / length, size * (p.y - corner.y) / length};
    };
    const PlanePoint a = toward(one), b = toward(other);
    return {{{corner.x + a.x, corner.y + a.y},
             {corner.x + a.x + b.x, corner.y + a.y + b.y},
             {corner.x + b.x, corner.y + b.y}},
            style};
}

PlaneDrawing::Text beside_arc(const PlaneDrawing::Arc& arc, const std::string& words, double pixels, double height) {
    const double middle = (arc.from + arc.to) / 2 * degree, x = std::cos(middle), y = std::sin(middle);
    return {.at = {arc.center.x + arc.radius * x, arc.center.y + arc.radius * y},
            .words = words,
            .height = height,
            .anchor = x > 0.4    ? Anchor::left
                      : x < -0.4 ? Anchor::right
                                 : Anchor::center,
            .aside = {pixels * x, height / 2 - pixels * y}};
}

}  // namespace raylab
