#include "raylab/base/thread_pool.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>

namespace raylab {

namespace {

// The pieces [next, end).
struct Share {
    std::atomic<std::size_t> next = 0;
    std::size_t end = 0;
};

}  // namespace

int core_count() { return std::max(1, static_cast<int>(std::thread::hardware_concurrency())); }

int thread_count(int asked) { return asked > 0 ? asked : core_count(); }

ThreadPool::ThreadPool(int threads, std::size_t pieces) {
    const auto most = static_cast<int>(std::min(pieces, static_cast<std::size_t>(thread_count(threads))));
    try {
        for (int i = 1; i < most; ++i) others_.push_back(WorkerThread::hire());
        // There is no memory for another thread (std::bad_alloc) or its stack (std::system_error), so the existing ones
        // do the work.
    } catch (const std::exception&) {
    }
}

void ThreadPool::run(const std::function<void(int)>& work) {
    if (others_.empty()) return work(0);
    std::mutex guards_first;
    std::exception_ptr first;
    const std::function<void(int)> guarded = [&](int thread) {
        try {
            work(thread);
        } catch (...) {
            const std::lock_guard lock(guards_first);
            if (!first) first = std::current_exception();
        }
    };
    for (int i = 1; i < size(); ++i) others_[static_cast<std::size_t>(i) - 1]->begin(guarded, i);
    guarded(0);
    for (const WorkerThread::Hired& other : others_) other->end();
    if (first) std::rethrow_exception(first);
}

void ThreadPool::for_each_piece(std::size_t count, std::size_t grain,
                                const std::function<void(std::size_t, std::size_t)>& work) {
    const std::size_t pieces = (count + grain - 1) / grain;
    const auto size = static_cast<std::size_t>(this->size());
    std::vector<Share> shares(size);
    for (std::size_t i = 0; i < size; ++i) {
        shares[i].next = pieces * i / size;
        shares[i].end = pieces * (i + 1) / size;
    }
    run([&](int thread) {
        try {
            for (std::size_t i = 0; i < size; ++i) {
                Share& share = shares[(static_cast<std::size_t>(thread) + i) % size];
                for (auto piece = share.next++; piece < share.end; piece = share.next++)
                    work(piece * grain, std::min(count, (piece + 1) * grain));
            }
        } catch (...) {
            for (Share& share : shares) share.next = share.end;
            throw;
        }
    });
}

void ThreadPool::for_each_in_turn(std::size_t count, const std::function<void(std::size_t)>& work) {
    std::atomic<std::size_t> next = 0;
    run([&](int) {
        try {
            for (auto i = next++; i < count; i = next++) work(i);
        } catch (...) {
            next = count;
            throw;
        }
    });
}

}  // namespace raylab
