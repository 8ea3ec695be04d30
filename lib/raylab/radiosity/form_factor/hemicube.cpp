#include "raylab/radiosity/form_factor/hemicube.h"

#include "raylab/radiosity/form_factor/convex_polygon.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

namespace raylab {

namespace {

// A face's axes: a pixel's ray goes along forward + x across + y rise.
struct FaceAxes {
    Vec3d forward, across, rise;
    double lowest;  // of y: -1 on the whole face, 0 on the halves; x and y go up to 1
};

std::array<FaceAxes, 5> face_axes(const Vec3d& normal, const Vec3d& up) {
    const Vec3d right = cross(up, normal);
    return {FaceAxes{normal, right, up, -1}, FaceAxes{right, -up, normal, 0}, FaceAxes{up, right, normal, 0},
            FaceAxes{-right, up, normal, 0}, FaceAxes{-up, -right, normal, 0}};
}

// A polygon seen from the point, which is the origin.
struct SeenPolygon {
    std::vector<Vec3d> vertices, edge_planes;  // the planes through the origin and an edge, by normals to the outside
    Vec3d area_vector;
    double offset;  // the plane of the polygon is dot(area_vector, x) = offset

    // The distance of the polygon along a direction, in the direction's lengths; absent where the ray misses.
    std::optional<double> distance(const Vec3d& direction) const {
        for (const Vec3d& plane : edge_planes)
            if (dot(plane, direction) > 0) return std::nullopt;
        return offset / dot(area_vector, direction);
    }
};

// Absent where the polygon is seen from behind or edge-on, or is below the horizon.
std::optional<SeenPolygon> seen_from(const Vec3d& point, const Vec3d& normal, std::span<const Vec3d> polygon) {
    const auto is_below = [&](const Vec3d& vertex) { return dot(normal, vertex - point) <= 0; };
    const Vec3d area = area_vector(polygon);
    const double offset = dot(area, polygon[0] - point);
    const double closest = std::max(rounding_height(polygon), 1e-14 * glm::length(point));
    if (-offset <= closest * glm::length(area) || std::ranges::all_of(polygon, is_below)) return std::nullopt;

    SeenPolygon seen{{}, {}, area, offset};
    for (const Vec3d& vertex : polygon) seen.vertices.push_back(vertex - point);
    for (std::size_t i = 0; i < polygon.size(); ++i)
        seen.edge_planes.push_back(cross(seen.vertices[i], seen.vertices[(i + 1) % polygon.size()]));
    return seen;
}

// Pixels from `first` to `last` - 1.
struct PixelSpan {
    int first, last;
};

// The pixels whose middles may lie between two places in [low, 1]; one more on either side covers the rounding.
PixelSpan pixels_between(double from, double to, double low, int count) {
    const double scale = count / (1 - low);
    return {std::max(0, static_cast<int>(std::floor((from - low) * scale)) - 1),
            std::min(count, static_cast<int>(std::ceil((to - low) * scale)) + 1)};
}

// The part of a face that a polygon may cover: columns, and rows from below.
struct Extent {
    PixelSpan columns, rows;
};

Extent extent_on(const FaceAxes& axes, const SeenPolygon& polygon, int columns, int rows) {
    const std::array inward{axes.forward - axes.across, axes.forward + axes.across, axes.forward - axes.rise,
                            axes.rise - axes.lowest * axes.forward};
    const auto all_outside = [&](const Vec3d& plane) {
        return std::ranges::all_of(polygon.vertices, [&](const Vec3d& vertex) { return dot(plane, vertex) <= 0; });
    };
    if (std::ranges::any_of(inward, all_outside)) return {{0, 0}, {0, 0}};  // most polygons: nothing is allocated

    std::vector<Vec3d> visible = polygon.vertices;
    for (const Vec3d& plane : inward) {
        visible = clipped_to_front(visible, {Vec3d{0, 0, 0}, plane}, 0);
        if (visible.empty()) return {{0, 0}, {0, 0}};
    }
    double left = 1, right = -1, bottom = 1, top = axes.lowest;
    for (const Vec3d& vertex : visible) {
        const double depth = dot(axes.forward, vertex);
        const double x = dot(axes.across, vertex) / depth, y = dot(axes.rise, vertex) / depth;
        if (!(depth > 0)) return {{0, columns}, {0, rows}};
        left = std::min(left, x);
        right = std::max(right, x);
        bottom = std::min(bottom, y);
        top = std::max(top, y);
    }
    return {pixels_between(left, right, -1, columns), pixels_between(bottom, top, axes.lowest, rows)};
}

// The share of a patch's light through a pixel at x and y (Cohen and Greenberg's two formulas; the face along the
// normal has its cosine 1 in the place of y).
double delta_factor(const FaceAxes& axes, double x, double y, double pixel_area) {
    const double squared = 1 + x * x + y * y;
    return (axes.lowest < 0 ? 1 : y) * pixel_area / (std::numbers::pi * squared * squared);
}

HemicubeFace look_through(const FaceAxes& axes, const std::vector<std::optional<SeenPolygon>>& polygons,
                          int resolution) {
    const double side = 2.0 / resolution;
    const int columns = resolution, rows = axes.lowest < 0 ? resolution : resolution / 2;
    const auto x_of = [&](int column) { return (column + 0.5) * side - 1; };
    const auto y_of = [&](int row) { return (row + 0.5) * side + axes.lowest; };  // rows from below
    const auto number = [&](int column, int row) {
        return static_cast<std::size_t>((rows - 1 - row) * columns + column);
    };

    const auto pixels = static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows);
    HemicubeFace face{columns, rows, std::vector<int>(pixels, HemicubeFace::nothing_seen), std::vector<double>(pixels)};
    std::vector<double> depth(pixels, std::numeric_limits<double>::infinity());
    for (std::size_t i = 0; i < polygons.size(); ++i) {
        if (!polygons[i]) continue;
        const Extent extent = extent_on(axes, *polygons[i], columns, rows);
        for (int row = extent.rows.first; row < extent.rows.last; ++row)
            for (int column = extent.columns.first; column < extent.columns.last; ++column) {
                const auto distance =
                    polygons[i]->distance(axes.forward + x_of(column) * axes.across + y_of(row) * axes.rise);
                const std::size_t pixel = number(column, row);
                if (!distance || !(*distance < depth[pixel])) continue;
                depth[pixel] = *distance;
                face.nearest[pixel] = static_cast<int>(i);
            }
    }
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column)
            face.delta_factors[number(column, row)] = delta_factor(axes, x_of(column), y_of(row), side * side);
    return face;
}

}  // namespace

Hemicube hemicube(const Vec3d& point, const Vec3d& normal, const Vec3d& up,
                  std::span<const std::span<const Vec3d>> polygons, int resolution) {
    assert(resolution > 0 && resolution % 2 == 0);
    std::vector<std::optional<SeenPolygon>> seen;
    for (const auto& polygon : polygons) seen.push_back(seen_from(point, normal, polygon));
    Hemicube view{};
    const auto axes = face_axes(normal, up);
    for (std::size_t i = 0; i < axes.size(); ++i) view.faces[i] = look_through(axes[i], seen, resolution);
    return view;
}

std::vector<double> form_factor_row(const Hemicube& hemicube, std::size_t polygons, DeltaFactors factors) {
    std::vector<double> row(polygons);
    double all = 0;
    for (const HemicubeFace& face : hemicube.faces)
        for (std::size_t pixel = 0; pixel < face.nearest.size(); ++pixel) {
            all += face.delta_factors[pixel];
            const int seen = face.nearest[pixel];
            if (seen != HemicubeFace::nothing_seen) row[static_cast<std::size_t>(seen)] += face.delta_factors[pixel];
        }
    if (factors == DeltaFactors::normalised)
        for (double& factor : row) factor /= all;
    return row;
}

}  // namespace raylab
