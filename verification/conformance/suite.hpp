// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_CONFORMANCE_SUITE_HPP
#define VERIFICATION_CONFORMANCE_SUITE_HPP

#include "verification/conformance/runner.hpp"
#include "verification/trace/verifies.hpp"

#include "verification/conformance/cases.hpp"

#include <gtest/gtest.h>

#include <ios>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

/// The conformance cases as GoogleTest tests, one for each case; a channel's tests supply the channel. Host only.
namespace counterpoint::conformance
{

/// Turns each failed expectation into a failure of the running test.
class TestReporter final : public Reporter
{
  public:
    void OnFailure(const Failure& failure) noexcept override
    {
        std::ostringstream text;
        text << failure.case_name << ", step " << failure.step << ", origin " << failure.origin << ": " << failure.field
             << ": expected " << failure.expected << " (0x" << std::hex << failure.expected << std::dec << "), got "
             << failure.got << " (0x" << std::hex << failure.got << ")";
        ADD_FAILURE() << text.str();
    }
};

inline std::vector<const Case*> AllCases()
{
    std::vector<const Case*> cases;
    for (std::uint32_t table = 0U; table < kTableCount; ++table)
    {
        for (std::uint32_t i = 0U; i < kAllTables[table]->count; ++i)
        {
            cases.push_back(&kAllTables[table]->cases[i]);
        }
    }
    return cases;
}

inline std::string CaseName(const ::testing::TestParamInfo<const Case*>& info)
{
    return info.param->name;
}

/// One case at every origin of time against a channel that starts in zero-filled memory. [SRS_CNF_001, SRS_CNF_004]
inline void RunCase(const Case& test, Channel& channel, Party party)
{
    for (const req::RequirementId& requirement : test.requirements)
    {
        if (requirement.text != nullptr)
        {
            Verifies(requirement);
        }
    }
    TestReporter reporter;
    const auto runner = std::make_unique<Runner>(channel, party, reporter);
    for (const std::uint32_t origin : kOrigins)
    {
        runner->Run(test, origin);
    }
}

} // namespace counterpoint::conformance

#endif
