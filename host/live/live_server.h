// `hyalite live`: the page, and what it asks for, over HTTP.
#pragma once

#include "live/access.h"
#include "live/supervisor.h"

#include <string>

namespace hyalite::live {

struct ServerOptions {
    std::string address = "127.0.0.1"; // to listen at; another than loopback needs a token
    int port = 7878;                   // 0: any that is free
    bool portIsAChoice = false;        // any other does as well
    bool mayWrite = false;             // the page may save files
    SupervisorOptions supervisor;
};

// Serves until SIGINT or SIGTERM. Says on `say` where, before the first request. Throws Error(WrongUsage) where the
// address cannot be listened at.
void serve(ServerOptions options);

// Whether the page's editor knows GLSL and YAML, or is a plain text field.
[[nodiscard]] bool hasEditor();

} // namespace hyalite::live
