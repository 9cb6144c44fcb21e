// Entry point of hyalite; see cli/application.h.
#include "cli/application.h"

int main(int argc, char** argv) {
    return hyalite::cli::run(argc, argv);
}
