#include "raylab/base/thread_pool.h"

#include <pthread.h>
#include <sched.h>

#include <algorithm>
#include <chrono>
#include <utility>

namespace raylab {

namespace {

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

// Waits awake at first: the next round begins soon, and a thread that sleeps takes as long to wake as to start. It does
// not yield meanwhile: where other programs want the processor, that costs a slice of theirs, milliseconds each time.
void wait_while(const std::atomic<int>& value, int old) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::microseconds(50);
    while (value == old && std::chrono::steady_clock::now() < end) {
    }
    value.wait(old);
}

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
        for (int i = 1; i < most; ++i) send_elsewhere(others_.emplace_back([this, i] { work_along(i); }));
        // There is no memory for another thread (std::bad_alloc) or its stack (std::system_error), so the existing ones
        // do the work. Were it thrown on, they would be joined while they wait for a round that never comes.
    } catch (const std::exception&) {
    }
}

ThreadPool::~ThreadPool() {
    work_ = nullptr;
    ++round_;
    round_.notify_all();
}

void ThreadPool::run(const std::function<void(int)>& work) {
    if (others_.empty()) return work(0);
    work_ = &work;
    busy_ = static_cast<int>(others_.size());
    ++round_;
    round_.notify_all();
    do_work(0);
    for (int busy = busy_; busy != 0; busy = busy_) wait_while(busy_, busy);
    if (failure_) std::rethrow_exception(std::exchange(failure_, nullptr));
}

void ThreadPool::work_along(int thread) {
    for (int round = 0;; ++round) {
        wait_while(round_, round);
        if (!work_) return;
        do_work(thread);
        if (--busy_ == 0) busy_.notify_one();
    }
}

void ThreadPool::do_work(int thread) {
    try {
        (*work_)(thread);
    } catch (...) {
        const std::lock_guard lock(guards_failure_);
        if (!failure_) failure_ = std::current_exception();
    }
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
