// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef TESTS_INTEGRATION_SCENARIO_RUN_HPP
#define TESTS_INTEGRATION_SCENARIO_RUN_HPP

#include "simulator/judge/run.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <memory>
#include <optional>
#include <sstream>
#include <string>

namespace counterpoint::simulator
{
/// The tree's emergency-stop folder.
inline std::string Examples()
{
    return std::string(COUNTERPOINT_SOURCE_FOLDER) + "/examples/emergency_stop/";
}

/// Scenarios of the tests alone.
inline std::string Scenarios()
{
    return std::string(COUNTERPOINT_SOURCE_FOLDER) + "/tests/simulator/scenarios/";
}

/// A file of this test with the given content; files that differ in their ending are several.
inline std::string TextFile(const std::string& text, const std::string& ending = ".yaml")
{
    const ::testing::TestInfo* const test = ::testing::UnitTest::GetInstance()->current_test_info();
    std::string name = std::string(test->test_suite_name()) + "_" + test->name();
    for (char& character : name)
    {
        character = (character == '/') ? '_' : character;
    }
    std::string file = ::testing::TempDir() + "counterpoint_" + name + ending;
    std::ofstream(file, std::ios::binary) << text;
    return file;
}

/// A scenario on the emergency-stop chain; `text` is what it adds.
inline std::unique_ptr<Run> RunChain(const std::string& text, const bool keeps_all = false)
{
    auto run = std::make_unique<Run>(TextFile("extends: " + Examples() + "chain.yaml\n" + text), std::nullopt,
                                     std::nullopt, keeps_all);
    run->Simulate(nullptr);
    return run;
}

/// The same of devices without self tests, of which some faults are found by nobody.
inline std::unique_ptr<Run> RunChainWithoutSelfTests(const std::string& text)
{
    std::ostringstream chain;
    chain << std::ifstream(Examples() + "chain.yaml").rdbuf();
    std::string whole = chain.str();
    const std::string key = "{dcf: ";
    for (std::size_t at = whole.find(key); at != std::string::npos; at = whole.find(key, at + key.size()))
    {
        whole.replace(at, key.size(), "{self_tests: false, dcf: " + Examples());
    }
    const std::string file = TextFile("extends: " + TextFile(whole) + "\n" + text, ".extended.yaml");
    auto run = std::make_unique<Run>(file, std::nullopt, std::nullopt, false);
    run->Simulate(nullptr);
    return run;
}

/// Expectations that did not come, one a line; empty: all hold.
inline std::string Failures(const Run& run)
{
    std::string text;
    for (const ExpectationVerdict& verdict : run.Verdicts())
    {
        text += verdict.holds ? "" : verdict.wanted + ": " + verdict.seen + "\n";
    }
    return run.Verdicts().empty() ? "no expectations" : text;
}
} // namespace counterpoint::simulator

#endif // TESTS_INTEGRATION_SCENARIO_RUN_HPP
