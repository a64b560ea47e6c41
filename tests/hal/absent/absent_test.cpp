// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "hal/absent/absent.hpp"
#include "verification/trace/ids/hal.hpp"
#include "verification/trace/ids/selftest.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

namespace counterpoint::hal
{
namespace
{

TEST(Absent, CanPortsRefuseEveryFrameAndGuaranteeNothing)
{
    Verifies(req::SRS_HAL_006);
    // Given no CAN controller
    AbsentCanPorts ports;
    // When a right frame is transmitted, then it is refused
    const CanFrame frame{0x101U, FrameKind::kData, CanPortId::kFirst, 1U, {0x55U}};
    EXPECT_EQ(ports.Transmit(frame), TransmitStatus::kRefused);
    // and each guarantee is absent
    EXPECT_EQ(ports.Guarantees().bus_order, Guarantee::kAbsent);
    EXPECT_EQ(ports.Guarantees().stamps, Guarantee::kAbsent);
    EXPECT_EQ(ports.Guarantees().confirmations, Guarantee::kAbsent);
    EXPECT_EQ(CheckGuarantees(ports.Guarantees()), MissingGuarantee::kBusOrder);
}

TEST(Absent, OutputOpensNothingOnRightPermits)
{
    Verifies(req::SRS_HAL_006);
    // Given no output
    AbsentSafetyOutput output;
    const std::uint32_t first = output.Challenge();
    const std::uint32_t second = output.Challenge();
    // Then its challenges obey the contract
    EXPECT_NE(first, 0U);
    EXPECT_NE(second, 0U);
    EXPECT_NE(first, second);
    // When three right permits for slot 0 come
    const std::uint32_t sum = second + 1U;
    output.Drive(
        PermitSet{{1U, sum * kPermitConstantA}, {1U, sum * kPermitConstantB}, {1U, sum * kPermitConstantKernel}});
    // Then nothing is open
    EXPECT_EQ(output.Open(), 0U);
}

TEST(Absent, WatchdogIsTrippedWhateverTheAnswer)
{
    Verifies(req::SRS_HAL_006);
    // Given no watchdog
    AbsentWatchdog watchdog;
    // When its question is answered rightly
    const WatchdogQuestion question = watchdog.Question();
    watchdog.Answer(WatchdogAnswer{(kFlowReference + question.value) * kWatchdogConstant});
    // Then it is tripped all the same
    EXPECT_FALSE(watchdog.IsAlive());
}

TEST(Absent, OutputCannotBeProbed)
{
    Verifies(req::SRS_STS_031);
    const AbsentSafetyOutput output;
    EXPECT_EQ(output.Probe(PermitSet{}, 2U), ProbeAnswer::kAbsent);
}

TEST(Absent, MemoryProtectionSaysThatItIsAbsent)
{
    Verifies(req::SRS_HAL_006);
    // Given no MPU, when a region is to be protected, then the status says that there is none
    AbsentMemoryProtection protection;
    const unsigned char memory[32] = {};
    EXPECT_EQ(protection.Protect(MemoryRegion{memory, 32U, MemoryOwner::kChannelA}), ProtectStatus::kAbsent);
    protection.Enter(MemoryOwner::kChannelB);
    EXPECT_EQ(protection.Protect(MemoryRegion{memory, 32U, MemoryOwner::kChannelB}), ProtectStatus::kAbsent);
}

TEST(Absent, ParameterMemoryFailsAndReadsNothing)
{
    Verifies(req::SRS_HAL_016);
    // Given no parameter memory
    AbsentParameterMemory memory;
    EXPECT_EQ(memory.BankBytes(), 0U);
    // When something is erased, programmed and read
    const std::uint8_t from[kProgramUnitBytes] = {1U, 2U, 3U};
    std::uint8_t to[kProgramUnitBytes] = {9U};
    memory.Erase(MemoryBank::kFirst);
    EXPECT_EQ(memory.Status(), MemoryStatus::kFailed);
    memory.Program({MemoryBank::kFirst, 0U, kProgramUnitBytes}, from);
    // Then it has failed, and nothing was read
    EXPECT_EQ(memory.Status(), MemoryStatus::kFailed);
    EXPECT_FALSE(memory.Read({MemoryBank::kFirst, 0U, 3U}, to));
    EXPECT_EQ(to[0], 9U);
}

} // namespace
} // namespace counterpoint::hal
