#include "pictures.h"

#include "raylab/base/command_line.h"
#include "raylab/base/error.h"
#include "raylab/base/program.h"
#include "raylab/scene/read_scene.h"

#include <fmt/format.h>

#include <cstring>
#include <ctime>

// What a renderer that can do more costs a scene that needs little: see measure.

namespace {

using namespace raylab;

const CommandLine command_line{
    .program = "bench_needs",
    .about = "One sphere, drawn by the renderer and by a program that can do nothing else.",
    .options = {
        {"--by", "WHOM", "renderer, seam, hand, or pairs: renderer and hand in turn, seconds a picture", "pairs"},
        {"--pairs", "N", "how many", "30"}}};

bool same_bits(const Image& a, const Image& b) {
    for (int y = 0; y < a.height(); ++y)
        for (int x = 0; x < a.width(); ++x)
            if (std::memcmp(&a.at(x, y), &b.at(x, y), sizeof(Pixel)) != 0) return false;
    return true;
}

// The processor's: what else the machine does counts less.
double seconds_now() {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double seconds_of(const auto& work) {
    const double begun = seconds_now();
    work();
    return seconds_now() - begun;
}

ExitCode run(const Arguments& arguments) {
    const Scene scene = read_scene(BENCH_FOLDER "/one_sphere.toml");
    const CameraFrame frame = camera_frame(scene.camera, scene.image);
    const auto whom = arguments.text("--by");
    if (whom == "renderer") by_renderer(scene, frame);
    if (whom == "seam") by_seam(scene, frame);
    if (whom == "hand") by_hand(scene, frame);
    if (whom != "pairs") return ExitCode::as_it_should_be;
    const Image drawn = by_renderer(scene, frame);
    if (!same_bits(drawn, by_hand(scene, frame)) || !same_bits(drawn, by_seam(scene, frame))) {
        fmt::print("other bits\n");
        return ExitCode::negative;
    }
    for (long long i = arguments.integer("--pairs", 1, 100000); i > 0; --i) {  // each first in turn
        double renderer = 0, hand = 0;
        if (i % 2 == 0) renderer = seconds_of([&] { by_renderer(scene, frame); });
        hand = seconds_of([&] { by_hand(scene, frame); });
        if (i % 2 != 0) renderer = seconds_of([&] { by_renderer(scene, frame); });
        fmt::print("{} {}\n", renderer, hand);
    }
    return ExitCode::as_it_should_be;
}

}  // namespace

int main(int argc, char** argv) {
    return run_program([&] { return run(parse(command_line, words(argc, argv))); });
}
