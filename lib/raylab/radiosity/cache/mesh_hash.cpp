#include "raylab/radiosity/cache/mesh_hash.h"

namespace raylab {

void add_geometry(ContentHash& hash, const PatchMesh& mesh) {
    for (const Patch& patch : mesh.patches) {
        hash.add_value(patch.corner_count);
        for (const Vec3d& corner : patch.polygon()) hash.add_value(corner);
        hash.add_value(mesh.occluder(patch));
        hash.add_value(patch.side);
    }
    for (const Facet& facet : mesh.model.facets) {
        hash.add_value(facet.occluder);
        for (const Vec3d& corner : facet.corners) hash.add_value(corner);
    }
}

}  // namespace raylab
