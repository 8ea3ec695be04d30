#include "commands.h"
#include "memory_words.h"
#include "ray_counts.h"

#include "raylab/accelerator/trace_rays.h"
#include "raylab/base/command_line.h"
#include "raylab/base/common_options.h"
#include "raylab/base/file.h"
#include "raylab/base/outputs.h"
#include "raylab/report/json_text.h"
#include "raylab/scene/memory_need.h"
#include "raylab/scene/mesh/read_mesh.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace raylab {

namespace {

const CommandLine trace_command_line = with_memory_option(
    {.program = "raylab trace",
     .about = "Traces the rays of a file through a mesh (.off, .obj, .ply, .stl) and writes what each hits.\n"
              "A ray is eight little-endian float32: ox oy oz tmin dx dy dz tmax (tmax may be +infinity). A hit is an\n"
              "int32, the triangle in file order with polygons split into fans (-1: none), and a float32, t "
              "(+infinity: no hit,\n"
              "or t is too large for a float).",
     .positionals = {{"MESH", "the mesh"}},
     .options = {{"--rays", "FILE", "the rays (required)"},
                 {"-o,--output", "HITS", "the file for the hits (required)"},
                 {"--accelerator", "NAME", "the structure that finds them: " + accelerator_list(), "auto"},
                 {"--any", "", "tell only whether there is a hit: 0 or -1, and t = 0"},
                 threads_option(),
                 {"--json", "FILE", "the measurements as JSON; - is standard output"}}});

std::size_t hit_count(const TraceResult& result) {
    return static_cast<std::size_t>(
        std::ranges::count_if(result.hits, [](const auto& hit) { return hit.triangle >= 0; }));
}

nlohmann::ordered_json to_json(const TraceResult& result, std::size_t triangles) {
    return {{"accelerator", result.accelerator},
            {"triangles", triangles},
            {"build_seconds", result.build_seconds},
            {"bytes", result.bytes},
            {"rays", result.hits.size()},
            {"hits", hit_count(result)},
            {"seconds", result.seconds},
            {"rays_per_second", rate(result.hits.size(), result.seconds)},
            {"threads", result.threads},
            {"box_tests", result.counts.box_tests},
            {"steps", result.counts.steps},
            {"primitive_tests", result.counts.primitive_tests},
            {"exact_decisions", result.counts.exact_decisions}};
}

std::string summary(const TraceResult& result, std::size_t triangles) {
    const auto rays = result.hits.size();
    const double each = rays > 0 ? 1 / static_cast<double>(rays) : 0;
    return fmt::format("{} triangles in {}: built in {:.3g} s, {:.1f} bytes a "
                       "triangle\n",
                       triangles, result.accelerator, result.build_seconds,
                       static_cast<double>(result.bytes) / static_cast<double>(triangles)) +
           fmt::format("{} rays, {} hits: {:.3g} s on {} threads, {:.4g} rays a second\n", rays, hit_count(result),
                       result.seconds, result.threads, rate(result.hits.size(), result.seconds)) +
           fmt::format("a ray: {:.1f} box tests, {:.1f} triangle tests, {:.2g} exact decisions\n",
                       each * static_cast<double>(result.counts.box_tests),
                       each * static_cast<double>(result.counts.primitive_tests),
                       each * static_cast<double>(result.counts.exact_decisions));
}

}  // namespace

ExitCode trace_command(const std::vector<std::string>& words) {
    const Arguments arguments = parse(trace_command_line, words);
    const auto output = arguments.text("--output"), rays_file = arguments.text("--rays");
    const TraceOptions options{.accelerator = arguments.text("--accelerator"),
                               .question = arguments.has("--any") ? RayQuestion::any : RayQuestion::nearest,
                               .threads = threads_of(arguments)};
    Outputs outputs({.files = arguments.given({"--output", "--json"}), .inputs = arguments.given({"MESH", "--rays"})});
    const MemoryLimit limit = memory_limit(arguments);
    const auto mesh = std::make_shared<const Mesh>(read_mesh(arguments.text("MESH"), limit));
    check_memory(accelerator_need(*mesh), limit, {arguments.text("MESH")});
    const auto largest = limit.bytes / 3;  // rays, hits and their bytes take less than three times the file's size
    const auto rays = rays_from_bytes(read_file(rays_file, largest), rays_file);
    const auto result = trace_rays(mesh, rays, options);
    write_file(outputs[output], to_bytes(result.hits));
    const auto json = arguments.text_if_given("--json");
    if (json) write_json(json_text(to_json(result, mesh->faces.size())), outputs[*json]);
    if (json != "-") outputs.say(summary(result, mesh->faces.size()));
    outputs.commit();
    return ExitCode::as_it_should_be;
}

}  // namespace raylab
