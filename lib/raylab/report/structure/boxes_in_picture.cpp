#include "raylab/report/structure/boxes_in_picture.h"

#include "raylab/image/draw.h"
#include "raylab/report/plane/plane_perspective.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <set>

namespace raylab {

namespace {

using Segment = std::array<std::array<float, 3>, 2>;

// The edges of all boxes, each once: neighbouring cells share theirs.
std::set<Segment> edges_of(const std::vector<Box>& boxes) {
    std::set<Segment> edges;
    for (const Box& box : boxes)
        for (int corner = 0; corner < 8; ++corner)
            for (int axis = 0; axis < 3; ++axis) {
                if (corner >> axis & 1) continue;
                const auto end = [&](int which) {
                    std::array<float, 3> at{};
                    for (int i = 0; i < 3; ++i)
                        at[static_cast<std::size_t>(i)] = which >> i & 1 ? box.max[i] : box.min[i];
                    return at;
                };
                edges.insert({end(corner), end(corner | 1 << axis)});
            }
    return edges;
}

std::optional<Point2> pixel_of(const CameraFrame& frame, const Vec3d& point) {
    constexpr double nearest = 1e-3;  // metres before the eye
    const PlanePerspective seen(frame);
    if (seen.depth(point) < nearest) return std::nullopt;
    const PlanePoint at = seen.at(point);
    return Point2{(1 + at.x / frame.half_width) / 2 * frame.image.width,
                  (1 - at.y / frame.half_height) / 2 * frame.image.height};
}

bool is_hidden(const CameraFrame& frame, const Accelerator& surfaces, const Vec3d& point) {
    constexpr float almost = 0.999f;  // an edge in a surface is seen
    Ray ray{.origin = convert<float>(frame.eye), .direction = convert<float>(point - frame.eye)};
    ray.range.max = almost;
    Traversal traversal;
    return surfaces.occluded(ray, traversal);
}

Pixel mixed(const Pixel& a, const Pixel& b, double share) {
    const auto mix = [&](float x, float y) { return static_cast<float>(x + (y - x) * share); };
    return {mix(a.r, b.r), mix(a.g, b.g), mix(a.b, b.b)};
}

// An edge is drawn in short pieces, each of which is seen or hidden as a whole.
void draw_edge(Image& image, const CameraFrame& frame, const Accelerator& surfaces, const Segment& ends,
               const BoxEdges& look) {
    const auto end = [&](std::size_t i) { return Vec3d(ends[i][0], ends[i][1], ends[i][2]); };
    const auto first = pixel_of(frame, end(0)), last = pixel_of(frame, end(1));
    if (!first || !last) return;
    constexpr double longest = 4;  // pixels
    const int pieces = std::max(1, static_cast<int>(std::hypot(last->x - first->x, last->y - first->y) / longest));
    const auto at = [&](double piece) { return end(0) + (end(1) - end(0)) * (piece / pieces); };
    for (int i = 0; i < pieces; ++i) {
        const bool hidden = is_hidden(frame, surfaces, at(i + 0.5));
        if (hidden && look.behind <= 0) continue;
        const auto a = pixel_of(frame, at(i)), b = pixel_of(frame, at(i + 1));
        const int x = std::clamp(static_cast<int>((a->x + b->x) / 2), 0, image.width() - 1);
        const int y = std::clamp(static_cast<int>((a->y + b->y) / 2), 0, image.height() - 1);
        const Pixel color = hidden ? mixed(image.at(x, y), look.color, look.behind) : look.color;
        draw_line(image, *a, *b, look.width, color);
    }
}

}  // namespace

Image with_boxes(Image picture, const CameraFrame& frame, const Accelerator& surfaces, const std::vector<Box>& boxes,
                 const BoxEdges& edges) {
    for (const Segment& ends : edges_of(boxes)) draw_edge(picture, frame, surfaces, ends, edges);
    return picture;
}

}  // namespace raylab
