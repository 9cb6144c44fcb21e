// Reads a kernel's interface from its SPIR-V with SPIRV-Cross: sizes, specialization constants, and the layout of every
// struct that the host must match.
#include "gpu/kernel.h"

#include "base/error.h"
#include "gpu/checked_kernels.h"

#include <spirv_cross.hpp>

#include <algorithm>
#include <set>

namespace hyalite::gpu {
namespace {

using spirv_cross::SPIRType;
using spirv_cross::TypeID;

// Visits the push constants, their members, and the arrays that device addresses refer to.
class LayoutReader {
public:
    LayoutReader(const spirv_cross::Compiler& compiler, KernelInterface& interface)
        : compiler_(compiler), interface_(interface) {}

    // Records the struct, and every struct that its members contain or point to. Returns its alignment.
    std::uint32_t visitStruct(TypeID id, const SPIRType& type) {
        std::vector<StructMember> members;
        std::uint32_t alignment = 1;
        for (std::uint32_t i = 0; i < type.member_types.size(); ++i) {
            alignment = std::max(alignment, visitMember(type, i, members));
        }
        const std::string name = compiler_.get_name(id);
        const auto [known, isNew] = interface_.structs.try_emplace(name, members);
        if (!isNew && !std::equal(members.begin(), members.end(), known->second.begin(), known->second.end(), same)) {
            throw Error(ExitCode::BadInput, "struct '" + name + "' has two layouts in one kernel");
        }
        return alignment;
    }

private:
    static bool same(const StructMember& a, const StructMember& b) {
        return a.name == b.name && a.offset == b.offset && a.size == b.size;
    }

    // Appends the member's scalars and vectors; returns the alignment that scalar layout gives it.
    std::uint32_t visitMember(const SPIRType& owner, std::uint32_t index, std::vector<StructMember>& members) {
        const TypeID id = owner.member_types[index];
        const SPIRType& type = compiler_.get_type(id);
        const std::string name = compiler_.get_member_name(owner.self, index);
        const std::uint32_t offset = compiler_.type_struct_member_offset(owner, index);
        if (type.pointer) {
            members.push_back({name, offset, sizeof(std::uint64_t), visitDeviceArray(type), true});
            return sizeof(std::uint64_t);
        }
        if (type.basetype == SPIRType::Struct) {
            const std::uint32_t alignment = visitStruct(type.self, type);
            for (const StructMember& inner : interface_.structs.at(compiler_.get_name(type.self))) {
                members.push_back(
                    {name + '.' + inner.name, offset + inner.offset, inner.size, inner.type, inner.isArray});
            }
            return alignment;
        }
        members.push_back({name, offset, std::uint32_t(compiler_.get_declared_struct_member_size(owner, index)),
                           elementName(type), false});
        return type.width / 8;
    }

    // A buffer_reference block; its one member is the array. Returns the name of the elements' type.
    std::string visitDeviceArray(const SPIRType& pointer) {
        const SPIRType& block = compiler_.get_type(pointer.parent_type);
        if (block.member_types.empty()) {
            return {};
        }
        const SPIRType& array = compiler_.get_type(block.member_types[0]);
        if (array.array.empty()) {
            return {};
        }
        const SPIRType& element = compiler_.get_type(array.parent_type);
        if (!visitedBlocks_.insert(block.self).second) {
            return elementName(element);
        }
        interface_.arrayStrides[elementName(element)] = compiler_.type_struct_member_array_stride(block, 0);
        if (element.basetype == SPIRType::Struct) {
            visitStruct(element.self, element);
        }
        return elementName(element);
    }

    // The struct's name, or GLSL's for a scalar or vector.
    [[nodiscard]] std::string elementName(const SPIRType& type) const {
        const std::string size = std::to_string(type.vecsize);
        switch (type.basetype) {
        case SPIRType::Struct:
            return compiler_.get_name(type.self);
        case SPIRType::Float:
            return type.vecsize == 1 ? "float" : "vec" + size;
        case SPIRType::UInt:
            return type.vecsize == 1 ? "uint" : "uvec" + size;
        case SPIRType::Int:
            return type.vecsize == 1 ? "int" : "ivec" + size;
        default:
            throw Error(ExitCode::BadInput, "device array with an unknown element type");
        }
    }

    const spirv_cross::Compiler& compiler_;
    KernelInterface& interface_;
    std::set<std::uint32_t> visitedBlocks_;
};

void readPushConstants(const spirv_cross::Compiler& compiler, KernelInterface& interface) {
    const auto blocks = compiler.get_shader_resources().push_constant_buffers;
    if (blocks.empty()) {
        return;
    }
    const SPIRType& block = compiler.get_type(blocks[0].base_type_id);
    LayoutReader reader(compiler, interface);
    std::uint32_t alignment = 1;
    for (const TypeID member : block.member_types) {
        const SPIRType& type = compiler.get_type(member);
        if (type.basetype != SPIRType::Struct || type.pointer) {
            throw Error(ExitCode::BadInput, "push constants must be one Arguments struct");
        }
        alignment = std::max(alignment, reader.visitStruct(type.self, type));
    }
    // Rounded up as C++ rounds sizeof; scalar layout itself ends at the last member.
    const auto end = std::uint32_t(compiler.get_declared_struct_size(block));
    interface.pushConstantBytes = (end + alignment - 1) / alignment * alignment;
}

// Texel tables are the only resources that kernels bind: everything else is accessed by address.
void readTables(const spirv_cross::Compiler& compiler, KernelInterface& interface) {
    const spirv_cross::ShaderResources resources = compiler.get_shader_resources();
    if (!resources.uniform_buffers.empty() || !resources.storage_buffers.empty() || !resources.storage_images.empty()) {
        throw Error(ExitCode::BadInput, "a kernel may bind texel tables only; use a device array of shared/language.h");
    }
    // glslang 12 and 15 declare a samplerBuffer in different ways.
    for (const auto* images : {&resources.sampled_images, &resources.separate_images}) {
        for (const spirv_cross::Resource& image : *images) {
            const SPIRType& texel = compiler.get_type(compiler.get_type(image.base_type_id).image.type);
            const bool isTable = compiler.get_type(image.base_type_id).image.dim == spv::DimBuffer;
            const bool isKnown = texel.basetype == SPIRType::Float || texel.basetype == SPIRType::UInt;
            if (!isTable || !isKnown || compiler.get_decoration(image.id, spv::DecorationDescriptorSet) != 0) {
                throw Error(ExitCode::BadInput,
                            '\'' + image.name + "' must be a samplerBuffer or usamplerBuffer of set 0");
            }
            interface.tables[compiler.get_decoration(image.id, spv::DecorationBinding)] =
                texel.basetype == SPIRType::Float ? TexelFormat::Float4 : TexelFormat::Uint4;
        }
    }
    if constexpr (kCheckedKernels) { // the table of the bounds checks
        interface.tables.erase(kCheckBinding);
    }
}

} // namespace

KernelInterface reflect(const SpirV& spirv) {
    KernelInterface interface;
    try {
        const spirv_cross::Compiler compiler(spirv);
        interface.localSize = compiler.get_execution_mode_argument(spv::ExecutionModeLocalSize, 0);
        for (const spirv_cross::SpecializationConstant& constant : compiler.get_specialization_constants()) {
            interface.specializationConstants[compiler.get_name(constant.id)] = constant.constant_id;
        }
        readPushConstants(compiler, interface);
        readTables(compiler, interface);
    } catch (const spirv_cross::CompilerError& error) {
        throw Error(ExitCode::BadInput, std::string("cannot read the SPIR-V: ") + error.what());
    }
    return interface;
}

} // namespace hyalite::gpu
