#include "z_buffer.h"

#include "raylab/accelerator/item_buffer/drawn_depth.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace raylab::coherence {

namespace {

template <Real T>
struct Projected {
    T x, y, depth;  // the first two in pixels
};

std::optional<double> depth_at(const std::array<Projected<double>, 3>& c, double x, double y) {
    const auto drawn = [](const Projected<double>& corner) { return DrawnCorner{corner.x, corner.y, corner.depth}; };
    return drawn_depth({drawn(c[0]), drawn(c[1]), drawn(c[2])}, x, y);
}

// The same in floats, by which the chapter shows what rounding costs: three edge functions, which are also the corners'
// weights, and 1 / depth, which is linear in the picture.
std::optional<float> depth_at(const std::array<Projected<float>, 3>& c, float x, float y) {
    const auto edge = [&](const auto& a, const auto& b) { return (b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x); };
    const float a = edge(c[1], c[2]), b = edge(c[2], c[0]), d = edge(c[0], c[1]);
    if (!((a >= 0 && b >= 0 && d >= 0) || (a <= 0 && b <= 0 && d <= 0)) || a + b + d == 0) return std::nullopt;
    return 1 / ((a * (1 / c[0].depth) + b * (1 / c[1].depth) + d * (1 / c[2].depth)) / (a + b + d));
}

template <Real T>
class Buffer {
public:
    explicit Buffer(const CameraFrame& frame)
        : image_(frame.image),
          eye_(convert<T>(frame.eye)),
          right_(convert<T>(frame.right / frame.half_width)),
          up_(convert<T>(frame.up / frame.half_height)),
          forward_(convert<T>(frame.forward)),
          items_(pixels()),
          nearest_(pixels(), std::numeric_limits<T>::infinity()) {}

    void draw(const Triangle& triangle, std::uint32_t number) {
        std::array<Projected<T>, 3> corners;
        for (std::size_t i = 0; i < 3; ++i) {
            const auto corner = projected(i == 0 ? triangle.a : i == 1 ? triangle.b : triangle.c);
            if (!corner) return;
            corners[i] = *corner;
        }
        const auto [left, right] = std::minmax({corners[0].x, corners[1].x, corners[2].x});
        const auto [top, bottom] = std::minmax({corners[0].y, corners[1].y, corners[2].y});
        for (int y = first(top); y <= last(bottom, image_.height); ++y)
            for (int x = first(left); x <= last(right, image_.width); ++x) sample(corners, x, y, number);
    }

    const Items& items() const { return items_; }

private:
    std::size_t pixels() const {
        return static_cast<std::size_t>(image_.width) * static_cast<std::size_t>(image_.height);
    }
    static int first(T low) { return static_cast<int>(std::max(std::floor(low), T(0))); }
    static int last(T high, int side) { return static_cast<int>(std::min(std::floor(high), T(side - 1))); }

    std::optional<Projected<T>> projected(const Vec3f& vertex) const {
        const Vec3<T> seen = convert<T>(vertex) - eye_;
        const T depth = dot(seen, forward_);
        if (!(depth > 0)) return std::nullopt;
        return Projected<T>{(dot(seen, right_) / depth + 1) / 2 * T(image_.width),
                            (1 - dot(seen, up_) / depth) / 2 * T(image_.height), depth};
    }

    // Of two triangles at one depth the first one stays.
    void sample(const std::array<Projected<T>, 3>& corners, int column, int row, std::uint32_t number) {
        const auto depth = depth_at(corners, T(column) + T(0.5), T(row) + T(0.5));
        const std::size_t pixel =
            static_cast<std::size_t>(row) * static_cast<std::size_t>(image_.width) + static_cast<std::size_t>(column);
        if (!depth || !(*depth < nearest_[pixel])) return;
        nearest_[pixel] = *depth;
        items_[pixel] = number;
    }

    ImageSize image_;
    Vec3<T> eye_, right_, up_, forward_;
    Items items_;
    std::vector<T> nearest_;
};

}  // namespace

template <Real T>
Items z_buffer(const Mesh& mesh, const CameraFrame& frame) {
    Buffer<T> buffer(frame);
    for (std::uint32_t face = 0; face < mesh.faces.size(); ++face) buffer.draw(mesh.triangle(face), face);
    return buffer.items();
}

template Items z_buffer<float>(const Mesh&, const CameraFrame&);
template Items z_buffer<double>(const Mesh&, const CameraFrame&);

}  // namespace raylab::coherence
