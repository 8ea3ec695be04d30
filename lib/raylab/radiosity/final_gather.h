#pragma once

#include "raylab/radiosity/direct_light.h"
#include "raylab/radiosity/radiosity_view.h"

#include <cstdint>
#include <optional>

namespace raylab {

/// Where the shadow ray from a point to a patch ends.
struct GatherRays {
    enum class End {
        centre,  // the same for all points
        random   // a point of the patch, by `sample`: of many points the mean is right
    } end = End::centre;
    std::uint64_t sample = 0;
};

/// The radiosity equation once more, at a point of a surface: what all patches, lights and the background send there.
class FinalGather {
public:
    explicit FinalGather(const RadiosityView& view) : view_(view), lights_(view.mesh, view.visibility) {}

    /// What a point has, and the share of its view that patches fill.
    struct Found {
        Color radiosity;
        double filled;
    };

    /// At a point of a patch; the factor of every other patch is that of all of it if the end of its shadow ray is in
    /// view.
    Found at(std::uint32_t patch, const Vec3d& point, const GatherRays& rays, Traversal& traversal) const;

private:
    const RadiosityView& view_;
    PatchLights lights_;
};

}  // namespace raylab
