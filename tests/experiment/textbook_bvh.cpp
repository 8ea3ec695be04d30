#include "raylab/experiment/textbook/textbook_bvh.h"
#include "catch.h"
#include "raylab/experiment/generate/generate.h"
#include "raylab/experiment/generate/loose_triangles.h"
#include "raylab/experiment/structure/structure_question.h"

using namespace raylab;

TEST_CASE("the textbook's tree of boxes hits what a list hits, and tests few primitives for it") {
    const auto ball = std::make_shared<const Mesh>(bumpy_sphere(3));
    const auto workload = incoherent_rays("bumps", std::make_shared<const Scene>(mesh_scene(ball, "bumps")), 400, 7);
    Traversal traversal;
    const auto given = answers_of(TextbookBvh(*workload.scene), workload, traversal), truth = true_answers(workload);
    for (std::size_t i = 0; i < truth.size(); ++i) {
        INFO("ray " << i);
        REQUIRE(given[i].has_value() == truth[i].has_value());
        if (truth[i]) CHECK(given[i]->primitive == truth[i]->primitive);
    }
    CHECK(traversal.primitive_tests < truth.size() * ball->faces.size() / 20);
}
