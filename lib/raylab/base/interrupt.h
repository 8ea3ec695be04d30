#pragma once

#include <functional>
#include <list>
#include <mutex>

// On SIGINT, SIGTERM and SIGHUP the program undoes what is unfinished and then ends with exit code 128 + the signal's
// number.

namespace raylab {

/// An action that an interrupt runs while this object exists; the latest comes first, in the order of destructors.
class AtInterrupt {
public:
    /// `undo` runs in a thread of its own while all other threads go on, and must not throw.
    explicit AtInterrupt(std::function<void()> undo);
    ~AtInterrupt();
    AtInterrupt(const AtInterrupt&) = delete;
    AtInterrupt& operator=(const AtInterrupt&) = delete;

private:
    std::list<std::function<void()>>::iterator place_;
};

/// An interrupt waits while this object exists. One that has already begun is not interrupted in turn: the process ends
/// first.
class Uninterrupted {
public:
    Uninterrupted();

private:
    std::unique_lock<std::recursive_mutex> lock_;
};

/// Makes the three signals end the process as described above. It must be called before any thread starts, because
/// threads inherit the blocked signals. A signal that was ignored, as in a background job, stays ignored.
void end_at_interrupt();

}  // namespace raylab
