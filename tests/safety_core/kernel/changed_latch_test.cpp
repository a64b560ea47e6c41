// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// A bit of the latch of the device safe state that is wrong for a while.
#include "tests/safety_core/kernel/mark_tap.hpp"
#include "tests/safety_core/kernel/rig.hpp"
#include "verification/trace/ids/kernel.hpp"

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <utility>

namespace counterpoint
{
namespace
{

class ChangedLatch : public Rig
{
  protected:
    explicit ChangedLatch(FlowWatch* const flow = nullptr) : Rig{nullptr, flow}
    {
    }
    /// The two words of a running latch in the kernel.
    std::uint8_t* Words()
    {
        const std::uint32_t running[] = {0x5A5A5A5AU, 0xA5A5A5A5U};
        std::uint8_t* const bytes = reinterpret_cast<std::uint8_t*>(&kernel);
        for (std::size_t place = 0U; place <= (sizeof(Kernel) - sizeof running); place += sizeof running[0])
        {
            if (std::memcmp(&bytes[place], running, sizeof running) == 0)
            {
                return &bytes[place];
            }
        }
        return nullptr;
    }
    static void Flip(std::uint8_t* const words, const std::uint32_t bit)
    {
        words[bit / 8U] = static_cast<std::uint8_t>(words[bit / 8U] ^ (1U << (bit % 8U)));
    }
};

// t       k        between     k + 1     between       k + 2 ...       Start
// bit     right    wrong                 right
// output  open                 closed                  closed          opens with the next pair
TEST_F(ChangedLatch, IsTheSafeStateUntilTheNextStart)
{
    Verifies(req::SRS_KRN_041);
    for (std::uint32_t bit = 0U; bit < 64U; ++bit)
    {
        Operate();
        ReceivePair();
        Cycle();
        ASSERT_EQ(Open(), 1U);
        std::uint8_t* const words = Words();
        ASSERT_NE(words, nullptr);
        // When one bit is wrong in one cycle alone
        Flip(words, bit);
        Cycle();
        Flip(words, bit);
        EXPECT_EQ(Open(), 0U) << "bit " << bit;
        EXPECT_EQ(application.faults.size(), bit + 1U);
        // Then neither pairs nor an acknowledge open the output again, and nothing is sent
        const std::size_t sent = ports.sent.size();
        for (std::uint32_t pair = 0U; pair < 3U; ++pair)
        {
            ReceivePair();
            Cycle(1U);
            EXPECT_EQ(Open(), 0U) << "bit " << bit;
        }
        EXPECT_EQ(kernel.Send(CommunicationIndex{0U}), Result::kDeviceFault);
        Cycle();
        EXPECT_EQ(ports.sent.size(), sent);
        EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kInvalid);
    }
}

// A bit that is wrong only while Send, or SendGfc, looks.
TEST_F(ChangedLatch, IsTheSafeStateFromSendOn)
{
    Verifies(req::SRS_KRN_041);
    for (const bool is_gfc : {false, true})
    {
        Operate();
        ReceivePair();
        Cycle();
        ASSERT_EQ(Open(), 1U);
        std::uint8_t* const words = Words();
        ASSERT_NE(words, nullptr);
        Flip(words, 3U);
        const Result result = is_gfc ? kernel.SendGfc() : kernel.Send(CommunicationIndex{0U});
        EXPECT_EQ(result, Result::kDeviceFault);
        Flip(words, 3U);
        Cycle();
        EXPECT_EQ(Open(), 0U);
        EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kInvalid);
    }
}

class ChangedWithinACycle : protected MarkTapHolder, public ChangedLatch
{
  protected:
    ChangedWithinACycle() : ChangedLatch{&flow}
    {
    }
};

// step   demotion   production   commit   events   permits   device fault told
// bit    wrong      right                                                          or wrong in one of the others alone
TEST_F(ChangedWithinACycle, IsSeenByEachThatDecides)
{
    Verifies(req::SRS_KRN_041);
    // Given a bit that is wrong from behind one step to behind the next: while it produces, commits, permits, tells
    const std::pair<FlowStep, FlowStep> moments[] = {{FlowStep::kDemotion, FlowStep::kProduction},
                                                     {FlowStep::kProduction, FlowStep::kCommit},
                                                     {FlowStep::kEvents, FlowStep::kPermits},
                                                     {FlowStep::kPermits, FlowStep::kInvalid}};
    for (const auto& [from, to] : moments)
    {
        Operate();
        ReceivePair();
        Cycle();
        ASSERT_EQ(Open(), 1U);
        std::uint8_t* const words = Words();
        ASSERT_NE(words, nullptr);
        flow.on_step = [words, begin = from, end = to](const FlowStep step)
        {
            if ((step == begin) || (step == end))
            {
                Flip(words, 40U);
            }
        };
        Cycle();
        flow.on_step = nullptr;
        if (to == FlowStep::kInvalid)
        {
            Flip(words, 40U);
        }
        // Then it is the safe state, and stays it
        EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kInvalid) << static_cast<int>(from);
        ReceivePair();
        Cycle(1U);
        EXPECT_EQ(Open(), 0U) << static_cast<int>(from);
    }
}

} // namespace
} // namespace counterpoint
