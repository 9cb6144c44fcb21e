// One context for the whole program, because opening a device takes longer than most tests.
#include "support/gpu_fixture.h"

#include "gpu/lavapipe.h"
#include "shaders/shared/scene_records.h"

#include <cstdio>
#include <cstdlib>

namespace hyalite::testing {

Gpu::Gpu() : compiler_(HYALITE_SOURCE_DIR "/shaders", HYALITE_TEST_CACHE) {
    gpu::prepareLavapipe(HYALITE_TEST_CACHE);
    gpu::ContextOptions options;
    options.validation = std::getenv("HYALITE_VALIDATION") != nullptr; // NOLINT(concurrency-mt-unsafe): nobody sets it
    options.onValidationMessage = [this](const std::string& text) {
        ++messages_;
        std::fprintf(stderr, "validation: %s\n", text.c_str());
    };
    context_ = std::make_unique<gpu::Context>(options);
    tables_ = std::make_unique<gpu::TexelTables>(*context_, TABLE_COUNT);
}

// Runs after main, so that validation messages during clean-up count too; Catch2 has already reported by then.
Gpu::~Gpu() {
    kernels_.clear();
    tables_.reset();
    context_.reset();
    if (messages_ > 0) {
        std::fprintf(stderr, "%u validation messages\n", messages_.load());
        std::fflush(nullptr);
        std::_Exit(EXIT_FAILURE);
    }
}

const gpu::Kernel& Gpu::kernel(const std::string& name, const gpu::Specialization& specialization) {
    const auto key = std::pair(name, specialization);
    auto found = kernels_.find(key);
    if (found == kernels_.end()) {
        found = kernels_.emplace(key, gpu::Kernel(*context_, *tables_, compiler_, name, specialization)).first;
    }
    return found->second;
}

Gpu& Gpu::shared() {
    static Gpu gpu;
    return gpu;
}

} // namespace hyalite::testing
