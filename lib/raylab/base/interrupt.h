#pragma once

#include <functional>
#include <list>
#include <mutex>

// SIGINT, SIGTERM and SIGHUP undo what is unfinished, then end the process with exit code 128 + the signal's number.

namespace raylab {

/// What an interrupt undoes while this exists; the latest is undone first, as destructors would.
class AtInterrupt {
public:
    /// `undo` runs in a thread of its own while all others go on, and must not throw.
    explicit AtInterrupt(std::function<void()> undo);
    ~AtInterrupt();
    AtInterrupt(const AtInterrupt&) = delete;
    AtInterrupt& operator=(const AtInterrupt&) = delete;

private:
    std::list<std::function<void()>>::iterator place_;
};

/// An interrupt waits while this exists. One that has begun is never waited out: the process ends first.
class Uninterrupted {
public:
    Uninterrupted();

private:
    std::unique_lock<std::recursive_mutex> lock_;
};

/// Lets the three signals end the process as said above. To be called before any thread starts, because threads inherit
/// that the signals are blocked; a signal that was ignored, as in a background job, stays ignored.
void end_at_interrupt();

}  // namespace raylab
