// Compiles every kernel at build time: a mistake stops the build, and the program starts without compiling.
// usage: compile_kernels SHADERS FOLDER STAMP
#include "base/error.h"
#include "base/parallel.h"
#include "gpu/shader_compiler.h"

#include <fstream>
#include <iostream>

namespace {

void compileAll(const std::filesystem::path& shaders, const std::filesystem::path& folder) {
    std::vector<std::string> kernels;
    for (const auto& entry : std::filesystem::directory_iterator(shaders / "kernels")) {
        if (entry.path().extension() == ".comp") {
            kernels.push_back(entry.path().stem().string());
        }
    }
    const hyalite::gpu::ShaderCompiler compiler(shaders, folder);
    hyalite::parallelFor(kernels.size(), 1, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            static_cast<void>(compiler.compile(kernels[i]));
        }
    });
}

} // namespace

int main(int argc, char** argv) {
    if (argc != 4) {
        std::cerr << "usage: compile_kernels SHADERS FOLDER STAMP\n";
        return static_cast<int>(hyalite::ExitCode::WrongUsage);
    }
    try {
        compileAll(argv[1], argv[2]);
        std::ofstream(argv[3]) << "compiled\n";
    } catch (const hyalite::Error& error) {
        std::cerr << error.what() << '\n';
        return static_cast<int>(error.code());
    }
    return 0;
}
