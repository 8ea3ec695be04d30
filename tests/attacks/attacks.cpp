#include "attack.h"
#include "catch.h"

#include "isolated_process.h"
#include "level.h"
#include "rotating.h"

#include "raylab/base/file.h"
#include "raylab/base/process.h"
#include "raylab/base/temporary.h"
#include "raylab/base/with_all_replaced.h"

#include <algorithm>
#include <filesystem>
#include <future>
#include <string>
#include <vector>

// Each attack, checked at the lowest level that holds it off, and half of the acts, others after each commit, at the
// machine's best, too. `./raylab test --all`: at every level between them.

namespace fs = std::filesystem;
using namespace attacks;

namespace {

const fs::path folder = fs::path(RAYLAB_BUILD) / "tests/attacks";
const fs::path victim = folder / "victim";
const std::string treasure = "what must stay";
constexpr std::size_t at_once = 4;  // most of them wait for a compiler

fs::path written(const Attack& attack) {
    constexpr const char* begin = R"(#include "raylab/geometry/nearest_sphere_hit.h"
#include <fcntl.h>
#include <sched.h>
#include <sys/mount.h>
#include <sys/ptrace.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/uio.h>
#include <unistd.h>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string>
#include <thread>
#include <vector>
namespace { [[noreturn, maybe_unused]] void got_through() { std::abort(); } }
)";
    auto text = begin + attack.before +
                "\nstd::optional<double> raylab::nearest_sphere_hit(const RayOf<double>& ray, const "
                "SphereOf<double>& sphere) {\n" +
                attack.body + "\n    return std::nullopt;\n}\n";
    const auto file = folder / (attack.name + ".cpp");
    text = raylab::with_all_replaced(text, "@SOURCE@", RAYLAB_SOURCE);
    raylab::write_file(file, raylab::with_all_replaced(text, "@VICTIM@", victim.string()));
    return file;
}

raylab::ProcessResult checked(const Attack& attack, int level) {
    const std::vector<std::string> words{
        "RAYLAB_SECRET=1", RAYLAB_BUILD "/raylab",  "check", "02", "--json", "-", "--isolation", std::to_string(level),
        "--answer",        written(attack).string()};
    return raylab::run_process("env", words, {.folder = RAYLAB_SOURCE, .timeout = 240});
}

bool has_verdict(const raylab::ProcessResult& result, const std::string& verdict) {
    return result.output.find("\"verdict\": \"" + verdict + "\"") != std::string::npos;
}

void hold_off(const std::vector<Attack>& all, int level) {
    for (std::size_t first = 0; first < all.size(); first += at_once) {
        std::vector<std::future<raylab::ProcessResult>> results;
        const auto last = std::min(first + at_once, all.size());
        for (auto i = first; i < last; ++i)
            results.push_back(std::async(std::launch::async, [&, i] { return checked(all[i], level); }));
        for (auto i = first; i < last; ++i) {
            const auto result = results[i - first].get();
            INFO(all[i].name << " at level " << level << "\n" << result.output << result.errors);
            CHECK(std::ranges::any_of(all[i].verdicts, [&](const auto& word) { return has_verdict(result, word); }));
            CHECK(result.code == 1);
            CHECK(result.output.find("\"level\": " + std::to_string(level)) != std::string::npos);
        }
    }
}

enum class Levels { lowest, lowest_and_best };

void hold_off(const std::vector<Attack>& all, Levels levels) {
    raylab::write_file(victim, treasure);
    const int best = static_cast<int>(raylab::grading::best_isolation().level);
    for (int level = 1; level <= 3; ++level) {
        if (level > best) {
            WARN("level " << level << " is not tried: this kernel does not offer it");
            continue;
        }
        std::vector<Attack> held;
        for (std::size_t i = 0; i < all.size(); ++i) {
            const bool wanted =
                all_are_tested() || (levels == Levels::lowest_and_best && level == best && is_tested_now(i, 4));
            if (all[i].from == level || (wanted && all[i].from < level)) held.push_back(all[i]);
        }
        hold_off(held, level);
    }
    CHECK(raylab::read_file(victim) == treasure);
    for (const fs::path& trace : {fs::path(victim.string() + ".new"), fs::path("/tmp/raylab_attack")})
        CHECK_FALSE(fs::exists(trace));
}

}  // namespace

TEST_CASE("acts on files, other processes, the network and the machine are refused") {
    hold_off(acts(), Levels::lowest_and_best);
}

TEST_CASE("an answer that ends badly is told as what it is, and never passes") { hold_off(bad_ends(), Levels::lowest); }

TEST_CASE("a file that reaches for what it must not see is no answer") { hold_off(sources(), Levels::lowest); }

TEST_CASE("what fills its folder is killed at 256 MB, however many files it writes") {
    const raylab::ScratchFolder scratch;
    const auto result = raylab::grading::run_isolated(
        {raylab::grading::best_isolation(), scratch.path()}, {raylab::grading::Work::compile, 30}, "/bin/sh",
        {"-c", "for i in 1 2 3 4 5 6 7 8 9 10 11 12; do yes | head -c 60000000 > file$i; done; sleep 20"},
        {.folder = scratch.path()});
    CHECK(result.end == raylab::ProcessResult::End::objected);
    CHECK(to_string(result).find("it filled its folder with ") != std::string::npos);
}

TEST_CASE("a level that the machine lacks is demanded in vain, and no other is taken") {
    CHECK_THROWS(raylab::grading::isolation_at(static_cast<raylab::grading::Level>(4)));
}
