#include "raylab/experiment/textbook/textbook_bvh.h"
#include "catch.h"
#include "raylab/accelerator/accelerator.h"
#include "raylab/experiment/generate/generate.h"
#include "raylab/experiment/generate/loose_triangles.h"
#include "raylab/experiment/structure/structure_question.h"
#include "raylab/sampling/sequence.h"

using namespace raylab;

namespace {

// Long triangles in every direction: the boxes of the tree overlap, and the nearest hit is often not in the box that is
// entered first.
StructureWorkload straws() {
    std::vector<Triangle> triangles;
    for (std::uint64_t i = 0; i < 300; ++i) {
        RandomSequence random(3, i);
        const Vec3d middle = random.in_cube(), along = random.unit_vector(), across = random.unit_vector();
        triangles.push_back({convert<float>(middle - along * 0.5), convert<float>(middle + along * 0.5),
                             convert<float>(middle + across * 0.2)});
    }
    const auto scene = std::make_shared<const Scene>(mesh_scene(mesh_of(triangles), "straws"));
    return incoherent_rays("straws", scene, 400, 7);
}

}  // namespace

TEST_CASE("the textbook's tree of boxes hits what a list hits, with as few tests as the lab's tree") {
    const auto workload = straws();
    Traversal traversal, of_lab;
    const auto given = answers_of(TextbookBvh(*workload.scene), workload, traversal), truth = true_answers(workload);
    for (std::size_t i = 0; i < truth.size(); ++i) {
        INFO("ray " << i);
        REQUIRE(given[i].has_value() == truth[i].has_value());
        if (truth[i]) CHECK(given[i]->primitive == truth[i]->primitive);
    }
    answers_of(*make_accelerator("bvh", *workload.scene), workload, of_lab);
    CHECK(static_cast<double>(traversal.primitive_tests) < 1.05 * static_cast<double>(of_lab.primitive_tests));
}
