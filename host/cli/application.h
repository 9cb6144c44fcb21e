// The command line: finds the command, runs it, turns failures into one line on stderr and an exit code.
#pragma once

namespace hyalite::cli {

// Exit codes: 0 done, 1 a comparison failed, 2 wrong usage, 3 bad scene or input file, 4 device or driver, 5 output
// not written.
int run(int argc, char** argv);

} // namespace hyalite::cli
