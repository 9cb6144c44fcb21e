// Writes device arrays of a render as NumPy files: the arrays that a kernel reads or writes, right after one of its
// dispatches.
#pragma once

#include "gpu/context.h"
#include "gpu/dispatch_observer.h"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace hyalite::render {

struct DumpRequest {
    std::string stage; // kernel
    std::string field; // a field of its arguments, e.g. "hits" for whole records or "hits.t" for a member of each
    std::uint32_t dispatch = 0; // number of the stage's dispatch, from 0
    std::filesystem::path file; // .npy
};

// "STAGE:FIELD" or "STAGE:FIELD@DISPATCH"; the file is STAGE.FIELD.npy, or STAGE.FIELD.DISPATCH.npy. Throws
// Error(WrongUsage).
[[nodiscard]] DumpRequest dumpRequest(const std::string& text);

class BufferDump final : public gpu::DispatchObserver {
public:
    // Keeps a reference to the context.
    BufferDump(const gpu::Context& context, std::vector<DumpRequest> requests)
        : context_(context), requests_(std::move(requests)) {}

    void before(const gpu::Dispatch& /*dispatch*/) override {}
    // Throws Error(WrongUsage) if the stage has no such field, Error(OutputNotWritten).
    void after(const gpu::Dispatch& dispatch) override;

    // Throws Error(WrongUsage) if a stage did not run, or not often enough.
    void checkComplete() const;

private:
    const gpu::Context& context_;
    std::vector<DumpRequest> requests_;
    std::map<std::string, std::uint32_t> dispatches_; // so far, by stage
};

} // namespace hyalite::render
