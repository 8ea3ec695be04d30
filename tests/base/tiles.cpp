#include "raylab/base/tiles.h"

#include "catch.h"

#include <sched.h>

#include <atomic>
#include <chrono>
#include <stdexcept>
#include <thread>
#include <vector>

using namespace raylab;

namespace {

bool may_run_on(const cpu_set_t& processors) {
    cpu_set_t own;
    return sched_getaffinity(0, sizeof own, &own) == 0 && CPU_EQUAL(&own, &processors);
}

}  // namespace

TEST_CASE("every index is in one piece, however many threads take them", "[threads]") {
    for (const int threads : {1, 2, 7, 0}) {
        std::vector<std::atomic<int>> taken(1'001);
        std::atomic<int> too_large = 0;
        for_each_piece(taken.size(), 10, threads, [&](std::size_t begin, std::size_t end) {
            if (end - begin > 10) ++too_large;
            for (std::size_t i = begin; i < end; ++i) ++taken[i];
        });
        CHECK(too_large == 0);
        for (const auto& times : taken) CHECK(times == 1);
    }
}

TEST_CASE("what a piece throws is thrown when all threads have stopped", "[threads]") {
    std::atomic<int> at_work = 0;
    const auto fail_at_50 = [&](std::size_t begin, std::size_t) {
        ++at_work;
        std::this_thread::yield();
        --at_work;
        if (begin == 50) throw std::runtime_error("the fiftieth");
    };
    CHECK_THROWS_WITH(for_each_piece(100, 1, 4, fail_at_50), "the fiftieth");
    CHECK(at_work == 0);
}

TEST_CASE("threads may run on every processor on which the one that starts them may", "[threads]") {
    cpu_set_t processors;
    REQUIRE(sched_getaffinity(0, sizeof processors, &processors) == 0);
    std::atomic<int> confined = 0;
    for_each_piece(200, 1, 4, [&](std::size_t, std::size_t) {
        // A thread is confined for a moment when it starts.
        const auto patience = std::chrono::steady_clock::now() + std::chrono::seconds(1);
        while (!may_run_on(processors)) {
            if (std::chrono::steady_clock::now() > patience) {
                ++confined;
                break;
            }
            std::this_thread::yield();
        }
        std::this_thread::sleep_for(std::chrono::microseconds(100));  // so that each thread takes some
    });
    CHECK(confined == 0);
    CHECK(may_run_on(processors));
}
