#include "raylab/transport/lobe/material_lobes.h"

#include "raylab/tracer/refracted_direction.h"

namespace raylab {

MaterialLobes polished_lobes(const Material& material, const Color& diffuse, const Vec3d& wo,
                             const Interface& interface, FacetShares shares) {
    MaterialLobes lobes;
    if (diffuse != Color(0)) lobes.spread.push_back(DiffuseLobe{diffuse});
    if (material.kr == 0 && material.kt == 0) return lobes;
    if (const auto* rough = std::get_if<Roughness>(&material.polish)) {
        // Between equal media no facet turns light: what passes, passes straight.
        const bool passes_straight = interface.ior_here == interface.ior_behind;
        if (passes_straight) lobes.refracted = material.kt;
        const double kt = passes_straight ? 0 : material.kt;
        if (material.kr > 0 || kt > 0)
            lobes.spread.push_back(RoughLobe{material.kr, kt, rough->value * rough->value, interface.ior_here,
                                             interface.ior_behind, shares});
        return lobes;
    }
    const auto [here, behind] = interface;
    const auto [mirrored, refracted] = mirrored_share(material.kr, material.kt, wo.z, here, behind, shares);
    const double exponent = std::get<Gloss>(material.polish).exponent;
    if (mirrored > 0) lobes.spread.push_back(GlossLobe{mirrored, exponent, mirrored_about_z(wo)});
    if (const auto through = refracted_direction(-wo, {0, 0, 1}, here, behind); through && refracted > 0)
        lobes.spread.push_back(GlossLobe{refracted, exponent, *through});
    return lobes;
}

}  // namespace raylab
