// `hyalite live`: serves the page, and what it asks for, over HTTP.
#pragma once

#include "live/server/access.h"
#include "live/supervisor/supervisor.h"

#include <string>

namespace hyalite::live {

struct ServerOptions {
    std::string address = "127.0.0.1"; // to listen at; an IPv6 address with or without brackets. Others than loopback
                                       // addresses require a token
    int port = 7878;                   // 0: any free port
    bool portIsAChoice = false;        // take any free port when this one is not
    bool mayWrite = false;             // the page may save files
    SupervisorOptions supervisor;
};

// Serves until SIGINT or SIGTERM. Prints the page's address by `supervisor.say` before the first request. Throws
// Error(WrongUsage) when it cannot listen at the address.
void serve(ServerOptions options);

// Whether the page's editor is CodeMirror, which knows GLSL and YAML, or a plain text field.
[[nodiscard]] bool hasEditor();

} // namespace hyalite::live
