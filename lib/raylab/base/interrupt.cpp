#include "raylab/base/interrupt.h"

#include <pthread.h>
#include <unistd.h>

#include <csignal>
#include <utility>

namespace raylab {

namespace {

/// The actions to be undone. They are never freed, because an interrupt may come while the process ends.
struct Unfinished {
    std::recursive_mutex mutex;
    std::list<std::function<void()>> undo;
};

Unfinished& unfinished() {
    static Unfinished& only = *new Unfinished;
    return only;
}

sigset_t signals_not_ignored() {
    sigset_t signals;
    sigemptyset(&signals);
    for (const int number : {SIGINT, SIGTERM, SIGHUP}) {
        struct sigaction now {};
        if (sigaction(number, nullptr, &now) == 0 && now.sa_handler != SIG_IGN) sigaddset(&signals, number);
    }
    return signals;
}

const sigset_t& awaited() {
    static const sigset_t signals = signals_not_ignored();
    return signals;
}

// The mutex is kept until the process ends, so that no other thread creates anything new or reports what is missing.
void* wait_for_signal(void*) {
    int number = 0;
    while (sigwait(&awaited(), &number) != 0) {
    }
    unfinished().mutex.lock();
    for (auto undo = unfinished().undo.rbegin(); undo != unfinished().undo.rend(); ++undo) (*undo)();
    _exit(128 + number);
}

void start_waiting() {
    pthread_sigmask(SIG_BLOCK, &awaited(), nullptr);
    pthread_attr_t small;
    pthread_attr_init(&small);
    // Bytes; the usual 8 MiB would count where memory is limited.
    pthread_attr_setstacksize(&small, std::size_t{1} << 18);
    pthread_attr_setdetachstate(&small, PTHREAD_CREATE_DETACHED);
    pthread_t thread;
    const bool started = pthread_create(&thread, &small, wait_for_signal, nullptr) == 0;
    pthread_attr_destroy(&small);
    // Without the thread the signals end the process as they do by default.
    if (!started) pthread_sigmask(SIG_UNBLOCK, &awaited(), nullptr);
}

}  // namespace

AtInterrupt::AtInterrupt(std::function<void()> undo) {
    const Uninterrupted while_added;
    place_ = unfinished().undo.insert(unfinished().undo.end(), std::move(undo));
}

AtInterrupt::~AtInterrupt() {
    const Uninterrupted while_removed;
    unfinished().undo.erase(place_);
}

Uninterrupted::Uninterrupted() : lock_(unfinished().mutex) {}

void end_at_interrupt() {
    static std::once_flag once;
    std::call_once(once, start_waiting);
}

}  // namespace raylab
