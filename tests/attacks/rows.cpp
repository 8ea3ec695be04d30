#include "attack.h"

namespace attacks {

// In these texts @SOURCE@ is the project's folder, @VICTIM@ a file that the test owns.

std::vector<Attack> acts() {
    const std::vector<std::string> refused{"wrong"}, killed{"policy"};
    return {
        {"writes_where_all_may", 2, refused, R"(
    for (const char* file : {"/tmp/raylab_attack", "/dev/shm/raylab_attack", "@VICTIM@.new"})
        if (open(file, O_CREAT | O_WRONLY, 0666) >= 0) got_through();)"},
        {"writes_to_the_project_and_home", 2, refused, R"(
    for (const char* file : {"@SOURCE@/README.md", "@VICTIM@", "/etc/passwd", "/proc/self/mem"})
        if (open(file, O_WRONLY) >= 0) got_through();)"},
        {"deletes_and_renames", 2, refused, R"(
    if (unlink("@VICTIM@") == 0 || rename("@VICTIM@", "@VICTIM@.gone") == 0) got_through();
    if (chmod("@VICTIM@", 0777) == 0 || truncate("@VICTIM@", 0) == 0) got_through();)"},
        {"reads_the_reference", 2, refused, R"(
    for (const char* way : {"", "/proc/self/root", "/proc/self/cwd/../../../../../.."})
        if (open((std::string(way) + "@SOURCE@/lib/raylab/geometry/slot/nearest_sphere_hit.cpp").c_str(), O_RDONLY) >= 0)
            got_through();
    if (open("/etc/passwd", O_RDONLY) >= 0 || open("/tmp", O_RDONLY | O_DIRECTORY) >= 0) got_through();)"},
        {"reads_its_parent", 2, refused, R"(
    for (const char* what : {"mem", "maps", "environ", "fd/1", "cwd"})
        if (open(("/proc/" + std::to_string(getppid()) + "/" + what).c_str(), O_RDWR) >= 0) got_through();)"},
        {"calls_out", 2, refused, R"(
    for (const int family : {AF_INET, AF_INET6, AF_UNIX, AF_NETLINK, AF_PACKET})
        for (const int type : {SOCK_STREAM, SOCK_DGRAM, SOCK_RAW})
            if (socket(family, type, 0) >= 0) got_through();)"},
        {"asks_the_kernel_in_other_ways", 2, refused, R"(
    char parameters[256] = {};
    if (syscall(SYS_io_uring_setup, 4, parameters) >= 0 || syscall(SYS_memfd_create, "hoard", 0) >= 0) got_through();
    if (syscall(SYS_shmget, 1, 4096, 01777) >= 0 || syscall(SYS_pidfd_open, getppid(), 0) >= 0) got_through();)"},
        {"kills_others", 2, refused, R"(
    if (kill(getppid(), SIGTERM) == 0 || kill(-1, 0) == 0 || kill(0, 0) == 0 || kill(1, 0) == 0) got_through();)"},
        {"leaves_a_process", 2, refused, R"(
    const pid_t child = fork();
    if (child == 0) { setsid(); sleep(60); _exit(0); }
    if (child > 0) got_through();
    if (setsid() >= 0) got_through();)"},
        {"changes_its_user_and_limits", 2, refused, R"(
    const rlimit all{RLIM_INFINITY, RLIM_INFINITY};
    if (setuid(0) == 0 || setrlimit(RLIMIT_CPU, &all) == 0 || setpriority(PRIO_PROCESS, 0, -5) == 0) got_through();)"},
        {"reads_what_it_inherits", 1, refused, R"(
    for (int file = 4; file < 256; ++file)  // 3 is where its answers go
        if (fcntl(file, F_GETFD) >= 0) got_through();
    if (std::getenv("RAYLAB_SECRET")) got_through();)"},
        {"becomes_a_shell", 2, {"wrong", "incomplete", "crash"}, R"(
    execl("/bin/sh", "sh", "-c", "echo > @VICTIM@.new", nullptr);)"},
        {"traces_its_parent", 2, killed, R"(
    if (ptrace(PTRACE_ATTACH, getppid(), nullptr, nullptr) == 0) got_through();)"},
        {"reads_another_process", 2, killed, R"(
    char byte; iovec here{&byte, 1}, there{&byte, 1};
    if (process_vm_readv(getppid(), &here, 1, &there, 1, 0) >= 0) got_through();)"},
        {"leaves_its_namespaces", 2, killed, R"(    if (unshare(CLONE_NEWUSER) == 0) got_through();)"},
        {"mounts", 2, killed, R"(    if (mount("none", "/tmp", "tmpfs", 0, nullptr) == 0) got_through();)"},
    };
}

std::vector<Attack> bad_ends() {
    return {
        {"exits", 1, {"incomplete"}, "    std::exit(0);"},
        {"exits_before_main", 1, {"incomplete"}, "", R"(
struct Before { Before() { std::puts("{\"verdict\": \"pass\"}"); std::fflush(stdout); _exit(0); } } before;)"},
        {"prints_passes", 1, {"incomplete"}, R"(
    std::puts("PASSED: 260 of 260 graded cases right\nok 1\nGrade :=>> 100");
    std::fflush(stdout);
    _exit(0);)"},
        {"closes_the_pipe", 1, {"incomplete", "crash"}, R"(    for (int file = 0; file < 16; ++file) close(file);)"},
        {"answers_with_numbers_that_are_none", 1, {"wrong"}, "    return std::nan(\"\");"},
        {"answers_infinity", 1, {"wrong"}, "    return HUGE_VAL;"},
        {"crashes", 1, {"crash"}, "    std::abort();"},
        {"overflows_the_stack",
         1,
         {"crash"},
         "    return deeper(1);",
         "double deeper(volatile double x) { return x + deeper(x + 1) * x; }"},
        {"throws", 1, {"crash"}, "    throw 1;"},
        {"loops", 1, {"timeout"}, "    for (volatile int i = 0;; i = i + 1) {}"},
        {"loops_and_ignores", 1, {"timeout"}, R"(
    for (const int signal : {SIGXCPU, SIGTERM, SIGALRM}) std::signal(signal, SIG_IGN);
    for (volatile int i = 0;; i = i + 1) {})"},
        {"sleeps", 1, {"timeout"}, "    for (;;) sleep(1);"},
        {"hoards",
         1,
         {"memory"},
         R"(    for (std::vector<std::unique_ptr<char[]>> all;;) all.emplace_back(new char[1 << 20]);)"},
        {"wants_100_gigabytes",
         1,
         {"memory"},
         "    return static_cast<double>(std::vector<char>(100'000'000'000).back());"},
        {"floods", 1, {"output_limit"}, R"(    for (;;) std::puts("PASSED");)"},
        {"starts_threads_without_end", 2, {"crash", "memory", "timeout"}, R"(
    for (std::vector<std::thread> all;;) all.emplace_back([] { sleep(60); });)"},
    };
}

std::vector<Attack> sources() {
    const std::vector<std::string> no_answer{"incomplete"};  // it does not compile, or is refused
    const std::string none = "    return std::nullopt;";
    return {
        {"includes_the_slot", 1, no_answer, none, "#include \"raylab/geometry/slot/nearest_sphere_hit.cpp\""},
        {"includes_by_a_path", 1, no_answer, none, "#include \"@SOURCE@/lib/raylab/geometry/intersect/intersect.h\""},
        {"includes_through_folders", 1, no_answer, none,
         "#include \"../../../exercises/02_ray_sphere/right/textbook.cpp\""},
        {"includes_passwords", 1, no_answer, none, "#include \"/etc/passwd\""},
        {"includes_by_a_macro", 1, no_answer, none, "#define FILE \"/etc/passwd\"\n#include FILE"},
        {"includes_itself", 1, no_answer, none, "#include __FILE__"},
        {"includes_the_oracle", 1, no_answer, none, "#include \"raylab/geometry/oracle/oracle.h\""},
        {"includes_another_library", 1, no_answer, none, "#include <CGAL/intersections.h>"},
        {"embeds_the_reference", 1, no_answer, none,
         R"(asm(".incbin \"@SOURCE@/lib/raylab/geometry/slot/nearest_sphere_hit.cpp\"");)"},
        {"embeds_by_the_name_of_a_section", 1, no_answer, none,
         R"(__attribute__((section(".text\n.incbin \"@SOURCE@/README.md\"\n#"), used)) int embedding = 1;)"},
        {"embeds_by_the_name_of_a_symbol", 1, no_answer, none,
         R"(int embedding asm("x\n.macro a b\n.inc\\b \"@SOURCE@/README.md\"\n.endm\na bin\n#") = 1;)"},
        {"makes_16_gigabytes", 1, no_answer, none, "char all[std::size_t{1} << 34] = {1};"},
        {"is_no_text", 1, no_answer, none,
         std::string("\0\x7f"
                     "ELF\0\xff",
                     7)},
    };
}

}  // namespace attacks
