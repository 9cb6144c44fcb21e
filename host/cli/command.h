// The commands of the program. Each adds its parser to the application and runs in the parser's callback. A callback
// reports failure by throwing Error, or sets `exit` if a comparison failed.
#pragma once

#include "base/error.h"

namespace CLI {
class App;
}

namespace hyalite::cli {

void addRender(CLI::App& app, ExitCode& exit);
void addMerge(CLI::App& app);
void addCompare(CLI::App& app, ExitCode& exit);
void addParity(CLI::App& app, ExitCode& exit);
void addInspect(CLI::App& app);
void addDoctor(CLI::App& app, ExitCode& exit);
void addBench(CLI::App& app);
void addLive(CLI::App& app);
void addLiveWorker(CLI::App& app);

} // namespace hyalite::cli
