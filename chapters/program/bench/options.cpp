#include "options.h"

#include "raylab/accelerator/accelerator.h"
#include "raylab/scene/demo_meshes.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace raylab::bench {

const CommandLine& command_line() {
    static const CommandLine all{
        .program = "raylab bench",
        .about =
            "Rays a second, build time, memory and wrong answers of our structures beside Embree's and CGAL's, "
            "all\ntaking turns in one process. Medians; compare numbers of one run only. `wrong` counts hit decisions "
            "that\ndiffer from exact arithmetic. What is not installed is left out. The first peer is what the others "
            "are\ncompared with.",
        .options = {
            {"--meshes", "LIST",
             fmt::format("with commas: real ones ({}), bumpy_0..8, knot_4..10, torus_2..10, files (default: the real "
                         "ones that are here, knot_8, bumpy_8)",
                         fmt::join(demo_mesh_names(), ", "))},
            {"--rays", "LIST",
             "primary, bounce, segments (closest hit), bounce_any, shadow, segments_any (default: these), aimed"},
            {"--peers", "LIST",
             "embree_robust, embree_default, cgal, " + accelerator_list() +
                 ", wide_plain (wide with nothing exact) (default: the foreign ones, aabb_tree, auto)"},
            {"--threads", "LIST", "numbers of threads; each peer races with each of them", "1"},
            {"--repetitions", "N", "of each build and each kind of rays; medians count (default: 5)"},
            {"--size", "N", "N x N rays of each kind (default: 1024)"},
            {"--clock", "NAME",
             "which seconds count: wall, or processor (its time for this program alone, on a busy machine; one thread)",
             "wall"},
            {"--quick", "", "bunny (or knot_8) alone, 256 x 256 rays of each kind, 3 repetitions, where nothing else is said"},
            {"--growth", "",
             "cost against size: bumpy_4 to bumpy_8, 5 120 to 1 310 720 triangles, where nothing else is said"},
            {"-o,--out", "DIR", "charts of the cost against size go there"},
            {"--json", "FILE", "the rows as JSON; - is standard output"}}};
    return all;
}

}  // namespace raylab::bench
