#pragma once

#include "raylab/accelerator/accelerator.h"
#include "raylab/geometry/bounds/box.h"
#include "raylab/scene/scene.h"

#include <vector>

namespace raylab::bench {

/// The point where a camera ray hit.
struct Arrival {
    Vec3d position, normal;  // the unit normal on the camera's side
};

/// Generates size * size rays of each kind through a scene of one mesh (the kinds are explained in rays.h).
class RayMaker {
public:
    RayMaker(const Scene& scene, const Accelerator& exact, int size);

    std::vector<Ray> primary() const;
    std::vector<Ray> bounce() const;
    std::vector<Ray> shadow() const;
    std::vector<Ray> segments() const;
    std::vector<Ray> aimed() const;

private:
    double diagonal() const { return glm::length(convert<double>(box_.max) - convert<double>(box_.min)); }
    Vec3d start(const Arrival& arrival) const;
    const std::vector<Arrival>& arrivals() const;  // never empty
    template <class Make>
    std::vector<Ray> from_arrivals(const Make& make) const;

    const Scene& scene_;
    const Mesh& mesh_;
    const Accelerator& exact_;
    Box box_;
    int size_;
    std::size_t count_;
    mutable std::vector<Arrival> arrivals_;  // computed when they are first needed
};

}  // namespace raylab::bench
