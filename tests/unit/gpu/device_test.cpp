// Device selection, and the errors if no device is usable.
#include "base/error.h"
#include "support/gpu_fixture.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

using namespace hyalite;
using Catch::Matchers::ContainsSubstring;
using gpu::DeviceInfo;

namespace {

const std::vector<DeviceInfo> kMachine{
    {.name = "llvmpipe (LLVM 15)", .driver = "", .software = true, .missing = {}},
    {.name = "Old Card 1000", .driver = "", .software = false, .missing = {"scalarBlockLayout", "synchronization2"}},
    {.name = "New Card 2000", .driver = "", .software = false, .missing = {}},
    {.name = "New Card 3000", .driver = "", .software = false, .missing = {}},
};

std::string refusal(const std::vector<DeviceInfo>& devices, const std::string& wanted) {
    try {
        static_cast<void>(gpu::chooseDevice(devices, wanted));
    } catch (const Error& error) {
        CHECK(error.code() == ExitCode::Device);
        return error.what();
    }
    return "no error";
}

} // namespace

TEST_CASE("the first usable GPU is taken before a software device and an unusable GPU", "[device]") {
    CHECK(gpu::chooseDevice(kMachine, "") == 2);
}

TEST_CASE("a software device is taken when no GPU is usable", "[device]") {
    CHECK(gpu::chooseDevice({kMachine[1], kMachine[0]}, "") == 1);
}

TEST_CASE("a device is chosen by index or by part of its name in any case", "[device]") {
    CHECK(gpu::chooseDevice(kMachine, "0") == 0);
    CHECK(gpu::chooseDevice(kMachine, "3") == 3);
    CHECK(gpu::chooseDevice(kMachine, "LLVMpipe") == 0);
    CHECK(gpu::chooseDevice(kMachine, "card 3") == 3);
}

TEST_CASE("a missing device is refused with the list of available ones", "[device]") {
    const std::string unknown = refusal(kMachine, "GeForce");
    CHECK_THAT(unknown, ContainsSubstring("no Vulkan device 'GeForce'"));
    CHECK_THAT(unknown, ContainsSubstring("0: llvmpipe (LLVM 15), 1: Old Card 1000"));
    CHECK_THAT(refusal(kMachine, "4"), ContainsSubstring("no Vulkan device '4'"));
}

TEST_CASE("a name that several devices share is refused", "[device]") {
    CHECK_THAT(refusal(kMachine, "new card"), ContainsSubstring("several Vulkan devices match 'new card'"));
}

TEST_CASE("a device that lacks a feature is refused with the name of the feature", "[device]") {
    CHECK_THAT(refusal(kMachine, "1"), ContainsSubstring("Old Card 1000 lacks scalarBlockLayout, synchronization2"));
    CHECK_THAT(refusal({kMachine[1]}, ""), ContainsSubstring("Old Card 1000 lacks scalarBlockLayout"));
}

TEST_CASE("a machine without drivers is told what to install", "[device]") {
    CHECK_THAT(refusal({}, ""), ContainsSubstring("mesa-vulkan-drivers"));
}

TEST_CASE("the context's device is the one that the list shows", "[device]") {
    const DeviceInfo& opened = testing::Gpu::shared().context().info();
    const std::vector<DeviceInfo> devices = gpu::listDevices();
    const DeviceInfo& listed = devices.at(gpu::chooseDevice(devices, ""));
    CHECK(opened.name == listed.name);
    CHECK(opened.driver == listed.driver);
    CHECK(opened.missing.empty());
}

TEST_CASE("a context for an unknown device is refused", "[device]") {
    CHECK_THROWS_AS(gpu::Context({.device = "no such device", .validation = false, .onValidationMessage = {}}), Error);
}
