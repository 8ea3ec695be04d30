#pragma once

#include "raylab/base/worker_thread.h"

#include <cstddef>
#include <functional>
#include <vector>

namespace raylab {

/// The number of threads that "all cores" means on this machine (at least 1).
int core_count();

/// The number of threads that an option asks for: as many as it says, or for 0 all cores.
int thread_count(int asked);

/// Threads that work together: the one that makes the pool, and others that wait for it.
class ThreadPool {
public:
    /// The calling thread alone.
    ThreadPool() = default;
    /// As many threads as `threads` says (0: all cores), with the calling one; no more than there are pieces of work,
    /// and fewer if there is no memory for their stacks.
    ThreadPool(int threads, std::size_t pieces);
    ThreadPool(const ThreadPool&) = delete;
    ThreadPool& operator=(const ThreadPool&) = delete;

    int size() const { return static_cast<int>(others_.size()) + 1; }

    /// Calls work(0) in this thread and, at the same time, work(1) to work(size() - 1) in the others: what there is to
    /// do, they share. Another one that has not begun when this one is done is not waited for, nothing being left. The
    /// first exception that any of them throws is thrown here, when all are done. One round at a time, save in a pool
    /// of one thread: that may be asked by several threads, each of which then works for itself.
    void run(const std::function<void(int thread)>& work);

    /// Calls work(begin, end) for an index range [0, count), in pieces of at most `grain`. Each thread begins with a
    /// share of its own, one piece after the other, and helps with the next share when its own is done: so threads
    /// seldom write where another one does, nor wait for the same new page of memory. No piece begins after one has
    /// thrown.
    void for_each_piece(std::size_t count, std::size_t grain,
                        const std::function<void(std::size_t begin, std::size_t end)>& work);

    /// Calls work(i) for each i below `count`: the next one for whichever thread is free. None begins after one has
    /// thrown.
    void for_each_in_turn(std::size_t count, const std::function<void(std::size_t i)>& work);

private:
    std::vector<WorkerThread::Hired> others_;
};

}  // namespace raylab
