#include "cli/application.h"

#include "cli/command.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cctype>
#include <csignal>
#include <iostream>
#include <new>

namespace hyalite::cli {

namespace {

// Prints one line on stderr; control characters of file names and options become '?'.
int fail(ExitCode code, const std::string& what) {
    std::string line = what;
    std::ranges::replace_if(line, [](unsigned char c) { return std::iscntrl(c) != 0; }, '?');
    std::cerr << "hyalite: " << line << '\n';
    return static_cast<int>(code);
}

int parseAndRun(int argc, char** argv) {
    CLI::App app{"hyalite renders light through glass: photon mapping in Vulkan compute shaders."};
    app.name("hyalite");
    app.set_version_flag("--version", "hyalite " HYALITE_VERSION);
    app.require_subcommand(1);
    ExitCode exit = ExitCode::Done;
    addRender(app, exit);
    addMerge(app);
    addCompare(app, exit);
    addParity(app, exit);
    addInspect(app);
    addDoctor(app, exit);
    addBench(app);
    addLive(app);
    addLiveWorker(app);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() == 0) { // --help, --version
            return app.exit(error);
        }
        return fail(ExitCode::WrongUsage, std::string(error.what()) + " (see hyalite --help)");
    }
    std::cout.flush();
    if (!std::cout) {
        return fail(ExitCode::OutputNotWritten, "cannot write standard output (is the disk full?)");
    }
    return static_cast<int>(exit);
}

} // namespace

int run(int argc, char** argv) {
    std::signal(SIGXFSZ, SIG_IGN); // beyond the file size limit a write fails instead of killing the program
    try {
        return parseAndRun(argc, argv);
    } catch (const Error& error) {
        return fail(error.code(), error.what());
    } catch (const std::bad_alloc&) {
        return fail(ExitCode::Device, "out of memory (a smaller --resolution or --photons needs less)");
    } catch (const std::exception& error) {
        return fail(ExitCode::Device, std::string("unexpected failure: ") + error.what());
    }
}

} // namespace hyalite::cli
