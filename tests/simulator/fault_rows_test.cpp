// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "simulator/scenario/fault_kinds.hpp"

#include "simulator/scenario/reader.hpp"
#include "tests/integration/scenario_run.hpp"
#include "verification/trace/ids/simulator.hpp"
#include "verification/trace/verifies.hpp"

#include <set>
#include <string>

namespace counterpoint::simulator
{
namespace
{
/// Keys that only some values of others leave an effect.
const std::set<std::string> kConditional{"confirmation.by",     "confirmation.bits", "bit_flip.srdo",
                                         "link_insertion.back", "insertion.every",   "masquerade.every",
                                         "link_insertion.every"};

/// A scenario with a fault of this kind: the keys that it needs, and one more, each with the example of its row.
std::string TextWith(const SectionSpec& kind, const KeySpec& more)
{
    const bool is_link = std::string(kind.name).find("link_") == 0U;
    std::string text =
        "duration: 1 s\nnodes:\n  sensor: {dcf: a.dcf}\n  controller: {dcf: a.dcf}\n  actuator: {dcf: a.dcf" +
        std::string(is_link ? ", structure: two_cpu" : "") + "}\nfaults:\n  - {fault: " + kind.name;
    for (const KeySpec* const key : KeysOf(kind))
    {
        const bool is_there = key->fallback == kNeeded || key == &more;
        text +=
            (is_there && key->key != std::string("fault")) ? ", " + std::string(key->key) + ": " + key->example : "";
    }
    return text + "}\n";
}

std::string Answer(const std::string& text)
{
    try
    {
        static_cast<void>(ReadScenario(TextFile(text)));
        return "";
    }
    catch (const YamlError& error)
    {
        return error.what();
    }
}

TEST(FaultKinds, EachHasItsKeysReadAndItsPlaceInTheDocument)
{
    Verifies(req::SRS_SIM_047);
    const std::string document = runtime::ReadYamlText(std::string(COUNTERPOINT_SOURCE_FOLDER) + "/docs/scenario.md");
    const std::size_t begin = document.find("| group | kinds |");
    const std::string groups = document.substr(begin, document.find("\n\n", begin) - begin);
    std::size_t kinds = 0U;
    for (const FaultSection& row : kFaultSections)
    {
        if (!row.kind)
        {
            continue;
        }
        // Then the row of a number is that kind's, and the document has it in a group
        ++kinds;
        EXPECT_EQ(&RowOf(*row.kind), &row);
        EXPECT_NE(groups.find("`" + std::string(row.name) + "`"), std::string::npos) << row.name;
        // And no key is without a reader
        for (const KeySpec* const key : KeysOf(SectionNamed(row.name)))
        {
            const std::string text = TextWith(SectionNamed(row.name), *key);
            const bool is_conditional = kConditional.count(row.name + std::string(".") + key->key) != 0U;
            EXPECT_EQ(Answer(text).find("without an effect in this") != std::string::npos, is_conditional) << text;
        }
    }
    EXPECT_EQ(kinds, 40U);
}

TEST(FaultKinds, EachThatLastsComesAndGoes)
{
    Verifies(req::SRS_SIM_028);
    std::size_t lasting = 0U;
    std::size_t of_frames = 0U;
    for (const FaultSection& row : kFaultSections)
    {
        std::set<std::string> keys;
        for (const KeySpec* const key : KeysOf(SectionNamed(row.name)))
        {
            keys.insert(key->key);
        }
        const std::size_t pattern = keys.count("on") + keys.count("off");
        if (row.kind && keys.count("until") != 0U)
        {
            ++lasting;
            EXPECT_EQ(pattern, 2U) << row.name;
        }
        else if (row.kind)
        {
            // What does not last, and frames, which are chosen by a map of their own
            EXPECT_EQ(pattern, 0U) << row.name;
            of_frames += keys.count("frames");
        }
    }
    EXPECT_EQ(lasting, 20U);
    EXPECT_EQ(of_frames, 12U);
    std::set<std::string> chosen;
    for (const KeySpec* const key : KeysOf(SectionNamed("frames")))
    {
        chosen.insert(key->key);
    }
    EXPECT_EQ(chosen.count("until") + chosen.count("on") + chosen.count("off"), 3U);
}
} // namespace
} // namespace counterpoint::simulator
