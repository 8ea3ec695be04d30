#include "raylab/base/standard_streams.h"

#include <fcntl.h>
#include <unistd.h>

namespace raylab {

void open_missing_standard_streams() {
    // open() returns the lowest free descriptor, and those below this one are open by now.
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
        if (fcntl(stream, F_GETFD) < 0 && open("/dev/null", O_RDONLY) < 0) return;
}

}  // namespace raylab
