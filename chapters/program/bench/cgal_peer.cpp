// CGAL's AABB_tree on its filtered kernel, as its manual recommends for triangles: exact predicates, with rays and
// segments passed unchanged. The package is under the GPL, and so is the program into which this file is linked; the
// lab's library and its other programs are not.

#include "peer.h"

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <malloc.h>

namespace raylab::bench {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Triangles = std::vector<Kernel::Triangle_3>;
using Tree =
    CGAL::AABB_tree<CGAL::AABB_traits<Kernel, CGAL::AABB_triangle_primitive<Kernel, Triangles::const_iterator>>>;

Kernel::Point_3 point(const Vec3f& p) { return {p.x, p.y, p.z}; }

Kernel::Ray_3 whole_ray(const Ray& ray) {
    return {point(ray.origin), Kernel::Vector_3(ray.direction.x, ray.direction.y, ray.direction.z)};
}

// The end point is rounded, because CGAL has no ray with a range.
Kernel::Segment_3 segment(const Ray& ray) {
    return {point(ray.origin), point(ray.origin + ray.range.max * ray.direction)};
}

bool is_endless(const Ray& ray) { return ray.range.max == std::numeric_limits<float>::infinity(); }

std::size_t heap_bytes() {
    const auto heap = mallinfo2();
    return heap.uordblks + heap.hblkhd;
}

class CgalPeer final : public Peer {
public:
    explicit CgalPeer(const Mesh& mesh) : before_(heap_bytes()) {
        for (std::size_t i = 0; i < mesh.faces.size(); ++i) {
            const auto [a, b, c] = mesh.triangle(i);
            const Kernel::Triangle_3 triangle(point(a), point(b), point(c));
            if (triangle.is_degenerate())
                continue;  // CGAL's predicates require an area, and none of the lab's rays hits a triangle without one
            triangles_.push_back(triangle);
            numbers_.push_back(static_cast<std::int32_t>(i));
        }
        tree_.insert(triangles_.begin(), triangles_.end());
        tree_.build();
        bytes_ = heap_bytes() - before_;
    }

    void closest(std::span<const Ray> rays, std::span<std::int32_t> triangles) const override {
        for (std::size_t i = 0; i < rays.size(); ++i) {
            const auto found = tree_.first_intersected_primitive(whole_ray(rays[i]));
            const bool hit = found && (is_endless(rays[i]) || CGAL::do_intersect(segment(rays[i]), **found));
            triangles[i] = hit ? numbers_[static_cast<std::size_t>(*found - triangles_.begin())] : none;
        }
    }

    void any(std::span<const Ray> rays, std::span<std::int32_t> triangles) const override {
        for (std::size_t i = 0; i < rays.size(); ++i) {
            const bool hit =
                is_endless(rays[i]) ? tree_.do_intersect(whole_ray(rays[i])) : tree_.do_intersect(segment(rays[i]));
            triangles[i] = hit ? 0 : none;
        }
    }

    std::size_t bytes() const override { return bytes_; }

private:
    std::size_t before_, bytes_ = 0;
    Triangles triangles_;
    std::vector<std::int32_t> numbers_;
    Tree tree_;
};

}  // namespace

PeerKind cgal_peer(const OtherPeer& peer) {
    return {
        std::string(peer.name), [](int) -> Build {
            return [](const Scene& scene) {
                return std::make_unique<CgalPeer>(*std::get<std::shared_ptr<const Mesh>>(scene.objects.at(0).shape));
            };
        }};
}

}  // namespace raylab::bench
