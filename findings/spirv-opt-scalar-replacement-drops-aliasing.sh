#!/usr/bin/env bash
# spirv-opt's pass --scalar-replacement makes a valid module invalid where a local struct holds a buffer reference.
#
# Seen with spirv-tools 2023.1 and glslang 12.0.0 (Debian 12): a struct with a member of a buffer_reference type is copied
# into a local variable. glslang decorates that variable AliasedPointer, as SPV_KHR_physical_storage_buffer asks. The pass
# splits it into one variable per member and gives none of them the decoration, so that spirv-val of the same version
# refuses the result: "expected AliasedPointer or RestrictPointer for PhysicalStorageBuffer pointer". With --ssa-rewrite
# and --eliminate-dead-code-aggressive behind it the variables are gone and the module is valid again.
# Why it matters: a recipe of passes that is right for every other kernel fails, under the validation layers, for those
# that pass structs with buffer references around; the pass must not be the last one that touches them.
#
# Installs into a temporary folder. Exits 0 when the behaviour is as above, 1 when it has changed, 2 when it cannot run.
set -euo pipefail

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir -p "$work/archives/partial" "$work/root"
packages=(spirv-tools=2023.1-2 glslang-tools=12.0.0-2)
if ! apt-get -qq --download-only --reinstall --no-install-recommends --allow-downgrades -y \
    -o Dir::Cache::archives="$work/archives" -o Debug::NoLocking=1 install "${packages[@]}" >"$work/apt.log" 2>&1; then
    echo "needs these packages: ${packages[*]}" >&2
    cat "$work/apt.log" >&2
    exit 2
fi
for package in "$work"/archives/*.deb; do dpkg -x "$package" "$work/root"; done
bin=$work/root/usr/bin

cat >"$work/records.comp" <<'GLSL'
#version 460
#extension GL_EXT_buffer_reference : require
#extension GL_EXT_scalar_block_layout : require
layout(buffer_reference, scalar) buffer Counts { uint at[]; };
struct Record { float weight; Counts counts; uint count; };
layout(buffer_reference, scalar) buffer Records { Record at[]; };
layout(push_constant, scalar) uniform Push { Records records; Counts result; uint least; };
uint total(Record record) {
    uint sum = 0u;
    for (uint i = 0u; i < record.count; ++i) {
        sum += record.counts.at[i] + uint(record.weight);
    }
    return sum;
}
void main() {
    Record record = records.at[gl_GlobalInvocationID.x];
    if (record.count < least) {
        record.weight = 2.0;
    }
    result.at[gl_GlobalInvocationID.x] = total(record);
}
GLSL

valid() {
    "$bin/spirv-val" --target-env vulkan1.3 --scalar-block-layout "$1" 2>"$work/why"
}
"$bin/glslangValidator" --target-env vulkan1.3 -V "$work/records.comp" -o "$work/plain.spv" >/dev/null
valid "$work/plain.spv" || { echo "changed: glslang's module is not valid: $(<"$work/why")"; exit 1; }
passes=(--inline-entry-points-exhaustive --eliminate-dead-functions --scalar-replacement=100)
"$bin/spirv-opt" --target-env=vulkan1.3 "${passes[@]}" "$work/plain.spv" -o "$work/split.spv"
if valid "$work/split.spv"; then
    echo "changed: the split module is valid"
    exit 1
fi
grep -q "expected AliasedPointer or RestrictPointer" "$work/why" || { echo "changed: $(<"$work/why")"; exit 1; }
head -1 "$work/why"
"$bin/spirv-opt" --target-env=vulkan1.3 "${passes[@]}" --ssa-rewrite --eliminate-dead-code-aggressive \
    "$work/plain.spv" -o "$work/rewritten.spv"
valid "$work/rewritten.spv" || { echo "changed: still invalid after --ssa-rewrite: $(<"$work/why")"; exit 1; }
echo "as described: invalid after --scalar-replacement, valid again after --ssa-rewrite"
