// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "safety_core/selftest/permit_test.hpp"

#include "hal/api/output_gate.hpp"
#include "tests/safety_core/selftest/support.hpp"
#include "verification/trace/ids/selftest.hpp"
#include "verification/trace/verifies.hpp"

#include <cstdint>
#include <functional>
#include <vector>

namespace counterpoint::selftest
{
namespace
{

/// Keeps what it is shown; answers as the real gate does unless the test says otherwise.
class ShownOutput final : public hal::SafetyOutput
{
  public:
    std::uint32_t Challenge() noexcept override
    {
        return 1U;
    }
    void Drive(const hal::PermitSet& /*permits*/) noexcept override
    {
        ++drives;
    }
    [[nodiscard]] hal::ProbeAnswer Probe(const hal::PermitSet& permits,
                                         const std::uint32_t challenge) const noexcept override
    {
        sets.push_back(permits);
        challenges.push_back(challenge);
        return answer(permits, challenge);
    }

    mutable std::vector<hal::PermitSet> sets{};
    mutable std::vector<std::uint32_t> challenges{};
    std::uint32_t drives{0U};
    std::function<hal::ProbeAnswer(const hal::PermitSet&, std::uint32_t)> answer{&hal::OutputGate::Probe};
};

std::vector<SliceResult> Pass(PermitTest& test, const ShownOutput& output)
{
    std::vector<SliceResult> results;
    for (std::uint32_t slice = 0U; slice < PermitTest::kSlicesAPass; ++slice)
    {
        results.push_back(test.Slice(output));
    }
    return results;
}

std::size_t FailuresOf(const std::function<hal::ProbeAnswer(const hal::PermitSet&, std::uint32_t)>& answer)
{
    ShownOutput output;
    output.answer = answer;
    PermitTest test;
    test.Restart();
    std::size_t failures = 0U;
    for (const SliceResult result : Pass(test, output))
    {
        failures += (result == SliceResult::kFailed) ? 1U : 0U;
    }
    return failures;
}

TEST(PermitTest, RealGatePassesAndIsNeverDriven)
{
    Verifies(req::SRS_STS_030);
    ShownOutput output;
    PermitTest test;
    test.Restart();
    for (std::uint32_t pass = 0U; pass < 3U; ++pass)
    {
        const std::vector<SliceResult> results = Pass(test, output);
        for (std::size_t slice = 0U; slice < 9U; ++slice)
        {
            EXPECT_EQ(results[slice], SliceResult::kContinues) << slice;
        }
        EXPECT_EQ(results[9], SliceResult::kPassed);
    }
    EXPECT_EQ(test.Done(), 30U);
    EXPECT_EQ(output.drives, 0U);
    // Then no challenge was ever 0 or odd, none came twice, and no set named a slot
    for (std::size_t shown = 0U; shown < 30U; ++shown)
    {
        EXPECT_EQ(output.challenges[shown] % 4U, 2U);
        EXPECT_EQ(output.sets[shown].a.mask | output.sets[shown].b.mask | output.sets[shown].kernel.mask, 0U);
        EXPECT_TRUE((shown == 0U) || (output.challenges[shown] != output.challenges[shown - 1U]));
    }
}

TEST(PermitTest, OnePermitOfASetIsWrongOldOrMissing)
{
    Verifies(req::SRS_STS_030);
    ShownOutput output;
    PermitTest test;
    test.Restart();
    static_cast<void>(Pass(test, output));
    constexpr std::uint32_t kConstants[3] = {0x9E37'79B1U, 0x85EB'CA77U, 0xC2B2'AE3DU};
    for (std::size_t shown = 0U; shown < 10U; ++shown)
    {
        const std::uint32_t challenge = output.challenges[shown];
        const std::uint32_t before = challenge - 0x7F4A'7C14U;
        EXPECT_TRUE((shown == 0U) || (output.challenges[shown - 1U] == before)) << shown;
        const Permit permits[3] = {output.sets[shown].a, output.sets[shown].b, output.sets[shown].kernel};
        for (std::size_t party = 0U; party < 3U; ++party)
        {
            const std::uint32_t right = challenge * kConstants[party];
            const std::uint32_t flaws[3] = {right ^ 1U, before * kConstants[party], 0U};
            const bool is_flawed = party == (shown / 3U);
            EXPECT_EQ(permits[party].response, is_flawed ? flaws[shown % 3U] : right) << shown << " " << party;
        }
    }
}

TEST(PermitTest, GateWithADefectFails)
{
    Verifies(req::SRS_STS_030);
    Verifies(req::SRS_STS_031);
    using hal::PermitSet;
    using hal::ProbeAnswer;
    // Given gates that accept everything, refuse everything, cannot be probed, answer nothing
    EXPECT_EQ(FailuresOf([](const PermitSet&, std::uint32_t) { return ProbeAnswer::kAccepted; }), 9U);
    EXPECT_EQ(FailuresOf([](const PermitSet&, std::uint32_t) { return ProbeAnswer::kRefused; }), 1U);
    EXPECT_EQ(FailuresOf([](const PermitSet&, std::uint32_t) { return ProbeAnswer::kAbsent; }), 10U);
    EXPECT_EQ(FailuresOf([](const PermitSet&, std::uint32_t) { return ProbeAnswer::kInvalid; }), 10U);
    // Given gates that do not look at one party
    EXPECT_EQ(FailuresOf(
                  [](PermitSet permits, std::uint32_t challenge)
                  {
                      permits.a.response = challenge * 0x9E37'79B1U;
                      return hal::OutputGate::Probe(permits, challenge);
                  }),
              3U);
    EXPECT_EQ(FailuresOf(
                  [](PermitSet permits, std::uint32_t challenge)
                  {
                      permits.b.response = challenge * 0x85EB'CA77U;
                      return hal::OutputGate::Probe(permits, challenge);
                  }),
              3U);
    EXPECT_EQ(FailuresOf(
                  [](PermitSet permits, std::uint32_t challenge)
                  {
                      permits.kernel.response = challenge * 0xC2B2'AE3DU;
                      return hal::OutputGate::Probe(permits, challenge);
                  }),
              3U);
}

} // namespace
} // namespace counterpoint::selftest
