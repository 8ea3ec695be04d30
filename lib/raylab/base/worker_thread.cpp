#include "raylab/base/worker_thread.h"

#include "raylab/base/heap.h"

#include <pthread.h>
#include <sched.h>

#include <chrono>
#include <mutex>
#include <thread>
#include <vector>

namespace raylab {

namespace {

// Sends a new thread away from the processor of the one that starts it; once there, it may run anywhere. Linux itself
// puts a new thread on an idle processor, but in a virtual machine it may take that for one which the host has taken
// away (vcpu_is_preempted). Then both threads share one processor, 4 ms each in turn, until the load is balanced 10 to
// 20 ms later.
void send_elsewhere(std::thread& thread) {
    cpu_set_t all;
    const int here = sched_getcpu();
    if (here < 0 || sched_getaffinity(0, sizeof all, &all) != 0) return;
    cpu_set_t others = all;
    CPU_CLR(static_cast<std::size_t>(here), &others);
    if (CPU_COUNT(&others) == 0) return;
    pthread_setaffinity_np(thread.native_handle(), sizeof others, &others);
    pthread_setaffinity_np(thread.native_handle(), sizeof all, &all);
}

// Those that nobody has. They are not destroyed, because threads wait on them.
class Idle {
public:
    std::mutex guards;
    std::vector<WorkerThread*> workers;

    static Idle& all() {
        static Idle& only = *new Idle;
        return only;
    }

private:
    // fork() copies no thread but the one that calls it.
    Idle() {
        pthread_atfork([] { all().guards.lock(); }, [] { all().guards.unlock(); },
                       [] {
                           all().workers.clear();
                           all().guards.unlock();
                       });
    }
};

}  // namespace

WorkerThread::Hired WorkerThread::hire() {
    {
        Idle& idle = Idle::all();
        const std::lock_guard lock(idle.guards);
        if (!idle.workers.empty()) {
            WorkerThread* const last = idle.workers.back();
            idle.workers.pop_back();
            return Hired(last);
        }
        idle.workers.reserve(idle.workers.capacity() + 1);  // nothing is thrown when it is given back
    }
    return Hired(new WorkerThread);
}

void WorkerThread::GiveBack::operator()(WorkerThread* worker) const {
    Idle& idle = Idle::all();
    const std::lock_guard lock(idle.guards);
    idle.workers.push_back(worker);
}

WorkerThread::WorkerThread() {
    std::thread thread([this] { work_on(); });
    send_elsewhere(thread);
    thread.detach();
}

void WorkerThread::begin(const std::function<void(int)>& work, int number) {
    work_ = &work;
    number_ = number;
    state_ = State::asked;
    state_.notify_one();
}

void WorkerThread::end() {
    State asked = State::asked;
    if (!state_.compare_exchange_strong(asked, State::resting)) wait_while(State::at_work);
}

void WorkerThread::work_on() {
    put_heap_on_large_pages();
    while (true) {
        wait_while(State::resting);
        State asked = State::asked;
        if (!state_.compare_exchange_strong(asked, State::at_work)) continue;  // it was taken back
        (*work_)(number_);
        state_ = State::resting;
        state_.notify_one();
    }
}

// Awake at first: the next work begins soon, and a thread that sleeps takes as long to wake as to start. It does not
// yield meanwhile: where other programs want the processor, that costs a slice of theirs, milliseconds each time.
void WorkerThread::wait_while(State old) const {
    const auto end = std::chrono::steady_clock::now() + std::chrono::microseconds(200);
    while (state_ == old && std::chrono::steady_clock::now() < end) {
    }
    state_.wait(old);
}

}  // namespace raylab
