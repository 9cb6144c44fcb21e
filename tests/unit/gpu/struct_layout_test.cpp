// Host and kernels read the same bytes: every struct that a kernel takes or reaches has the same layout on both sides.
#include "support/gpu_fixture.h"
#include "unit/gpu/host_layouts.h"

#include <catch2/catch_test_macros.hpp>

#include <algorithm>
#include <cctype>
#include <filesystem>

using namespace hyalite;
using testing::Gpu;

namespace {

std::vector<std::string> kernelNames() {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(HYALITE_SOURCE_DIR "/shaders/kernels")) {
        if (entry.path().extension() == ".comp") {
            names.push_back(entry.path().stem().string());
        }
    }
    std::sort(names.begin(), names.end());
    return names;
}

// "trace_closest" to "TraceClosestArguments".
std::string argumentsOf(const std::string& kernel) {
    std::string name;
    bool startsWord = true;
    for (const char c : kernel) {
        if (c == '_') {
            startsWord = true;
        } else {
            name += startsWord ? char(std::toupper(static_cast<unsigned char>(c))) : c;
            startsWord = false;
        }
    }
    return name + "Arguments";
}

// "offset+size" by member, so that a failure shows both sides in full.
std::map<std::string, std::string> byName(const std::vector<gpu::StructMember>& members) {
    std::map<std::string, std::string> places;
    for (const gpu::StructMember& member : members) {
        places[member.name] = std::to_string(member.offset) + '+' + std::to_string(member.size);
    }
    return places;
}

} // namespace

TEST_CASE("every struct of every kernel has the same member offsets and sizes on host and device", "[layout]") {
    const auto layouts = testing::hostLayouts();
    const std::vector<std::string> kernels = kernelNames();
    REQUIRE(!kernels.empty());
    for (const std::string& kernel : kernels) {
        const gpu::KernelInterface interface = gpu::reflect(Gpu::shared().compiler().compile(kernel));
        for (const auto& [name, members] : interface.structs) {
            INFO("kernel " << kernel << ", struct " << name);
            REQUIRE(layouts.contains(name));
            CHECK(byName(members) == byName(layouts.at(name).members));
        }
    }
}

TEST_CASE("every array stride of every kernel is the host's sizeof", "[layout]") {
    const auto layouts = testing::hostLayouts();
    // Elements that are no structs, in bytes: 4 a component.
    const std::map<std::string, std::size_t> plain{{"uint", 4},  {"float", 4}, {"vec2", 8},
                                                   {"uvec2", 8}, {"vec3", 12}, {"vec4", 16}};
    for (const std::string& kernel : kernelNames()) {
        const gpu::KernelInterface interface = gpu::reflect(Gpu::shared().compiler().compile(kernel));
        for (const auto& [element, stride] : interface.arrayStrides) {
            INFO("kernel " << kernel << ", array of " << element);
            const auto layout = layouts.find(element);
            CHECK(stride == (layout != layouts.end() ? layout->second.size : plain.at(element)));
        }
    }
}

TEST_CASE("every kernel takes the Arguments struct of its name as its push constants", "[layout]") {
    const auto layouts = testing::hostLayouts();
    for (const std::string& kernel : kernelNames()) {
        INFO("kernel " << kernel);
        const gpu::KernelInterface interface = gpu::reflect(Gpu::shared().compiler().compile(kernel));
        const std::string arguments = argumentsOf(kernel);
        REQUIRE(interface.structs.contains(arguments));
        REQUIRE(layouts.contains(arguments));
        CHECK(interface.pushConstantBytes == layouts.at(arguments).size);
    }
}
