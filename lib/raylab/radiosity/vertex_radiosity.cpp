#include "raylab/radiosity/vertex_radiosity.h"

#include <algorithm>
#include <limits>
#include <map>
#include <utility>

namespace raylab {

namespace {

using Edge = std::pair<std::uint32_t, std::uint32_t>;

/// How many patches lie at each edge. The side of a large patch counts as the edges of its small neighbours.
class PatchesAtEdges {
public:
    explicit PatchesAtEdges(const PatchMesh& mesh) {
        for (const auto& [vertex, ends] : mesh.hanging) middles_[std::minmax(ends[0], ends[1])] = vertex;
        for (const Patch& patch : mesh.patches)
            for (std::uint32_t i = 0; i < patch.corner_count; ++i)
                add(patch.vertices[i], patch.vertices[(i + 1) % patch.corner_count]);
    }

    const std::map<Edge, int>& counts() const { return counts_; }

private:
    void add(std::uint32_t a, std::uint32_t b) {
        const Edge edge = std::minmax(a, b);
        if (const auto middle = middles_.find(edge); middle != middles_.end()) {
            add(a, middle->second);
            add(middle->second, b);
        } else {
            ++counts_[edge];
        }
    }

    std::map<Edge, std::uint32_t> middles_ = {};
    std::map<Edge, int> counts_ = {};
};

// The vertices that lie on an edge of one patch only.
std::vector<bool> border_vertices(const PatchMesh& mesh) {
    const PatchesAtEdges patches_at(mesh);
    std::vector<bool> border(mesh.vertices.size());
    for (const auto& [edge, count] : patches_at.counts())
        if (count == 1) border[edge.first] = border[edge.second] = true;
    return border;
}

// The nearest vertex among those of a vertex's own patches that lies on no border; none: its own number.
std::vector<std::uint32_t> nearest_inner(const PatchMesh& mesh, const std::vector<bool>& border) {
    std::vector<std::uint32_t> nearest(mesh.vertices.size());
    std::vector<double> least(mesh.vertices.size(), std::numeric_limits<double>::infinity());
    for (std::uint32_t i = 0; i < nearest.size(); ++i) nearest[i] = i;
    for (const Patch& patch : mesh.patches)
        for (std::uint32_t i = 0; i < patch.corner_count; ++i)
            for (std::uint32_t j = 0; j < patch.corner_count; ++j) {
                const std::uint32_t vertex = patch.vertices[i], other = patch.vertices[j];
                const double distance = glm::distance(mesh.vertices[vertex], mesh.vertices[other]);
                if (border[other] || distance >= least[vertex]) continue;
                least[vertex] = distance;
                nearest[vertex] = other;
            }
    return nearest;
}

void mend(Radiosities& vertices, const PatchMesh& mesh) {
    for (const auto& [vertex, ends] : mesh.hanging) vertices[vertex] = 0.5 * (vertices[ends[0]] + vertices[ends[1]]);
}

}  // namespace

Radiosities vertex_radiosities(const PatchMesh& mesh, const Radiosities& patches, TVertices treatment) {
    Radiosities mean(mesh.vertices.size(), Color{0, 0, 0});
    std::vector<int> count(mesh.vertices.size());
    for (std::size_t p = 0; p < mesh.patches.size(); ++p)
        for (std::uint32_t i = 0; i < mesh.patches[p].corner_count; ++i) {
            mean[mesh.patches[p].vertices[i]] += patches[p];
            ++count[mesh.patches[p].vertices[i]];
        }
    for (std::size_t v = 0; v < mean.size(); ++v) mean[v] /= count[v];
    if (treatment == TVertices::mended) mend(mean, mesh);  // a border's vertex is extended from these
    const auto border = border_vertices(mesh);
    const auto inner = nearest_inner(mesh, border);
    Radiosities result = mean;
    for (std::size_t v = 0; v < mean.size(); ++v)
        if (border[v] && inner[v] != v) result[v] = glm::max(2.0 * mean[v] - mean[inner[v]], Color{0, 0, 0});
    if (treatment == TVertices::mended) mend(result, mesh);
    return result;
}

}  // namespace raylab
