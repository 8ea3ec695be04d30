#pragma once

#include <atomic>
#include <functional>
#include <memory>

namespace raylab {

/// A thread that does one piece of work after another, for whoever has hired it. When it is given back it waits for the
/// next one: to start a thread takes 40 to 80 microseconds, and the better part of a millisecond where a virtual
/// machine's other processor has been idle, so that a small picture with four stages had little of its second thread.
/// It ends with the process. (A process made by fork() has none: it hires its own.)
class WorkerThread {
public:
    struct GiveBack {
        void operator()(WorkerThread* worker) const;
    };
    using Hired = std::unique_ptr<WorkerThread, GiveBack>;

    /// One that nobody has, or a new one. Throws std::bad_alloc where there is no memory for it, and std::system_error
    /// where there is none for its stack.
    static Hired hire();

    /// Lets the thread call work(number), as soon as it is awake. The work must not throw, and lives until end() has
    /// returned.
    void begin(const std::function<void(int)>& work, int number);
    /// Takes the work back from a thread that has not begun, and waits for one that has. Call it before the next
    /// begin(), and before the thread is given back.
    void end();

private:
    enum class State { resting, asked, at_work };

    WorkerThread();
    void work_on();
    void wait_while(State old) const;

    const std::function<void(int)>* work_ = nullptr;
    int number_ = 0;
    std::atomic<State> state_ = State::resting;
};

}  // namespace raylab
