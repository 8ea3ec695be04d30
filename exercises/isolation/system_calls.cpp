#include "system_calls.h"

#include <sched.h>
#include <seccomp.h>
#include <unistd.h>

#include <cerrno>
#include <memory>
#include <system_error>

namespace raylab::grading {

namespace {

using Filter = std::unique_ptr<void, void (*)(scmp_filter_ctx)>;

void checked(int result, const char* what) {
    if (result < 0) throw std::system_error(-result, std::generic_category(), what);
}

template <class... Conditions>
void rule(const Filter& filter, std::uint32_t action, const char* name, Conditions... conditions) {
    const int call = seccomp_syscall_resolve_name(name);
    if (call == __NR_SCMP_ERROR) return;  // libseccomp is older than the call: the default holds
    checked(seccomp_rule_add(filter.get(), action, call, sizeof...(conditions), conditions...), name);
}

// They reach into other processes, or change the machine: nobody calls them by mistake.
constexpr const char* deadly[] = {"ptrace",
                                  "process_vm_readv",
                                  "process_vm_writev",
                                  "process_madvise",
                                  "kcmp",
                                  "pidfd_getfd",
                                  "mount",
                                  "umount2",
                                  "pivot_root",
                                  "chroot",
                                  "unshare",
                                  "setns",
                                  "move_mount",
                                  "open_tree",
                                  "fsopen",
                                  "fsmount",
                                  "bpf",
                                  "keyctl",
                                  "add_key",
                                  "request_key",
                                  "userfaultfd",
                                  "perf_event_open",
                                  "kexec_load",
                                  "init_module",
                                  "finit_module",
                                  "delete_module",
                                  "reboot",
                                  "swapon",
                                  "swapoff",
                                  "acct",
                                  "quotactl",
                                  "sethostname",
                                  "setdomainname",
                                  "iopl",
                                  "ioperm",
                                  "settimeofday",
                                  "clock_settime",
                                  "adjtimex",
                                  "vhangup",
                                  "syslog",
                                  "lookup_dcookie",
                                  "open_by_handle_at",
                                  "name_to_handle_at"};

// What a compiler does not need either.
constexpr const char* refused_to_compilers[] = {"socket",
                                                "socketpair",
                                                "connect",
                                                "bind",
                                                "listen",
                                                "accept",
                                                "accept4",
                                                "io_uring_setup",
                                                "io_uring_enter",
                                                "io_uring_register",
                                                "memfd_create",
                                                "shmget",
                                                "shmat",
                                                "msgget",
                                                "semget",
                                                "mq_open",
                                                "inotify_init",
                                                "inotify_init1",
                                                "fanotify_init",
                                                "kill",
                                                "tkill",
                                                "tgkill",
                                                "pidfd_open",
                                                "pidfd_send_signal",
                                                "rt_sigqueueinfo",
                                                "rt_tgsigqueueinfo",
                                                "setuid",
                                                "setgid",
                                                "setreuid",
                                                "setregid",
                                                "setresuid",
                                                "setresgid",
                                                "setgroups",
                                                "setsid",
                                                "setpgid",
                                                "personality",
                                                "setpriority",
                                                "sched_setscheduler",
                                                "prctl"};

// Landlock knows nothing of them.
constexpr const char* refused_to_drawers[] = {"chmod",    "fchmod",    "fchmodat", "chown",  "fchown",
                                              "lchown",   "fchownat",  "utime",    "utimes", "utimensat",
                                              "setxattr", "lsetxattr", "fsetxattr"};

// What a program needs that computes: memory, time, threads, signals to itself, and the descriptors that it was given.
constexpr const char* allowed_to_answers[] = {"read",
                                              "write",
                                              "readv",
                                              "writev",
                                              "close",
                                              "lseek",
                                              "fstat",
                                              "dup",
                                              "dup2",
                                              "dup3",
                                              "fcntl",
                                              "poll",
                                              "mmap",
                                              "munmap",
                                              "mprotect",
                                              "mremap",
                                              "madvise",
                                              "brk",
                                              "rt_sigaction",
                                              "rt_sigprocmask",
                                              "rt_sigreturn",
                                              "sigaltstack",
                                              "exit",
                                              "exit_group",
                                              "futex",
                                              "clock_gettime",
                                              "clock_getres",
                                              "clock_nanosleep",
                                              "nanosleep",
                                              "gettimeofday",
                                              "time",
                                              "times",
                                              "getrusage",
                                              "getpid",
                                              "getppid",
                                              "gettid",
                                              "getuid",
                                              "geteuid",
                                              "getgid",
                                              "getegid",
                                              "getrandom",
                                              "sched_yield",
                                              "sched_getaffinity",
                                              "set_robust_list",
                                              "set_tid_address",
                                              "rseq",
                                              "arch_prctl",
                                              "uname",
                                              "sysinfo",
                                              "getcpu",
                                              "restart_syscall",
                                              "execve",
                                              "membarrier"};

// What a loader needs to open libraries. Which files that may be is up to Landlock.
constexpr const char* allowed_to_loaders[] = {"openat",   "open",       "pread64", "newfstatat",
                                              "readlink", "readlinkat", "access"};

// glibc then asks for clone, whose flags a filter can see.
void refuse_clone3(const Filter& filter) { rule(filter, SCMP_ACT_ERRNO(ENOSYS), "clone3"); }

void fill_for_compilers(const Filter& filter) {
    for (const auto* name : refused_to_compilers) rule(filter, SCMP_ACT_ERRNO(EPERM), name);
    for (const scmp_datum_t space : {CLONE_NEWUSER, CLONE_NEWNS, CLONE_NEWPID, CLONE_NEWNET})
        rule(filter, SCMP_ACT_ERRNO(EPERM), "clone", SCMP_A0(SCMP_CMP_MASKED_EQ, space, space));
}

void fill_for_answers(const Filter& filter) {
    const auto own = static_cast<scmp_datum_t>(getpid());  // the same after execve
    for (const auto* name : allowed_to_answers) rule(filter, SCMP_ACT_ALLOW, name);
    for (const auto* name : {"kill", "tgkill"}) rule(filter, SCMP_ACT_ALLOW, name, SCMP_A0(SCMP_CMP_EQ, own));
    rule(filter, SCMP_ACT_ALLOW, "clone", SCMP_A0(SCMP_CMP_MASKED_EQ, CLONE_THREAD, CLONE_THREAD));
    rule(filter, SCMP_ACT_ALLOW, "prlimit64", SCMP_A2(SCMP_CMP_EQ, 0));  // asks, and sets nothing
}

}  // namespace

void filter_system_calls(Work work) {
    const bool opens_files = may_write(work);
    const auto otherwise = opens_files ? SCMP_ACT_ALLOW : SCMP_ACT_ERRNO(EPERM);
    const Filter filter(seccomp_init(otherwise), seccomp_release);
    if (!filter) throw std::system_error(ENOMEM, std::generic_category(), "seccomp_init");
    // Calls by another architecture's numbers would pass a list of this one's.
    checked(seccomp_attr_set(filter.get(), SCMP_FLTATR_ACT_BADARCH, SCMP_ACT_KILL_PROCESS), "another architecture");
    for (const auto* name : deadly) rule(filter, SCMP_ACT_KILL_PROCESS, name);
    refuse_clone3(filter);
    if (opens_files) fill_for_compilers(filter);
    if (!opens_files) fill_for_answers(filter);
    if (work == Work::draw || work == Work::render)
        for (const auto* name : refused_to_drawers) rule(filter, SCMP_ACT_ERRNO(EPERM), name);
    if (work == Work::load_and_answer)
        for (const auto* name : allowed_to_loaders) rule(filter, SCMP_ACT_ALLOW, name);
    checked(seccomp_load(filter.get()), "seccomp_load");
}

}  // namespace raylab::grading
