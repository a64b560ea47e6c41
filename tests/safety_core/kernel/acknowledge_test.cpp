// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "tests/safety_core/kernel/rig.hpp"
#include "verification/trace/ids/channel.hpp"
#include "verification/trace/ids/kernel.hpp"

#include <cstdint>
#include <initializer_list>
#include <utility>

namespace counterpoint
{
namespace
{

/// SRDO 1 with a restart interlock; each channel's acknowledge is an input of its own. Cycle 1 ms, window 100 ms, SCT
/// 50 ms, a pair every 10 ms.
class Acknowledging : public Rig
{
  protected:
    Acknowledging()
    {
        setups[0].policy = ReleasePolicy::kInterlock;
    }

    void CycleWith(const bool in_a, const bool in_b)
    {
        now_us += 1000U - (now_us % 1000U);
        kernel.Cycle(CycleCall{InstantPair{{now_us}, {now_us}}, in_a ? 1U : 0U, in_b ? 1U : 0U});
        ++cycles_;
        if ((cycles_ % 10U) == 0U)
        {
            ReceivePair();
        }
    }

    /// Both inputs 0, a pair is held.
    void Prepare()
    {
        Operate();
        ReceivePair();
        for (std::uint32_t cycle = 0U; cycle < 12U; ++cycle)
        {
            CycleWith(false, false);
        }
    }

    /// The inputs of A and B become 1 so many cycles from now, and stay. The cycles until the output is open, at most
    /// 250.
    std::uint32_t CyclesToRelease(const std::uint32_t from_a, const std::uint32_t from_b)
    {
        for (std::uint32_t cycle = 0U; cycle < 250U; ++cycle)
        {
            CycleWith(cycle >= from_a, cycle >= from_b);
            EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kNone);
            if (Open() == 1U)
            {
                return cycle;
            }
            EXPECT_NE(kernel.GetState(CommunicationIndex{0x1301U}).state, SrdoState::kReleased) << cycle;
        }
        return 250U;
    }

    void Fault()
    {
        Receive(0x101U, {0x12U}, 100U);
        CycleWith(false, false);
        ASSERT_EQ(CausesOf(0x1301U).size(), 1U);
        application.errors.clear();
        for (std::uint32_t cycle = 0U; cycle < 12U; ++cycle)
        {
            CycleWith(false, false);
        }
    }

  private:
    std::uint32_t cycles_{0U};
};

// t      k            k + skew
// A      released     released
// B      waiting      released: open
TEST_F(Acknowledging, EdgesAnywhereInTheWindowReleaseBeforeTheFirstRelease)
{
    Verifies(req::SRS_CMP_008);
    Verifies(req::SRS_CMP_341);
    for (const std::uint32_t skew : std::initializer_list<std::uint32_t>{0U, 1U, 2U, 7U, 99U, 100U})
    {
        Prepare();
        EXPECT_EQ(CyclesToRelease(0U, skew), skew + 1U) << "skew " << skew;
        Prepare();
        EXPECT_EQ(CyclesToRelease(skew, 0U), skew + 1U) << "skew " << skew;
        EXPECT_EQ(kernel.DemotionCount(), 0U);
    }
}

TEST_F(Acknowledging, EdgesAnywhereInTheWindowReleaseBehindAFault)
{
    Verifies(req::SRS_CMP_008);
    Verifies(req::SRS_CMP_341);
    for (const std::uint32_t skew : std::initializer_list<std::uint32_t>{0U, 1U, 2U, 7U, 99U, 100U})
    {
        for (const bool is_a_first : {true, false})
        {
            Prepare();
            ASSERT_EQ(CyclesToRelease(0U, 0U), 1U);
            Fault();
            application.events.clear();
            EXPECT_EQ(CyclesToRelease(is_a_first ? 0U : skew, is_a_first ? skew : 0U), skew + 1U) << "skew " << skew;
            EXPECT_EQ(application.events, std::vector<std::uint16_t>{0x1301U});
            EXPECT_EQ(NormalOut(), 0x3412U);
            EXPECT_EQ(kernel.DemotionCount(), 0U);
            application.errors.clear();
        }
    }
}

TEST_F(Acknowledging, EdgeBehindTheWindowReleasesNothing)
{
    Verifies(req::SRS_CMP_008);
    // One that comes later than the demotion waits for the other channel's next one: at 110 ms that is over again
    for (const auto& [skew, demotions] :
         std::initializer_list<std::pair<std::uint32_t, std::uint32_t>>{{101U, 1U}, {110U, 2U}, {200U, 1U}})
    {
        Prepare();
        EXPECT_EQ(CyclesToRelease(0U, skew), 250U) << "skew " << skew;
        EXPECT_EQ(kernel.DemotionCount(), demotions) << "skew " << skew;
        // and the next one in both does
        CycleWith(false, false);
        CycleWith(false, false);
        EXPECT_EQ(CyclesToRelease(0U, 0U), 1U);
    }
}

// t [ms]   0 (first edge)   101 (second: too late, both are demoted)   102 (first one again)   150 (second: open)
TEST_F(Acknowledging, EdgeRightBehindADemotionWaitsForTheOtherChannels)
{
    Verifies(req::SRS_CMP_008);
    Verifies(req::SRS_CMP_341);
    for (const bool is_a_first : {true, false})
    {
        Prepare();
        for (std::uint32_t cycle = 0U; cycle < 152U; ++cycle)
        {
            EXPECT_EQ(Open(), 0U) << cycle;
            const bool first = (cycle < 50U) || (cycle >= 102U);
            const bool second = (cycle == 101U) || (cycle == 102U) || (cycle >= 150U);
            CycleWith(is_a_first ? first : second, is_a_first ? second : first);
            EXPECT_EQ(kernel.DemotionCount(), (cycle < 102U) ? 0U : 1U) << cycle;
            if (cycle == 102U)
            {
                ReceivePair(); // A demoted channel holds none.
            }
        }
        EXPECT_EQ(Open(), 1U);
    }
}

// A fault that both channels see while one waits for the other's edge takes the release of the first one away.
TEST_F(Acknowledging, FaultBetweenTheEdgesTakesTheFirstOneBack)
{
    Verifies(req::SRS_CMP_003);
    Prepare();
    for (std::uint32_t cycle = 0U; cycle < 5U; ++cycle)
    {
        CycleWith(true, false);
    }
    Receive(0x101U, {0x12U}, 100U);
    CycleWith(true, false);
    for (std::uint32_t cycle = 0U; cycle < 80U; ++cycle)
    {
        CycleWith(true, true);
        EXPECT_EQ(Open(), 0U);
    }
}

} // namespace
} // namespace counterpoint
