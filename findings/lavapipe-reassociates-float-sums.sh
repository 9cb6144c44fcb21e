#!/usr/bin/env bash
# Lavapipe computes (x + y) - x as y where the shader does not say `precise`.
#
# Seen with Mesa 25.0.7 (Debian 12 backports, mesa-vulkan-drivers 25.0.7-2~bpo12+1), glslang 12.0.0: for x = 1 and
# y = 2^-24 a compute shader gets 5.9604645e-08 (y itself); in float32 the sum rounds to 1, so that the difference is 0,
# which is what the same line with `precise` gives.
# Why it matters: TwoSum, Kahan's sum and everything else that measures its own rounding error sees none. Vulkan permits
# the rewriting, but most drivers only contract to fma; a result compared with a CPU's then differs by the very error
# that the code set out to keep.
#
# Installs into a temporary folder. Exits 0 when the behaviour is as above, 1 when it has changed, 2 when it cannot run.
set -euo pipefail

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir -p "$work/archives/partial" "$work/root"
packages=(mesa-vulkan-drivers=25.0.7-2~bpo12+1 libvulkan1=1.3.239.0-1 libvulkan-dev=1.3.239.0-1 glslang-tools=12.0.0-2)
if ! command -v cc >/dev/null || ! apt-get -qq --download-only --reinstall --no-install-recommends --allow-downgrades -y \
    -o Dir::Cache::archives="$work/archives" -o Debug::NoLocking=1 install "${packages[@]}" >"$work/apt.log" 2>&1; then
    echo "needs cc, and these packages: ${packages[*]}" >&2
    cat "$work/apt.log" >&2
    exit 2
fi
for package in "$work"/archives/*.deb; do dpkg -x "$package" "$work/root"; done
libraries=$work/root/usr/lib/$(cc -print-multiarch)
printf '{"file_format_version": "1.0.0", "ICD": {"api_version": "1.3.0", "library_path": "%s"}}\n' \
    "$libraries/libvulkan_lvp.so" >"$work/icd.json"

cat >"$work/sum.comp" <<'GLSL'
#version 450
layout(local_size_x = 1) in;
layout(std430, binding = 0) buffer Numbers { float x, y, plain, kept; };
void main() {
    plain = (x + y) - x;
    precise float difference = (x + y) - x;
    kept = difference;
}
GLSL
"$work/root/usr/bin/glslangValidator" -V "$work/sum.comp" -o "$work/sum.spv" >/dev/null

cat >"$work/run.c" <<'C'
#include <stdio.h>
#include <stdlib.h>
#include <vulkan/vulkan.h>
#define CHECK(call) do { if ((call) != VK_SUCCESS) { fprintf(stderr, "%s failed\n", #call); exit(2); } } while (0)
int main(int argc, char** argv) {
    static unsigned code[65536];
    FILE* file = fopen(argv[argc - 1], "rb");
    size_t size = file ? fread(code, 1, sizeof code, file) : 0;
    VkApplicationInfo app = {VK_STRUCTURE_TYPE_APPLICATION_INFO, .apiVersion = VK_API_VERSION_1_1};
    VkInstance instance;
    CHECK(vkCreateInstance(&(VkInstanceCreateInfo){VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO, .pApplicationInfo = &app}, 0, &instance));
    uint32_t one = 1;
    VkPhysicalDevice gpu;
    CHECK(vkEnumeratePhysicalDevices(instance, &one, &gpu));
    VkPhysicalDeviceProperties properties;
    vkGetPhysicalDeviceProperties(gpu, &properties);
    float priority = 1;
    VkDeviceQueueCreateInfo queueInfo = {VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO, .queueCount = 1, .pQueuePriorities = &priority};
    VkDevice device;
    CHECK(vkCreateDevice(gpu, &(VkDeviceCreateInfo){VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO, .queueCreateInfoCount = 1, .pQueueCreateInfos = &queueInfo}, 0, &device));
    VkQueue queue;
    vkGetDeviceQueue(device, 0, 0, &queue);
    VkBuffer buffer;
    CHECK(vkCreateBuffer(device, &(VkBufferCreateInfo){VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO, .size = 16, .usage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT}, 0, &buffer));
    VkMemoryRequirements need;
    vkGetBufferMemoryRequirements(device, buffer, &need);
    VkDeviceMemory memory; /* lavapipe's only type of memory is host-visible */
    CHECK(vkAllocateMemory(device, &(VkMemoryAllocateInfo){VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO, .allocationSize = need.size}, 0, &memory));
    CHECK(vkBindBufferMemory(device, buffer, memory, 0));
    float* numbers;
    CHECK(vkMapMemory(device, memory, 0, VK_WHOLE_SIZE, 0, (void**)&numbers));
    numbers[0] = 1;
    numbers[1] = 0x1p-24f;
    VkDescriptorSetLayoutBinding binding = {0, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, 1, VK_SHADER_STAGE_COMPUTE_BIT, 0};
    VkDescriptorSetLayout setLayout;
    CHECK(vkCreateDescriptorSetLayout(device, &(VkDescriptorSetLayoutCreateInfo){VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO, .bindingCount = 1, .pBindings = &binding}, 0, &setLayout));
    VkPipelineLayout layout;
    CHECK(vkCreatePipelineLayout(device, &(VkPipelineLayoutCreateInfo){VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO, .setLayoutCount = 1, .pSetLayouts = &setLayout}, 0, &layout));
    VkShaderModule module;
    CHECK(vkCreateShaderModule(device, &(VkShaderModuleCreateInfo){VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO, .codeSize = size, .pCode = code}, 0, &module));
    VkComputePipelineCreateInfo pipelineInfo = {VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO, .layout = layout,
        .stage = {VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO, .stage = VK_SHADER_STAGE_COMPUTE_BIT, .module = module, .pName = "main"}};
    VkPipeline pipeline;
    CHECK(vkCreateComputePipelines(device, 0, 1, &pipelineInfo, 0, &pipeline));
    VkDescriptorPoolSize poolSize = {VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, 1};
    VkDescriptorPool pool;
    CHECK(vkCreateDescriptorPool(device, &(VkDescriptorPoolCreateInfo){VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO, .maxSets = 1, .poolSizeCount = 1, .pPoolSizes = &poolSize}, 0, &pool));
    VkDescriptorSet set;
    CHECK(vkAllocateDescriptorSets(device, &(VkDescriptorSetAllocateInfo){VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO, .descriptorPool = pool, .descriptorSetCount = 1, .pSetLayouts = &setLayout}, &set));
    VkDescriptorBufferInfo whole = {buffer, 0, VK_WHOLE_SIZE};
    vkUpdateDescriptorSets(device, 1, &(VkWriteDescriptorSet){VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET, .dstSet = set, .descriptorCount = 1, .descriptorType = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, .pBufferInfo = &whole}, 0, 0);
    VkCommandPool commands;
    CHECK(vkCreateCommandPool(device, &(VkCommandPoolCreateInfo){VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO}, 0, &commands));
    VkCommandBuffer list;
    CHECK(vkAllocateCommandBuffers(device, &(VkCommandBufferAllocateInfo){VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO, .commandPool = commands, .commandBufferCount = 1}, &list));
    CHECK(vkBeginCommandBuffer(list, &(VkCommandBufferBeginInfo){VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO}));
    vkCmdBindPipeline(list, VK_PIPELINE_BIND_POINT_COMPUTE, pipeline);
    vkCmdBindDescriptorSets(list, VK_PIPELINE_BIND_POINT_COMPUTE, layout, 0, 1, &set, 0, 0);
    vkCmdDispatch(list, 1, 1, 1);
    CHECK(vkEndCommandBuffer(list));
    CHECK(vkQueueSubmit(queue, 1, &(VkSubmitInfo){VK_STRUCTURE_TYPE_SUBMIT_INFO, .commandBufferCount = 1, .pCommandBuffers = &list}, 0));
    CHECK(vkQueueWaitIdle(queue));
    printf("%s\n(x + y) - x = %.8g, precise %.8g\n", properties.deviceName, numbers[2], numbers[3]);
    return numbers[2] == 0x1p-24f && numbers[3] == 0 ? 0 : 1;
}
C
cc -O1 -I "$work/root/usr/include" "$work/run.c" -o "$work/run" -L "$libraries" -lvulkan
LD_LIBRARY_PATH=$libraries VK_DRIVER_FILES=$work/icd.json MESA_SHADER_CACHE_DISABLE=true "$work/run" "$work/sum.spv"
