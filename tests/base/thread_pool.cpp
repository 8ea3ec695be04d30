#include "raylab/base/thread_pool.h"

#include "catch.h"
#include "sanitized.h"

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <fstream>
#include <latch>
#include <mutex>
#include <set>
#include <stdexcept>
#include <thread>
#include <vector>

using namespace raylab;

namespace {

// Calls work(thread) in all threads of a pool: none is done before all have begun.
template <class Work>
void run_all(ThreadPool& pool, const Work& work) {
    std::latch all(pool.size());
    pool.run([&](int thread) {
        all.arrive_and_wait();
        work(thread);
    });
}

}  // namespace

TEST_CASE("each thread of a pool works once in a round", "[threads]") {
    for (const int threads : {1, 2, 5}) {
        ThreadPool pool(threads, 100);
        REQUIRE(pool.size() == threads);
        for (int round = 0; round < 300; ++round) {
            std::vector<std::atomic<int>> worked(static_cast<std::size_t>(threads));
            run_all(pool, [&](int thread) { ++worked[static_cast<std::size_t>(thread)]; });
            for (const auto& times : worked) CHECK(times == 1);
        }
    }
}

TEST_CASE("a pool has no more threads than there are pieces of work") {
    CHECK(ThreadPool(8, 3).size() == 3);
    CHECK(ThreadPool(8, 0).size() == 1);
    CHECK(ThreadPool().size() == 1);
}

// (Many threads, and so little work that most have not begun when the first one is done.)
TEST_CASE("no thread begins when a round is over", "[threads]") {
    ThreadPool pool(8, 8);
    std::atomic<bool> is_over = true;
    std::atomic<int> begun = 0, late = 0;
    for (int round = 0; round < 20'000; ++round) {
        is_over = false;
        pool.run([&](int) {
            ++begun;
            if (is_over) ++late;
        });
        is_over = true;
    }
    CHECK(late == 0);
    CHECK((begun >= 20'000 && begun <= 160'000));
}

TEST_CASE("the threads of a pool work for the next one, too", "[threads]") {
    const auto threads_of_a_pool = [] {
        std::vector<std::thread::id> ids(4);
        ThreadPool pool(4, 4);
        run_all(pool, [&](int thread) { ids[static_cast<std::size_t>(thread)] = std::this_thread::get_id(); });
        return std::set(ids.begin(), ids.end());
    };
    const auto first = threads_of_a_pool();
    CHECK(first.size() == 4);
    for (int i = 0; i < 100; ++i) REQUIRE(threads_of_a_pool() == first);
}

TEST_CASE("a copy of the process has threads of its own") {
    if constexpr (is_sanitized) return;  // the thread sanitizer starts none in a copy of a process with several
    const auto worked = [] {
        std::atomic<int> times = 0;
        ThreadPool pool(3, 3);
        run_all(pool, [&](int) { ++times; });
        return times.load();
    };
    REQUIRE(worked() == 3);
    const pid_t child = fork();
    if (child == 0) {
        alarm(20);
        _exit(worked() == 3 ? 0 : 1);
    }
    int status = 0;
    REQUIRE(waitpid(child, &status, 0) == child);
    CHECK(status == 0);
}

// (In a process of its own, whose memory is limited, and which ends if it would wait for ever. A sanitizer has reserved
// more than any limit.)
TEST_CASE("a pool that lacks memory for all of its threads works with fewer") {
    if constexpr (is_sanitized) return;
    const pid_t child = fork();
    if (child == 0) {
        alarm(20);
        rlim_t pages = 0;
        std::ifstream("/proc/self/statm") >> pages;
        const rlim_t bytes = pages * static_cast<rlim_t>(sysconf(_SC_PAGESIZE)) + (rlim_t{40} << 20);
        const rlimit limit{bytes, bytes};
        if (setrlimit(RLIMIT_AS, &limit) != 0) _exit(2);
        ThreadPool pool(64, 64);
        std::atomic<int> worked = 0;
        run_all(pool, [&](int) { ++worked; });
        _exit(pool.size() < 64 && worked == pool.size() ? 0 : 1);
    }
    int status = 0;
    REQUIRE(waitpid(child, &status, 0) == child);
    CHECK(status == 0);
}

TEST_CASE("a pool hands out every piece, and every number in turn", "[threads]") {
    for (const int threads : {1, 2, 5}) {
        ThreadPool pool(threads, 100);
        for (const std::size_t count : {0, 1, 4, 101, 1'001}) {
            std::vector<std::atomic<int>> taken(count), in_turn(count);
            std::atomic<int> too_large = 0;
            pool.for_each_piece(count, 10, [&](std::size_t begin, std::size_t end) {
                if (end - begin > 10) ++too_large;
                for (std::size_t i = begin; i < end; ++i) ++taken[i];
            });
            pool.for_each_in_turn(count, [&](std::size_t i) { ++in_turn[i]; });
            CHECK(too_large == 0);
            for (const auto& times : taken) CHECK(times == 1);
            for (const auto& times : in_turn) CHECK(times == 1);
        }
    }
}

TEST_CASE("two threads begin far apart, or one after the other if work is in turn", "[threads]") {
    ThreadPool pool(2, 2);
    const auto begun_together = [](const auto& hand_out) {
        std::set<std::size_t> begun;
        std::mutex guards_begun;
        std::latch both(2);
        hand_out([&](std::size_t i) {
            {
                const std::lock_guard lock(guards_begun);
                if (begun.size() == 2) return;
                begun.insert(i);
            }
            both.arrive_and_wait();
        });
        return begun;
    };
    CHECK(begun_together([&](const auto& begin) {
              pool.for_each_piece(100, 1, [&](std::size_t i, std::size_t) { begin(i); });
          }) == std::set<std::size_t>{0, 50});
    CHECK(begun_together([&](const auto& begin) { pool.for_each_in_turn(100, begin); }) == std::set<std::size_t>{0, 1});
}

TEST_CASE("what a thread of a pool throws is thrown when all are done, and the pool goes on", "[threads]") {
    ThreadPool pool(4, 4);
    std::atomic<int> at_work = 0, begun = 0;
    const auto fail_at_50 = [&](std::size_t i) {
        ++at_work;
        ++begun;
        std::this_thread::yield();
        --at_work;
        if (i == 50) throw std::runtime_error("the fiftieth");
    };
    const auto fail_in_pieces = [&] {
        pool.for_each_piece(1'000'000, 1, [&](std::size_t i, std::size_t) { fail_at_50(i); });
    };
    CHECK_THROWS_WITH(fail_in_pieces(), "the fiftieth");
    CHECK((at_work == 0 && begun < 900'000));
    begun = 0;
    CHECK_THROWS_WITH(pool.for_each_in_turn(1'000'000, fail_at_50), "the fiftieth");
    CHECK((at_work == 0 && begun < 900'000));
    std::atomic<int> after = 0;
    run_all(pool, [&](int) { ++after; });
    CHECK(after == 4);
}

TEST_CASE("several threads may ask a pool of one thread at the same time", "[threads]") {
    ThreadPool alone;
    ThreadPool several(4, 4);
    std::vector<int> sums(4);
    run_all(several, [&](int thread) {
        int& sum = sums[static_cast<std::size_t>(thread)];
        alone.for_each_piece(1'000, 7,
                             [&](std::size_t begin, std::size_t end) { sum += static_cast<int>(end - begin); });
    });
    CHECK(sums == std::vector<int>(4, 1'000));
}
