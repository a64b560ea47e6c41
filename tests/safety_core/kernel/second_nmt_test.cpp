// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "safety_core/kernel/second_nmt.hpp"
#include "tests/safety_core/kernel/rig.hpp"
#include "verification/trace/ids/kernel.hpp"

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <new>
#include <vector>

namespace counterpoint
{
namespace
{

TEST(SecondNmt, IsWhatWasSetAndNoOperationalBefore)
{
    Verifies(req::SRS_KRN_033);
    SecondNmt nmt{};
    EXPECT_TRUE(nmt.HasStayed());
    EXPECT_EQ(nmt.Take(), NmtState::kInvalid);
    for (const NmtState state : {NmtState::kInitialising, NmtState::kPreOperational, NmtState::kStopped})
    {
        nmt.Set(state);
        (void)nmt.Take();
        EXPECT_EQ(nmt.Take(), state);
        nmt.Set(NmtState::kOperational);
        // The same command again leaves nothing
        nmt.Set(NmtState::kOperational);
        EXPECT_TRUE(nmt.HasStayed());
        EXPECT_EQ(nmt.Take(), NmtState::kOperational);
        nmt.Set(state);
        nmt.Set(NmtState::kOperational);
        EXPECT_FALSE(nmt.HasStayed());
        EXPECT_EQ(nmt.Take(), NmtState::kPreOperational);
        EXPECT_EQ(nmt.Take(), NmtState::kOperational);
    }
}

// Not inline: what stands in memory before an object begins must be written all the same.
[[gnu::noinline]] void* ZeroedMemory(const std::size_t size)
{
    void* const memory = ::operator new(size);
    std::memset(memory, 0, size);
    return memory;
}

/// Finds the kernel's copies of the state by what changes in its memory, whose unused bytes are 0.
class NmtCopies : public Rig
{
  public:
    static void* operator new(const std::size_t size)
    {
        return ZeroedMemory(size);
    }
    static void operator delete(void* const memory)
    {
        ::operator delete(memory);
    }

  protected:
    std::vector<std::uint8_t> Memory() const
    {
        std::vector<std::uint8_t> bytes(sizeof(Kernel));
        std::memcpy(bytes.data(), static_cast<const void*>(&kernel), bytes.size());
        return bytes;
    }
    void Flip(const std::size_t place, const std::uint32_t bits)
    {
        std::uint8_t* const bytes = reinterpret_cast<std::uint8_t*>(&kernel);
        bytes[place] = static_cast<std::uint8_t>(bytes[place] ^ bits);
    }
    /// Bytes that are `before` in one NMT state and `after` in the other.
    std::vector<std::size_t> Places(const std::vector<std::uint8_t>& other, const std::uint8_t before,
                                    const std::uint8_t after) const
    {
        const std::vector<std::uint8_t> now = Memory();
        std::vector<std::size_t> places;
        for (std::size_t place = 0U; place < now.size(); ++place)
        {
            if ((other[place] == before) && (now[place] == after))
            {
                places.push_back(place);
            }
        }
        return places;
    }
    std::vector<std::size_t> Copies()
    {
        EXPECT_EQ(kernel.Start(config, FlowCallback::kOff), StartResult::kStarted);
        kernel.SetNmtState(NmtState::kPreOperational);
        const std::vector<std::uint8_t> before = Memory();
        kernel.SetNmtState(NmtState::kStopped);
        std::vector<std::size_t> places = Places(before, 0x22U, 0x44U);
        const std::vector<std::size_t> inverse = Places(before, 0xDDU, 0xBBU);
        places.insert(places.end(), inverse.begin(), inverse.end());
        return places;
    }
    void LeaveAndEnter()
    {
        kernel.SetNmtState(NmtState::kPreOperational);
        kernel.SetNmtState(NmtState::kOperational);
    }
    struct Mark
    {
        std::size_t place;
        std::uint32_t bits;
    };
    /// Where each copy keeps that OPERATIONAL was left, and what tells it.
    std::vector<Mark> Marks()
    {
        Operate();
        const std::vector<std::uint8_t> before = Memory();
        LeaveAndEnter();
        const std::vector<std::size_t> first = Places(before, 0U, 1U);
        const std::vector<std::size_t> second = Places(before, 0x96U, 0U);
        EXPECT_EQ(first.size(), 1U);
        EXPECT_EQ(second.size(), 1U);
        return {Mark{first.at(0), 1U}, Mark{second.at(0), 0x96U}};
    }
};

TEST_F(NmtCopies, EachBitOfEachCopyIsADisagreementWithinACycle)
{
    Verifies(req::SRS_KRN_033);
    const std::vector<std::size_t> copies = Copies();
    ASSERT_EQ(copies.size(), 2U);
    for (const std::size_t copy : copies)
    {
        for (std::uint32_t bit = 0U; bit < 8U; ++bit)
        {
            Operate();
            ReceivePair();
            Cycle();
            ASSERT_EQ(Open(), 1U);
            Flip(copy, 1U << bit);
            Cycle();
            EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kDisagreement) << "bit " << bit;
            EXPECT_EQ(Open(), 0U);
        }
    }
}

// One copy becomes OPERATIONAL by itself (D8h instead of 22h).
TEST_F(NmtCopies, OneThatEntersOperationalAloneIsADisagreement)
{
    Verifies(req::SRS_KRN_033);
    for (const std::size_t copy : Copies())
    {
        Configure();
        Cycle();
        Flip(copy, 0x22U ^ 0xD8U);
        Cycle();
        EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kDisagreement);
    }
}

// OPERATIONAL was left and entered again, and one copy has forgotten it.
TEST_F(NmtCopies, OneThatForgetsThatOperationalWasLeftIsADisagreement)
{
    Verifies(req::SRS_KRN_033);
    for (const Mark& mark : Marks())
    {
        Operate();
        LeaveAndEnter();
        Flip(mark.place, mark.bits);
        Cycle();
        EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kDisagreement);
    }
    // With both it is no fault
    Operate();
    LeaveAndEnter();
    Cycles(2U);
    EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kNone);
}

// Either mark alone keeps an inverse frame back.
TEST_F(NmtCopies, OneThatSaysThatOperationalWasLeftKeepsTheInverseFrameBack)
{
    Verifies(req::SRS_KRN_215);
    Verifies(req::SRS_KRN_033);
    for (const Mark& mark : Marks())
    {
        ports.sent.clear();
        Operate();
        Cycle();
        ASSERT_EQ(ports.sent.size(), 1U);
        Flip(mark.place, mark.bits);
        ConfirmLast();
        EXPECT_EQ(ports.sent.size(), 1U);
    }
}

} // namespace
} // namespace counterpoint
