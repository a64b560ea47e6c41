// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// Which channel stands in the next cycle, by what both say of their refreshes in this one: told step by step by
// channels that say what the test has them say.
#include "tests/safety_core/kernel/rig.hpp"
#include "verification/trace/ids/kernel.hpp"

#include <array>
#include <cstddef>
#include <initializer_list>

namespace counterpoint
{
namespace
{

constexpr std::uint32_t kMissedSignal = 1U << static_cast<std::uint32_t>(SrdoCause::kRefreshMissed);

/// What a channel says of the refresh of a producer.
enum class Says : std::uint8_t
{
    kNothing = 0U,
    kWaits = 1U,        ///< It waits.
    kWaitsMissed = 2U,  ///< It waits, and the next one is told as missed.
    kMissed = 3U,       ///< One is told as missed, and none waits.
    kWaitsUnnoted = 4U, ///< It waits; a missed one is in the view of the SRDO, but no cause is told.
};

/// Who stands in the next cycle.
enum class Stands : std::uint8_t
{
    kNobody = 0U,
    kFirst = 1U,
    kOther = 2U,
};

struct Step
{
    Says first;
    Says other;
    Stands then;
};

class Standing : public Rig
{
  protected:
    static void LetSay(Tap& channel, const SrdoMask slots, const Says says)
    {
        const bool waits = (says != Says::kNothing) && (says != Says::kMissed);
        const bool is_told = (says == Says::kWaitsMissed) || (says == Says::kMissed);
        const bool is_missed = is_told || (says == Says::kWaitsUnnoted);
        channel.more_signals = is_missed ? kMissedSignal : 0U;
        channel.on_outcome = [slots, waits, is_told](CycleOutcome& outcome)
        {
            outcome.refresh = waits ? slots : 0U;
            outcome.signalled = is_told ? slots : 0U;
        };
    }
    /// Both channels say each step's words, each once as the first and once as the other one.
    void Play(const SrdoMask slots, const std::initializer_list<Step> steps)
    {
        for (const bool is_a : {true, false})
        {
            Operate();
            Tap& first = is_a ? a : b;
            Tap& other = is_a ? b : a;
            std::size_t number = 0U;
            for (const Step& step : steps)
            {
                LetSay(first, slots, step.first);
                LetSay(other, slots, step.other);
                Cycle();
                LetSay(first, slots, Says::kNothing);
                LetSay(other, slots, Says::kNothing);
                if (++number == steps.size())
                {
                    Cycle();
                    EXPECT_EQ(first.last_input.stand, (step.then == Stands::kFirst) ? slots : 0U) << is_a;
                    EXPECT_EQ(other.last_input.stand, (step.then == Stands::kOther) ? slots : 0U) << is_a;
                }
            }
            first.on_outcome = nullptr;
            other.on_outcome = nullptr;
            EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kNone) << is_a;
        }
    }
};

TEST_F(Standing, WhoAloneWaitsStandsForOneCycle)
{
    Verifies(req::SRS_KRN_017);
    // Of each slot, the first one among them
    for (const SrdoMask slots : std::initializer_list<SrdoMask>{1U, 2U, 4U, 7U})
    {
        // When it alone waits, then it stands
        Play(slots, {{Says::kWaits, Says::kNothing, Stands::kFirst}});
        // until nobody waits, both do, or the other one alone does.
        Play(slots,
             {{Says::kWaits, Says::kNothing, Stands::kFirst}, {Says::kNothing, Says::kNothing, Stands::kNobody}});
        Play(slots, {{Says::kWaits, Says::kNothing, Stands::kFirst}, {Says::kWaits, Says::kWaits, Stands::kNobody}});
        Play(slots, {{Says::kWaits, Says::kNothing, Stands::kFirst}, {Says::kNothing, Says::kWaits, Stands::kOther}});
    }
}

TEST_F(Standing, WhoAloneMissedOneStandsUntilTheOtherOneAloneMissesIt)
{
    Verifies(req::SRS_KRN_017);
    Verifies(req::SRS_KRN_148);
    for (const SrdoMask slots : std::initializer_list<SrdoMask>{1U, 2U, 4U, 7U})
    {
        const Step begins{Says::kWaitsMissed, Says::kWaits, Stands::kFirst};
        // Given one that waits in both and was missed in one alone, then that one stands
        Play(slots, {begins});
        Play(slots, {begins, {Says::kWaits, Says::kWaits, Stands::kFirst}});
        // also when it alone misses another one, or both do in one cycle,
        Play(slots, {begins, {Says::kWaitsMissed, Says::kWaits, Stands::kFirst}});
        Play(slots, {begins, {Says::kWaitsMissed, Says::kWaitsMissed, Stands::kFirst}});
        // until the other one alone missed it: they are even, and the next one begins anew.
        Play(slots, {begins, {Says::kWaits, Says::kWaitsMissed, Stands::kNobody}});
        Play(slots, {begins,
                     {Says::kWaits, Says::kWaitsMissed, Stands::kNobody},
                     {Says::kWaits, Says::kWaitsMissed, Stands::kOther}});
        // It is over as well when the refresh waits no longer.
        Play(slots, {begins, {Says::kNothing, Says::kNothing, Stands::kNobody}});
        Play(slots,
             {begins, {Says::kWaits, Says::kNothing, Stands::kFirst}, {Says::kWaits, Says::kWaits, Stands::kNobody}});
    }
}

TEST_F(Standing, MissedOneBesideOneThatWaitsInOneChannelAloneIsNotAhead)
{
    Verifies(req::SRS_KRN_148);
    for (const SrdoMask slots : std::initializer_list<SrdoMask>{1U, 2U, 4U, 7U})
    {
        // Given a refresh that waits in one channel alone, which missed one: it stands for this cycle only
        Play(slots,
             {{Says::kWaitsMissed, Says::kNothing, Stands::kFirst}, {Says::kWaits, Says::kWaits, Stands::kNobody}});
        Play(slots, {{Says::kWaits, Says::kMissed, Stands::kFirst}, {Says::kWaits, Says::kWaits, Stands::kNobody}});
        // Given one that stood since it alone waited, then the other one can be ahead, and it itself
        Play(slots,
             {{Says::kNothing, Says::kWaits, Stands::kOther}, {Says::kWaitsMissed, Says::kWaits, Stands::kFirst}});
        Play(slots,
             {{Says::kWaits, Says::kNothing, Stands::kFirst}, {Says::kWaitsMissed, Says::kWaits, Stands::kFirst}});
    }
}

// The channel's view of an SRDO is asked where its outcome tells a cause.
TEST_F(Standing, CauseThatIsNotToldIsNone)
{
    Verifies(req::SRS_KRN_148);
    Play(2U, {{Says::kWaitsUnnoted, Says::kWaits, Stands::kNobody}});
}

} // namespace
} // namespace counterpoint
