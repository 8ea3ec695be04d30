#include "raylab/experiment/textbook/textbook_light_buffer.h"
#include "catch.h"
#include "raylab/accelerator/accelerator.h"
#include "raylab/experiment/structure/structure_question.h"
#include "raylab/sampling/sequence.h"

using namespace raylab;

namespace {

// Shadow rays to a light among triangles.
StructureWorkload shadows_of_triangles() {
    auto scene = std::make_shared<Scene>();
    for (std::uint64_t i = 0; i < 120; ++i) {
        RandomSequence random(5, i);
        const Vec3d at = random.in_cube();
        const double size = i % 8 == 0 ? 1 : 0.2;
        const auto corner = [&] { return convert<float>(at + size * random.in_cube()); };
        scene->objects.push_back({.shape = Triangle{corner(), corner(), corner()}});
    }
    const Vec3d light{0.3, 0.5, 0.2};
    scene->lights.push_back({.kind = PointLight{light}});
    StructureWorkload workload{"shadows of triangles", "", scene, RayQuestion::any};
    for (std::uint64_t i = 0; i < 600; ++i) {
        RandomSequence random(6, i);
        const Vec3f origin = convert<float>(2.0 * random.in_cube());
        const Vec3d way = light - convert<double>(origin);
        workload.rays.push_back({origin, convert<float>(way), {0, 1 - 0x1p-20f}});
    }
    return workload;
}

}  // namespace

TEST_CASE("the textbook's light buffer finds the shadows that a list finds, with a tenth of its tests") {
    const auto workload = shadows_of_triangles();
    Traversal traversal, of_list;
    const auto given = answers_of(TextbookLightBuffer(*workload.scene, 64), workload, traversal),
               truth = true_answers(workload);
    CHECK(wrong_answers(given, truth, workload.question) == 0);
    answers_of(*make_accelerator("list", *workload.scene), workload, of_list);
    CHECK(10 * traversal.primitive_tests < of_list.primitive_tests);
}
