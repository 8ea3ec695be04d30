#include "race_options.h"

#include "options.h"

#include "raylab/base/error.h"
#include "raylab/scene/demo_meshes.h"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

namespace raylab::bench {

namespace {

std::vector<std::string> parts(const std::string& option, const std::string& list) {
    std::vector<std::string> all;
    std::istringstream text(list);
    for (std::string part; std::getline(text, part, ',');) {
        if (std::ranges::find(all, part) != all.end())  // its rows could not be told apart
            throw Error(option + ": expected each but once, found \"" + part + "\" again");
        if (!part.empty()) all.push_back(part);
    }
    if (all.empty()) throw Error(option + ": expected a list with commas, found \"" + list + "\"");
    return all;
}

std::vector<std::string> suited_meshes(const Arguments& arguments) {
    const bool quick = arguments.has("--quick");
    if (arguments.has("--growth") && quick) return {"bumpy_3", "bumpy_4", "bumpy_5", "bumpy_6"};
    if (arguments.has("--growth")) return {"bumpy_4", "bumpy_5", "bumpy_6", "bumpy_7", "bumpy_8"};
    if (quick) return {demo_mesh("bunny") ? "bunny" : "knot_8"};
    return usual_meshes();
}

std::vector<int> thread_counts(const std::string& list) {
    std::vector<int> counts;
    for (const std::string& part : parts("--threads", list)) {
        if (part.find_first_not_of("0123456789") != std::string::npos || part.size() > 3 || std::stoi(part) < 1)
            throw Error("--threads: expected numbers from 1 to 999 with commas, found \"" + list + "\"");
        counts.push_back(std::stoi(part));
    }
    return counts;
}

Seconds clock_named(const std::string& name) {
    if (name == "wall") return Seconds::wall;
    if (name == "processor") return Seconds::processor;
    throw Error("--clock: expected wall or processor, found \"" + name + "\"");
}

// Checks the name alone. What a peer of another library lacks that is not installed is reported by the bench program.
void refuse_unknown_peer(const std::string& name) {
    if (std::ranges::find(other_peer::all, name, &OtherPeer::name) != other_peer::all.end()) return;
    const auto ours = accelerator_names();
    if (std::ranges::find(ours, name.substr(0, name.find(':'))) == ours.end())
        throw Error(fmt::format("expected a peer ({}), found \"{}\"", peer_list(), name));
    make_accelerator(name, {});  // "grid:10": make_accelerator() checks what follows the colon
}

void refuse_unknown_names(const RaceOptions& options) {
    for (const std::string& mesh : options.meshes) refuse_unknown_mesh(mesh);
    for (const std::string& rays : options.rays) refuse_unknown_rays(rays);
    for (const std::string& peer : options.peers) refuse_unknown_peer(peer);
}

}  // namespace

RaceOptions race_options(const Arguments& arguments, const std::vector<std::string>& usual_peers) {
    const bool quick = arguments.has("--quick");
    const auto threads = thread_counts(arguments.text("--threads"));
    const auto clock = clock_named(arguments.text("--clock"));
    if (clock == Seconds::processor && std::ranges::max(threads) > 1)
        throw Error("--clock processor: expected one thread, for it adds up the seconds of all; found --threads " +
                    arguments.text("--threads"));
    const auto list = [&](const char* option, std::vector<std::string> otherwise) {
        const auto text = arguments.text_if_given(option);
        return text ? parts(option, *text) : otherwise;
    };
    const auto number = [&](const char* option, int highest, int otherwise) {
        return arguments.has(option) ? static_cast<int>(arguments.integer(option, 1, highest)) : otherwise;
    };
    const RaceOptions options{.meshes = list("--meshes", suited_meshes(arguments)),
                              .rays = list("--rays", usual_rays()),
                              .peers = list("--peers", usual_peers),
                              .threads = threads,
                              .repetitions = number("--repetitions", 1000, quick ? 3 : 5),
                              .size = number("--size", 4096, quick ? 256 : 1024),
                              .clock = clock};
    refuse_unknown_names(options);
    return options;
}

}  // namespace raylab::bench
