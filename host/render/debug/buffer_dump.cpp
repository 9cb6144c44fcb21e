// See buffer_dump.h. An array of records becomes NumPy's structured type, under the names of shaders/shared.
#include "render/debug/buffer_dump.h"

#include "base/error.h"
#include "base/output_file.h"
#include "gpu/kernel.h"

#include <algorithm>
#include <charconv>
#include <cstring>

namespace hyalite::render {

namespace {

using gpu::StructMember;

// NumPy's name for a GLSL type, and its number of components.
struct NumpyType {
    std::string name;
    int components = 1;

    // The type as an entry of a structured type's description.
    [[nodiscard]] std::string entry(const std::string& field) const {
        const std::string shape = components > 1 ? ", (" + std::to_string(components) + ",)" : "";
        return "('" + field + "', '" + name + '\'' + shape + ')';
    }
};

NumpyType numpyType(const StructMember& member) {
    if (member.isArray) { // a device address
        return {"<u8", 1};
    }
    const std::string& type = member.type;
    const bool isVector = !type.empty() && std::isdigit(static_cast<unsigned char>(type.back())) != 0;
    const int components = isVector ? type.back() - '0' : 1;
    if (type.starts_with('u')) {
        return {"<u4", components};
    }
    return {type.starts_with('i') ? "<i4" : "<f4", components};
}

std::vector<std::byte> npyFile(const std::string& type, const std::string& shape, std::span<const std::byte> data) {
    std::string header = "{'descr': " + type + ", 'fortran_order': False, 'shape': " + shape + ", }";
    constexpr std::size_t kPrefix = 10;
    header.append(63 - (kPrefix + header.size()) % 64, ' ');
    header += '\n';
    std::string start = "\x93NUMPY";
    start += '\1';
    start += '\0';
    start += static_cast<char>(header.size() & 0xffU);
    start += static_cast<char>(header.size() >> 8U);
    start += header;
    const auto bytes = std::as_bytes(std::span(start));
    std::vector<std::byte> file(bytes.begin(), bytes.end());
    file.insert(file.end(), data.begin(), data.end());
    return file;
}

std::string listNames(const std::vector<StructMember>& members, bool arraysAlone) {
    std::string names;
    for (const StructMember& member : members) {
        if (member.isArray || !arraysAlone) {
            names += (names.empty() ? "" : ", ") + member.name;
        }
    }
    return names;
}

const StructMember& findMember(const std::vector<StructMember>& members, const std::string& name,
                               const std::string& owner, bool arraysAlone) {
    const auto found = std::ranges::find(members, name, &StructMember::name);
    if (found == members.end() || (arraysAlone && !found->isArray)) {
        throw Error(ExitCode::WrongUsage,
                    '\'' + owner + "' has no " + (arraysAlone ? "array" : "member") + " '" + name + '\'',
                    "it has " + listNames(members, arraysAlone));
    }
    return *found;
}

// The members of the kernel's push constants.
const std::vector<StructMember>& argumentsOf(const gpu::Kernel& kernel) {
    for (const auto& [name, members] : kernel.interface().structs) {
        if (name.ends_with("Arguments")) {
            return members;
        }
    }
    throw Error(ExitCode::BadInput, "kernel '" + kernel.name() + "' has no arguments");
}

std::string tuple(std::size_t count, int components) {
    return '(' + std::to_string(count) + (components > 1 ? ", " + std::to_string(components) + ')' : ",)");
}

void dump(const gpu::Context& context, const gpu::Dispatch& dispatch, const DumpRequest& request) {
    const gpu::KernelInterface& interface = dispatch.kernel.interface();
    const auto& arguments = argumentsOf(dispatch.kernel);
    // Array names may themselves contain dots, as in map.order
    std::string arrayName = request.field;
    const bool isWhole = std::ranges::find(arguments, arrayName, &StructMember::name) != arguments.end();
    std::string memberName;
    if (const std::size_t dot = arrayName.rfind('.'); !isWhole && dot != std::string::npos) {
        memberName = arrayName.substr(dot + 1);
        arrayName.resize(dot);
    }
    const StructMember& array = findMember(arguments, arrayName, dispatch.kernel.name(), true);
    std::uint64_t address = 0;
    std::memcpy(&address, dispatch.arguments.data() + array.offset, sizeof(address));
    const std::span<const std::byte> memory = context.memoryAt(address);
    const auto record = interface.structs.find(array.type);
    if (record == interface.structs.end()) { // an array of numbers or vectors
        const NumpyType type = numpyType({array.name, 0, 0, array.type, false});
        const std::size_t stride = interface.arrayStrides.at(array.type);
        const std::size_t count = memory.size() / stride;
        if (!memberName.empty()) {
            throw Error(ExitCode::WrongUsage, "'" + arrayName + "' of '" + dispatch.kernel.name() +
                                                  "' is an array of " + array.type + ": its elements have no '" +
                                                  memberName + '\'');
        }
        writeFileAtomically(request.file, npyFile('\'' + type.name + '\'', tuple(count, type.components),
                                                  memory.first(count * stride)));
        return;
    }
    const std::size_t stride = interface.arrayStrides.at(array.type);
    const std::size_t count = memory.size() / stride;
    if (memberName.empty()) {
        std::string type;
        for (const StructMember& member : record->second) {
            type += (type.empty() ? "[" : ", ") + numpyType(member).entry(member.name);
        }
        writeFileAtomically(request.file, npyFile(type + ']', tuple(count, 1), memory.first(count * stride)));
        return;
    }
    const StructMember& member = findMember(record->second, memberName, array.type, false);
    std::vector<std::byte> values;
    values.reserve(count * member.size);
    for (std::size_t i = 0; i < count; ++i) {
        const auto value = memory.subspan(i * stride + member.offset, member.size);
        values.insert(values.end(), value.begin(), value.end());
    }
    const NumpyType type = numpyType(member);
    writeFileAtomically(request.file, npyFile('\'' + type.name + '\'', tuple(count, type.components), values));
}

} // namespace

DumpRequest dumpRequest(const std::string& text) {
    const std::size_t colon = text.find(':');
    if (colon == 0 || colon == std::string::npos || colon + 1 == text.size()) {
        throw Error(ExitCode::WrongUsage, "--dump " + text + " does not name a stage and a field",
                    "write --dump STAGE:FIELD, e.g. trace_closest:hits.t");
    }
    DumpRequest request{.stage = text.substr(0, colon), .field = text.substr(colon + 1), .dispatch = 0, .file = {}};
    std::string name = request.stage + '.';
    if (const std::size_t at = request.field.find('@'); at != std::string::npos) {
        const std::string number = request.field.substr(at + 1);
        request.field.resize(at);
        const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), request.dispatch);
        if (error != std::errc() || end != number.data() + number.size() || request.field.empty()) {
            throw Error(ExitCode::WrongUsage, "--dump " + text + ": '" + number + "' is not a dispatch number",
                        "dispatches count from 0");
        }
        name += request.field + '.' + number;
    } else {
        name += request.field;
    }
    if (text.find('/') != std::string::npos) { // the file must not be in another folder
        throw Error(ExitCode::WrongUsage, "--dump " + text + ": stage and field names do not contain '/'");
    }
    request.file = name + ".npy";
    return request;
}

void BufferDump::after(const gpu::Dispatch& dispatch) {
    const std::string& stage = dispatch.kernel.name();
    const std::uint32_t number = dispatches_[stage]++;
    for (const DumpRequest& request : requests_) {
        if (request.stage == stage && request.dispatch == number) {
            dump(context_, dispatch, request);
        }
    }
}

void BufferDump::checkComplete() const {
    for (const DumpRequest& request : requests_) {
        const auto found = dispatches_.find(request.stage);
        if (found == dispatches_.end()) {
            std::string names;
            for (const auto& [name, count] : dispatches_) {
                names += (names.empty() ? "" : ", ") + name;
            }
            throw Error(ExitCode::WrongUsage, "no kernel named '" + request.stage + "' runs in this render",
                        "kernels that do: " + names);
        }
        if (request.dispatch >= found->second) {
            throw Error(ExitCode::WrongUsage, '\'' + request.stage + "' is dispatched " +
                                                  std::to_string(found->second) + " times, and there is no dispatch " +
                                                  std::to_string(request.dispatch));
        }
    }
}

} // namespace hyalite::render
