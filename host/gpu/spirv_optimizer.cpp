#include "gpu/spirv_optimizer.h"

#include <spirv-tools/optimizer.hpp>

#include <unordered_map>

namespace hyalite::gpu {
namespace {

// glslang's output is valid, and the validation layers check what the driver gets, so no validator runs here. On
// failure the code stays as it was.
SpirV run(spvtools::Optimizer& optimizer, SpirV spirv) {
    optimizer.SetMessageConsumer([](auto...) {}); // it warns about functions with several exits, which are not inlined
    spvtools::OptimizerOptions options;
    options.set_run_validator(false);
    SpirV result;
    return optimizer.Run(spirv.data(), spirv.size(), &result, options) ? result : spirv;
}

} // namespace

SpirV inlineFunctions(SpirV spirv) {
    constexpr std::uint32_t kLargestStruct = 100; // members; a larger struct is not split
    spvtools::Optimizer optimizer(SPV_ENV_UNIVERSAL_1_6);
    optimizer.RegisterPass(spvtools::CreateEliminateDeadFunctionsPass())
        .RegisterPass(spvtools::CreateInlineExhaustivePass())
        .RegisterPass(spvtools::CreateEliminateDeadFunctionsPass())
        .RegisterPass(spvtools::CreatePrivateToLocalPass())
        .RegisterPass(spvtools::CreateScalarReplacementPass(kLargestStruct))
        .RegisterPass(spvtools::CreateLocalSingleBlockLoadStoreElimPass())
        .RegisterPass(spvtools::CreateLocalSingleStoreElimPass())
        .RegisterPass(spvtools::CreateSSARewritePass())
        .RegisterPass(spvtools::CreateAggressiveDCEPass())
        .RegisterPass(spvtools::CreateBlockMergePass());
    return run(optimizer, std::move(spirv));
}

SpirV specialize(SpirV spirv, const std::map<std::uint32_t, std::uint32_t>& constants) {
    std::unordered_map<std::uint32_t, std::vector<std::uint32_t>> values;
    for (const auto& [id, value] : constants) {
        values[id] = {value};
    }
    // No pass here changes arithmetic on non-constant values: the bits of every result stay.
    spvtools::Optimizer optimizer(SPV_ENV_UNIVERSAL_1_6);
    optimizer.RegisterPass(spvtools::CreateSetSpecConstantDefaultValuePass(values))
        .RegisterPass(spvtools::CreateFreezeSpecConstantValuePass())
        .RegisterPass(spvtools::CreateFoldSpecConstantOpAndCompositePass())
        .RegisterPass(spvtools::CreateCCPPass())
        .RegisterPass(spvtools::CreateDeadBranchElimPass())
        .RegisterPass(spvtools::CreateAggressiveDCEPass())
        .RegisterPass(spvtools::CreateBlockMergePass())
        .RegisterPass(spvtools::CreateCFGCleanupPass());
    return run(optimizer, std::move(spirv));
}

} // namespace hyalite::gpu
