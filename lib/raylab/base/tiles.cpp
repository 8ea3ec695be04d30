#include "raylab/base/tiles.h"

#include "raylab/base/progress.h"

#include <pthread.h>
#include <sched.h>

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace raylab {

namespace {

// Pixels a side: small enough to balance two cores at 64 x 64, large compared with one atomic operation.
constexpr int tile_size = 16;

// Sends a new thread away from the processor of the one that starts it; once there, it may run anywhere. Linux itself
// puts a new thread on an idle processor, but in a virtual machine it may take that for one which the host has taken
// away (vcpu_is_preempted). Then both threads share one processor, 4 ms each in turn, until the load is balanced 10 to
// 20 ms later.
void send_elsewhere(std::jthread& thread) {
    cpu_set_t all;
    const int here = sched_getcpu();
    if (here < 0 || sched_getaffinity(0, sizeof all, &all) != 0) return;
    cpu_set_t others = all;
    CPU_CLR(static_cast<std::size_t>(here), &others);
    if (CPU_COUNT(&others) == 0) return;
    pthread_setaffinity_np(thread.native_handle(), sizeof others, &others);
    pthread_setaffinity_np(thread.native_handle(), sizeof all, &all);
}

}  // namespace

int core_count() { return std::max(1, static_cast<int>(std::thread::hardware_concurrency())); }

int thread_count(int asked) { return asked > 0 ? asked : core_count(); }

void for_each_piece(std::size_t count, std::size_t grain, int threads,
                    const std::function<void(std::size_t, std::size_t)>& work) {
    const std::size_t pieces = (count + grain - 1) / grain;
    std::atomic<std::size_t> next = 0;
    std::exception_ptr failure;
    std::mutex guards_failure;
    const auto run = [&] {
        for (auto piece = next++; piece < pieces; piece = next++) {
            try {
                work(piece * grain, std::min(count, (piece + 1) * grain));
            } catch (...) {
                const std::lock_guard lock(guards_failure);
                if (!failure) failure = std::current_exception();
                next = pieces;
            }
        }
    };
    const auto wanted = static_cast<std::size_t>(thread_count(threads));
    {
        std::vector<std::jthread> others;
        try {
            for (std::size_t i = 1; i < std::min(wanted, pieces); ++i) send_elsewhere(others.emplace_back(run));
            // There is no memory for another thread's stack, so the existing threads do the work.
        } catch (const std::system_error&) {
        }
        run();
    }
    if (failure) std::rethrow_exception(failure);
}

void for_each_tile(int width, int height, int threads, const std::string& label,
                   const std::function<void(Tile)>& work) {
    const int across = (width + tile_size - 1) / tile_size;
    const int down = (height + tile_size - 1) / tile_size;
    const auto count = static_cast<std::size_t>(across) * static_cast<std::size_t>(down);
    Progress progress(label, count);
    for_each_piece(count, 1, threads, [&](std::size_t begin, std::size_t) {
        const int column = static_cast<int>(begin) % across;
        const int row = static_cast<int>(begin) / across;
        const int x = column * tile_size;
        const int y = row * tile_size;
        work({x, y, std::min(x + tile_size, width), std::min(y + tile_size, height)});
        progress.step();
    });
}

}  // namespace raylab
