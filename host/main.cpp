// hyalite: parse, dispatch to a command; nothing else.
#include "cli/application.h"

int main(int argc, char** argv) {
    return hyalite::cli::run(argc, argv);
}
