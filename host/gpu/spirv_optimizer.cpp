#include "gpu/spirv_optimizer.h"

#include <spirv-tools/optimizer.hpp>

namespace hyalite::gpu {

SpirV inlineFunctions(SpirV spirv) {
    constexpr std::uint32_t kLargestStruct = 100; // members; a struct of more stays whole
    spvtools::Optimizer optimizer(SPV_ENV_UNIVERSAL_1_6);
    optimizer.SetMessageConsumer([](auto...) {}); // it warns of functions with several exits, which stay functions
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
    spvtools::OptimizerOptions options;
    options.set_run_validator(false); // glslang's output is valid, and the layers look at what the driver gets
    SpirV result;
    return optimizer.Run(spirv.data(), spirv.size(), &result, options) ? result : spirv;
}

} // namespace hyalite::gpu
