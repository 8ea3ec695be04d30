#include "options.h"

#include "meshes.h"

#include "raylab/accelerator/accelerator.h"
#include "raylab/scene/demo_meshes.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace raylab::bench {

std::string peer_list() {
    std::string list;
    for (const OtherPeer& peer : other_peer::all) list += fmt::format("{}, ", peer.name);
    return list + accelerator_list();
}

const CommandLine& command_line() {
    static const CommandLine all{
        .program = "raylab bench",
        .about =
            "Compares raylab's structures with Embree's and CGAL's: rays per second, build time, memory and wrong "
            "answers. All\n"
            "take turns in one process, and medians are shown; compare numbers of one run only. `wrong` counts hit\n"
            "decisions that differ from exact arithmetic. Peers that are not installed are left out. The others are\n"
            "compared with the first peer.",
        .options = {
            {"--meshes", "LIST",
             fmt::format("separated by commas: scanned ones ({}), {}, files (default: the scanned ones that have been "
                         "fetched, hall_4, city_3, knot_8, bumpy_8, hair_7, stadium_6)",
                         fmt::join(demo_mesh_names(), ", "), mesh_families())},
            {"--rays", "LIST",
             "primary, bounce, segments (closest hit), bounce_any, shadow, segments_any (default: these), aimed"},
            {"--peers", "LIST",
             peer_list() +
                 "; bvh8_plain is bvh8 without exact decisions (default: those of other libraries, bvh, auto)"},
            {"--threads", "LIST", "numbers of threads; each peer races with each of them", "1"},
            {"--repetitions", "N", "repetitions of each build and each kind of rays; medians are shown (default: 5)"},
            {"--size", "N", "N x N rays of each kind (default: 1024)"},
            {"--clock", "NAME",
             "which time is measured: wall, or processor (of this program alone, for a busy machine; one thread only)",
             "wall"},
            {"--quick", "",
             "bunny (or knot_8) alone, 256 x 256 rays of each kind, 3 repetitions, unless other options say otherwise"},
            {"--growth", "",
             "cost against size: bumpy_4 to bumpy_8, 5 120 to 1 310 720 triangles, unless --meshes says otherwise"},
            {"-o,--out", "DIR",
             "the folder for charts: the cost against size, and, with aimed rays, leaks against speed"},
            {"--json", "FILE", "the rows as JSON; - is standard output"}}};
    return all;
}

}  // namespace raylab::bench
