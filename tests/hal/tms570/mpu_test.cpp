// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "tests/hal/tms570/rig.hpp"
#include "verification/trace/ids/tms570.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

namespace counterpoint::tms570
{
namespace
{

class MpuTest : public ::testing::Test
{
  protected:
    void SetUp() override
    {
        ASSERT_EQ(rig.Start().answer, StartAnswer::kStarted);
    }
    [[nodiscard]] hal::ProtectStatus Protect(const std::uint32_t start, const std::uint32_t size,
                                             const hal::MemoryOwner owner)
    {
        const auto place = static_cast<std::uintptr_t>(start);
        return rig.board.Protection().Protect(hal::MemoryRegion{reinterpret_cast<const void*>(place), size, owner});
    }
    [[nodiscard]] bool MayWrite(const std::uint32_t address)
    {
        return rig.machine.processor.MayWrite(address, model::Privilege::kPrivileged);
    }
    [[nodiscard]] bool UserMayWrite(const std::uint32_t address)
    {
        return rig.machine.processor.MayWrite(address, model::Privilege::kUser);
    }

    Rig rig;
};

TEST_F(MpuTest, OnlyTheOwnerWritesWhileItRuns)
{
    Verifies(req::SRS_TMS_028);
    // Given a region for each party
    constexpr std::uint32_t kA = 0x08000000U;
    constexpr std::uint32_t kB = 0x08000800U;
    constexpr std::uint32_t kCore = 0x08001000U;
    ASSERT_EQ(Protect(kA, 0x800U, hal::MemoryOwner::kChannelA), hal::ProtectStatus::kProtected);
    ASSERT_EQ(Protect(kB, 0x800U, hal::MemoryOwner::kChannelB), hal::ProtectStatus::kProtected);
    ASSERT_EQ(Protect(kCore, 0x400U, hal::MemoryOwner::kKernel), hal::ProtectStatus::kProtected);
    // When channel A runs, then it writes its own region and the rest of the safe RAM only
    rig.board.Protection().Enter(hal::MemoryOwner::kChannelA);
    EXPECT_TRUE(MayWrite(kA + 0x7FCU));
    EXPECT_FALSE(MayWrite(kB));
    EXPECT_FALSE(MayWrite(kCore));
    EXPECT_TRUE(MayWrite(0x08001400U));
    // and channel B, and the core
    rig.board.Protection().Enter(hal::MemoryOwner::kChannelB);
    EXPECT_FALSE(MayWrite(kA));
    EXPECT_TRUE(MayWrite(kB));
    EXPECT_FALSE(MayWrite(kCore));
    rig.board.Protection().Enter(hal::MemoryOwner::kKernel);
    EXPECT_FALSE(MayWrite(kA));
    EXPECT_FALSE(MayWrite(kB));
    EXPECT_TRUE(MayWrite(kCore));
    // and nobody is nobody
    rig.board.Protection().Enter(hal::MemoryOwner::kInvalid);
    EXPECT_FALSE(MayWrite(kA) || MayWrite(kB) || MayWrite(kCore));
    // and all that is what the driver finds when it looks
    EXPECT_EQ(rig.CyclesUntilFault(60), BoardFault::kNone);
}

TEST_F(MpuTest, CodeInUserModeWritesItsOwnMemoryOnly)
{
    Verifies(req::SRS_TMS_028);
    // Given the fixed regions, then user mode writes non-safety memory and nothing else
    EXPECT_TRUE(UserMayWrite(0x08002000U));
    EXPECT_TRUE(UserMayWrite(0x080023FCU));
    EXPECT_FALSE(UserMayWrite(0x08002400U));
    EXPECT_FALSE(UserMayWrite(0x08000000U));
    // and reaches no peripheral, not even to read
    EXPECT_FALSE(UserMayWrite(0xFFF7BC00U));
    EXPECT_FALSE(rig.machine.processor.MayRead(0xFFF7BC00U, model::Privilege::kUser));
    // and nobody writes flash, or executes data
    EXPECT_FALSE(MayWrite(0x00000100U));
    EXPECT_TRUE(rig.machine.processor.MayExecute(0x00000100U, model::Privilege::kUser));
    EXPECT_FALSE(rig.machine.processor.MayExecute(0x08000000U, model::Privilege::kPrivileged));
    EXPECT_FALSE(rig.machine.processor.MayExecute(0x08002000U, model::Privilege::kPrivileged));
}

TEST_F(MpuTest, RefusesWhatItCannotProtect)
{
    Verifies(req::SRS_TMS_027);
    // Given regions too small, not a power of two, not aligned, without an owner
    EXPECT_EQ(Protect(0x08000000U, 16U, hal::MemoryOwner::kChannelA), hal::ProtectStatus::kRefused);
    EXPECT_EQ(Protect(0x08000000U, 0x600U, hal::MemoryOwner::kChannelA), hal::ProtectStatus::kRefused);
    EXPECT_EQ(Protect(0x08000400U, 0x800U, hal::MemoryOwner::kChannelA), hal::ProtectStatus::kRefused);
    EXPECT_EQ(Protect(0x08000000U, 0x800U, hal::MemoryOwner::kInvalid), hal::ProtectStatus::kRefused);
    // and a right one, of the least size
    EXPECT_EQ(Protect(0x08000020U, 32U, hal::MemoryOwner::kChannelA), hal::ProtectStatus::kProtected);
    // and as many as the processor has, less the three fixed ones
    for (std::uint32_t i = 0U; i < 8U; ++i)
    {
        EXPECT_EQ(Protect(0x08004000U + (i * 0x100U), 0x100U, hal::MemoryOwner::kKernel),
                  hal::ProtectStatus::kProtected);
    }
    EXPECT_EQ(Protect(0x08006000U, 0x100U, hal::MemoryOwner::kKernel), hal::ProtectStatus::kRefused);
}

TEST_F(MpuTest, RegionThatReadsOtherwiseIsRefused)
{
    Verifies(req::SRS_TMS_027);
    // Given a region whose base is not kept
    rig.machine.faults.Set(model::Fault::kMpuRegionLost);
    EXPECT_EQ(Protect(0x08000000U, 0x800U, hal::MemoryOwner::kChannelA), hal::ProtectStatus::kRefused);
}

} // namespace
} // namespace counterpoint::tms570
