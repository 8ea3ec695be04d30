#pragma once

#include "arguments.h"
#include "spread.h"

#include "raylab/geometry/local_frame.h"
#include "raylab/sampling/mapping/sphere_cone.h"

#include <cmath>

namespace raylab::grading::light {

/// A light as it is seen from the lit point: in a cone around the way to its centre.
class SeenLight {
public:
    explicit SeenLight(const Arguments& given)
        : given_(given),
          distance_(glm::length(given.center - given.from)),
          frame_(frame_around((given.center - given.from) / distance_)),
          cone_(SphereCone::around(given.radius, distance_)) {}

    double density() const { return cone_.pdf(); }
    double relative_radius() const { return given_.radius / distance_; }

    /// The point's distance from the light's centre, as a share of the radius.
    double reach(const Vec3d& point) const { return glm::length(point - given_.center) / given_.radius; }

    /// The cosine between the way from the light's centre to the point, and to the lit point. A point of the light is
    /// seen if it is at least relative_radius().
    double side(const Vec3d& point) const {
        const Vec3d way = point - given_.center;
        return -dot(way, frame_.z) / glm::length(way);
    }

    /// Where the direction to the point lies: the share of the cone's solid angle that is nearer to its axis, and the
    /// turn around the axis. Of a tiny cone, 1 - cos is sin^2 / (1 + cos).
    DrawnShare share(const Vec3d& point) const {
        const Vec3d local = frame_.to_local(glm::normalize(point - given_.from));
        const double sine_squared = local.x * local.x + local.y * local.y;
        const double height = local.z > 0 ? sine_squared / (1 + local.z) : 1 - local.z;
        return {height * 2 * std::numbers::pi / cone_.solid_angle(), turn_share(local.x, local.y)};
    }

    std::vector<DrawnShare> shares(std::span<const double> answer) const {
        std::vector<DrawnShare> all;
        for (std::size_t i = 0; i < pairs; ++i) all.push_back(share(chosen(answer, i).point));
        return all;
    }

private:
    Arguments given_;
    double distance_;
    LocalFrame frame_;
    SphereCone cone_;
};

}  // namespace raylab::grading::light
