#include "raylab/accelerator/on_demand.h"

#include "catch.h"
#include "raylab/experiment/adversarial/adversarial_scenes.h"

using namespace raylab;
using namespace raylab::adversarial;

TEST_CASE("a structure on demand is built when it is asked, and not before") {
    const Scene scene{.objects = {object(Sphere{{0, 0, 0}, 1})}};
    const OnDemand structure("bvh", scene);
    CHECK(structure.bytes() == 0);
    Traversal traversal;
    CHECK(structure.closest({{0, 0, 3}, {0, 0, -1}}, traversal)->t == 2);
    CHECK(structure.bytes() > 0);
}
