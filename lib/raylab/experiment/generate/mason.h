#pragma once

#include "raylab/experiment/generate/circle.h"
#include "raylab/experiment/generate/loose_triangles.h"
#include "raylab/geometry/shapes.h"

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace raylab {

/// Adds parts to a mesh, in metres.
class Mason {
public:
    Mesh taken() { return std::move(mesh_); }

    void quad(const Vec3d& corner, const Vec3d& u, const Vec3d& v) {
        add_parallelogram(mesh_, convert<float>(corner), convert<float>(u), convert<float>(v));
    }

    void triangle(const Vec3d& a, const Vec3d& b, const Vec3d& c) {
        add(mesh_, Triangle{convert<float>(a), convert<float>(b), convert<float>(c)});
    }

    void box(const Vec3d& min, const Vec3d& max) {
        const Vec3d x{max.x - min.x, 0, 0}, y{0, max.y - min.y, 0}, z{0, 0, max.z - min.z};
        for (const Vec3d& start : {min, min + z}) quad(start, x, y);
        for (const Vec3d& start : {min, min + y}) quad(start, x, z);
        for (const Vec3d& start : {min, min + x}) quad(start, y, z);
    }

    /// An upright column: as many tall strips as the circle has points.
    void column(const Vec3d& foot, double radius, double height, const std::vector<Angle>& round) {
        for (std::size_t i = 0; i < round.size(); ++i) {
            const Angle a = round[i], b = round[(i + 1) % round.size()];
            const Vec3d from = foot + radius * Vec3d{a.cosine, 0, a.sine},
                        to = foot + radius * Vec3d{b.cosine, 0, b.sine};
            quad(from, to - from, {0, height, 0});
        }
    }

    /// A wall with a round arch along x from a springer on: its intrados, and on both faces strips up to `top`.
    void arch(const Vec3d& springer, double radius, double thickness, double top, const std::vector<Angle>& round) {
        const Vec3d depth{0, 0, thickness};
        for (std::size_t i = 0; i < round.size() / 2; ++i) {
            const Angle a = round[i], b = round[i + 1];
            const Vec3d centre = springer + Vec3d{radius, 0, 0};
            const Vec3d from = centre + radius * Vec3d{a.cosine, a.sine, 0},
                        to = centre + radius * Vec3d{b.cosine, b.sine, 0};
            quad(from, to - from, depth);
            const Vec3d above_from{from.x, top, from.z}, above_to{to.x, top, to.z};
            for (const Vec3d& face : {Vec3d{0}, depth}) {
                triangle(from + face, to + face, above_to + face);
                triangle(from + face, above_to + face, above_from + face);
            }
        }
    }

    void add_mesh(const Mesh& other, const Vec3d& place, double scale) {
        const auto first = static_cast<std::uint32_t>(mesh_.vertices.size());
        for (const Vec3f& v : other.vertices)
            mesh_.vertices.push_back(convert<float>(place + scale * convert<double>(v)));
        for (const auto& [a, b, c] : other.faces) mesh_.faces.push_back({a + first, b + first, c + first});
    }

private:
    Mesh mesh_;
};

}  // namespace raylab
