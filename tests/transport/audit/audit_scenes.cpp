// Audits random scenes: audit_scenes KIND BACKEND FIRST COUNT FOLDER, with KIND energy or agree and BACKEND reference
// or vulkan. Prints what was found and writes the smallest scenes that fail into the folder; fails if there are any.
#include "scene/model/integrators.h"
#include "transport/audit/audit.h"

#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>

namespace {

using namespace hyalite;
using namespace hyalite::testing;

constexpr double kFalseAlarms = 1e-3; // of a whole run of a correct program

struct Tally {
    std::size_t scenes = 0;
    std::size_t failures = 0;
    double sum = 0;     // of ratios
    double highest = 0; // of accepted ratios
    double noise = 0;   // sum of standard errors

    void add(const Judgement& judgement) {
        ++scenes;
        failures += judgement.exceeds ? 1 : 0;
        sum += judgement.ratio.mean;
        noise += judgement.ratio.standardError;
        highest = std::max(highest, judgement.exceeds ? 0 : judgement.ratio.mean);
    }
};

struct Run {
    bool agree = false;
    Backend backend = Backend::Reference;
    std::uint64_t first = 0;
    std::uint64_t count = 0;
    std::filesystem::path folder;
    double level = 0;
    std::map<std::string, Tally> tallies;
};

void keep(const Run& run, const Draft& draft, const std::string& name, const Judgement& judgement) {
    const std::string file = name + '-' + std::to_string(draft.number) + ".yaml";
    std::ofstream out(run.folder / file);
    out << "# " << name << ", scene " << draft.number << ": ratio " << judgement.ratio.mean << " +- "
        << judgement.ratio.standardError << " by " << judgement.renders << " renders\nhyalite: 1\n"
        << draft.scene(0);
    for (const auto& [mesh, bytes] : draftFiles()) {
        std::ofstream(run.folder / mesh) << bytes;
    }
    std::cout << "FAILED " << file << ": " << judgement.ratio.mean << " +- " << judgement.ratio.standardError
              << std::endl;
}

void auditBalance(Run& run, std::uint64_t number) {
    const Draft draft = draftScene(number, auditOf(number));
    constexpr std::array kNames{"lit", "furnace", "nested", "sealed", "compare"}; // in the order of Audit
    const char* kind = kNames.at(static_cast<std::size_t>(draft.audit));
    for (const Renderer& renderer : everyRenderer()) {
        if (renderer.backend != run.backend) {
            continue;
        }
        const std::string name = std::string(kind) + '-' + std::string(renderer.integrator);
        const Judgement judgement = judgeBalance(draft, renderer, run.level);
        run.tallies[name].add(judgement);
        if (judgement.exceeds) {
            constexpr double kSure = 1e-4;
            const Draft small = minimised(
                draft, [&](const Draft& candidate) { return judgeBalance(candidate, renderer, kSure).exceeds; });
            keep(run, small, name, judgeBalance(small, renderer, kSure));
        }
    }
}

void auditAgreement(Run& run, std::uint64_t number) {
    const Draft draft = draftScene(number, Audit::Compare);
    const Judgement judgement = judgeAgreement(draft, run.backend, run.level);
    run.tallies["agree"].add(judgement);
    if (judgement.exceeds) {
        constexpr double kSure = 1e-4;
        const Draft small = minimised(
            draft, [&](const Draft& candidate) { return judgeAgreement(candidate, run.backend, kSure).exceeds; });
        keep(run, small, "agree", judgeAgreement(small, run.backend, kSure));
    }
}

int audit(Run& run) {
    run.level = sidak(kFalseAlarms, run.count * (run.agree ? 1 : kIntegratorNames.size()));
    std::filesystem::create_directories(run.folder);
    for (std::uint64_t number = run.first; number < run.first + run.count; ++number) {
        if (run.agree) {
            auditAgreement(run, number);
        } else {
            auditBalance(run, number);
        }
        if ((number - run.first + 1) % 100 == 0) {
            std::cout << number - run.first + 1 << " scenes" << std::endl;
        }
    }
    std::size_t failures = 0;
    for (const auto& [name, tally] : run.tallies) {
        std::cout << name << ": " << tally.scenes << " scenes, " << tally.failures << " fail; mean ratio "
                  << tally.sum / static_cast<double>(tally.scenes) << ", highest accepted " << tally.highest
                  << ", mean standard error " << tally.noise / static_cast<double>(tally.scenes) << '\n';
        failures += tally.failures;
    }
    return failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}

} // namespace

int main(int count, char** words) {
    if (count != 6) {
        std::cerr << "usage: audit_scenes energy|agree reference|vulkan FIRST COUNT FOLDER\n";
        return EXIT_FAILURE;
    }
    try {
        Run run{.agree = std::string(words[1]) == "agree",
                .backend = std::string(words[2]) == "vulkan" ? Backend::Vulkan : Backend::Reference,
                .first = std::stoull(words[3]),
                .count = std::stoull(words[4]),
                .folder = words[5],
                .tallies = {}};
        return audit(run);
    } catch (const std::exception& error) {
        std::cerr << error.what() << '\n';
        return EXIT_FAILURE;
    }
}
