// Observes a scene that renders: compares every dispatch with its twin as it happens, and records the paths.
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
    // References are kept. `wanted`: compare these stages alone; empty: all.
    Capture(const gpu::Context& context, const gpu::TexelTables& tables, const Sides& sides,
            std::set<std::string> wanted);

    [[nodiscard]] const PathRecorder& recorder() const { return recorder_; }

    void before(const gpu::Dispatch& dispatch) override;
    void after(const gpu::Dispatch& dispatch) override;

    // In the order of their first dispatch; percentiles are ready. Ends the capture.
    [[nodiscard]] std::vector<StageResult> finish();

private:
    const gpu::Context& context_;
    const gpu::TexelTables& tables_;
    const Sides& sides_;
    std::set<std::string> wanted_;
    std::uint64_t dispatches_ = 0;
    std::optional<Observed> seen_; // the dispatch that runs
    PathRecorder recorder_;
    std::map<std::string, Comparison> stages_;
};

} // namespace hyalite::parity
