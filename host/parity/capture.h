// Observes a render: compares every dispatch with its twin as it happens, and records the paths.
#pragma once

#include "parity/comparison.h"
#include "parity/observed.h"
#include "parity/path_recorder.h"
#include "parity/sides.h"

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace hyalite::parity {

class Capture final : public gpu::DispatchObserver {
public:
    // Keeps references to its arguments. `wanted`: compares only these stages; empty: all.
    Capture(const gpu::Context& context, const gpu::TexelTables& tables, const Sides& sides,
            std::set<std::string> wanted);

    [[nodiscard]] const PathRecorder& recorder() const { return recorder_; }

    void before(const gpu::Dispatch& dispatch) override;
    void after(const gpu::Dispatch& dispatch) override;

    // Ends the capture. Returns the stages in the order of their first dispatch, with percentiles ready.
    [[nodiscard]] std::vector<StageResult> finish();

private:
    const gpu::Context& context_;
    const gpu::TexelTables& tables_;
    const Sides& sides_;
    std::set<std::string> wanted_;
    std::uint64_t dispatches_ = 0;
    std::optional<Observed> seen_; // the running dispatch
    PathRecorder recorder_;
    std::map<std::string, Comparison> stages_;
};

} // namespace hyalite::parity
