// Takes device arrays out of a render as NumPy files: what a kernel read or wrote, right after a dispatch of it.
#pragma once

#include "gpu/context.h"
#include "gpu/dispatch_observer.h"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace hyalite::render {

struct DumpRequest {
    std::string stage;          // kernel
    std::string field;          // of its arguments, e.g. "hits" for whole records or "hits.t" for a member of each
    std::uint32_t dispatch = 0; // of the stage, from 0
    std::filesystem::path file; // .npy
};

// "STAGE:FIELD" or "STAGE:FIELD@DISPATCH"; the file is STAGE.FIELD.npy, or STAGE.FIELD.DISPATCH.npy. Throws
// Error(WrongUsage).
[[nodiscard]] DumpRequest dumpRequest(const std::string& text);

class BufferDump final : public gpu::DispatchObserver {
public:
    // A reference is kept.
    BufferDump(const gpu::Context& context, std::vector<DumpRequest> requests)
        : context_(context), requests_(std::move(requests)) {}

    void before(const gpu::Dispatch& /*dispatch*/) override {}
    // Throws Error(WrongUsage) where the stage has no such field, Error(OutputNotWritten).
    void after(const gpu::Dispatch& dispatch) override;

    // Throws Error(WrongUsage) where a stage did not run, or not so often.
    void checkComplete() const;

private:
    const gpu::Context& context_;
    std::vector<DumpRequest> requests_;
    std::map<std::string, std::uint32_t> dispatches_; // so far, by stage
};

} // namespace hyalite::render
