#include "answering.h"
#include "arguments.h"

// The student's program: cases in, answers out. `raylab check 08c` starts it and judges its answers.
int main() {
    using namespace raylab::grading;
    return answer_cases(listing::inputs, listing::outputs,
                        [](auto input, auto output) { listing::answer(&raylab::listed_cells, input, output); });
}
