#include "scene/model/integrators.h"

#include "base/error.h"
#include "base/spelling.h"

#include <algorithm>
#include <string>

namespace hyalite {

const IntegratorRow& integratorNamed(std::string_view name) {
    const auto found = std::ranges::find(kIntegrators, name, &IntegratorRow::name);
    if (found == kIntegrators.end()) {
        throw Error(ExitCode::WrongUsage, "unknown integrator '" + std::string(name) + "'",
                    spellingHint(std::string(name),
                                 std::vector<std::string>(kIntegratorNames.begin(), kIntegratorNames.end())));
    }
    return *found;
}

std::vector<std::string> readersOf(std::string_view setting) {
    std::vector<std::string> readers;
    for (const IntegratorRow& row : kIntegrators) {
        if (row.reads(setting)) {
            readers.emplace_back(row.name);
        }
    }
    return readers;
}

const IntegratorRow* soleReader(std::string_view setting) {
    const IntegratorRow* reader = nullptr;
    for (const IntegratorRow& row : kIntegrators) {
        if (row.reads(setting)) {
            if (reader != nullptr) {
                return nullptr;
            }
            reader = &row;
        }
    }
    return reader;
}

} // namespace hyalite
