// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/third_voice/sequence.hpp"

#include <CLI/CLI.hpp>

#include <cstdint>
#include <iostream>

using namespace counterpoint::third_voice;

int main(const int count, char** const words)
{
    CLI::App app{
        "Compares kernel and channels with a model written from docs/semantics.md alone, over drawn sequences."};
    std::uint64_t sequences = 1000U;
    std::uint64_t seed = 1U;
    std::uint32_t shown = 1U;
    app.add_option("--sequences", sequences, "How many");
    app.add_option("--seed", seed, "Of the first one; the next ones follow");
    app.add_option("--show", shown, "How many differences are told with what came before them");
    bool is_asked = false;
    app.add_flag("--questions", is_asked, "Asks what the README calls open, too: differences are expected there");
    std::uint32_t flaw = 0U;
    app.add_option("--flaw", flaw, "Breaks one rule of the model, by its number in configuration.hpp");
    CLI11_PARSE(app, count, words);
    std::uint64_t differences = 0U;
    std::uint64_t undecided = 0U;
    SequenceResult sum;
    for (std::uint64_t number = 0U; number < sequences; ++number)
    {
        const SequenceResult result =
            RunSequence(seed + number, static_cast<Flaw>(flaw), is_asked ? Questions::kAsked : Questions::kSpared);
        undecided += result.is_undecided ? 1U : 0U;
        sum.steps += result.steps;
        sum.releases += result.releases;
        sum.faults += result.faults;
        sum.refusals += result.refusals;
        if (!result.is_equal)
        {
            ++differences;
            if (differences <= shown)
            {
                std::cout << result.story;
            }
            if (differences <= 50U)
            {
                std::cout << "seed " << seed + number << ": " << result.difference << "\n";
            }
        }
    }
    std::cout << sequences << " sequences, " << sum.steps << " cycles, " << sum.releases << " releases, " << sum.faults
              << " causes, " << sum.refusals << " writes refused, " << undecided
              << " ended at an open question: " << differences << " differences\n";
    return (differences == 0U) ? 0 : 1;
}
