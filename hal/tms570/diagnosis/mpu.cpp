// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// Memory protection unit (ARM DDI 0406, "Protected Memory System Architecture"; facts/tms570 1: 12 regions on a
// Cortex-R4F of this family, 16 on a Cortex-R5F).
#include "hal/tms570/diagnosis/mpu.hpp"

#include "hal/tms570/chip/processor.hpp"

namespace counterpoint::tms570
{

namespace
{

using namespace mpu;

constexpr std::uint32_t kWordBits = 32U;
constexpr std::uint32_t kFixedRegions = 3U; ///< Of Start; those of Protect follow.

[[nodiscard]] bool IsRegion(const ProtectedSpan& span) noexcept
{
    const bool is_power = (span.size_bytes & (span.size_bytes - 1U)) == 0U;
    const bool is_aligned = (span.start & (span.size_bytes - 1U)) == 0U;
    return (span.size_bytes >= kLeastBytes) && is_power && is_aligned;
}

/// The register has the power of two less 1.
[[nodiscard]] std::uint32_t SizeBits(const std::uint32_t size_bytes) noexcept
{
    std::uint32_t power = 0U;
    while ((power < (kWordBits - 1U)) && ((1U << power) != size_bytes))
    {
        ++power;
    }
    return ((power - 1U) << kSizeShift) | kSizeOn;
}

[[nodiscard]] std::uint32_t AccessOf(const hal::MemoryOwner owner, const hal::MemoryOwner running) noexcept
{
    const bool may_write = (owner == running) && (running != hal::MemoryOwner::kInvalid);
    return kNoExecution | kNormalMemory | (may_write ? kPrivilegedWrites : kNobodyWrites);
}

} // namespace

Outcome Mpu::Start(const MpuSetup& setup) noexcept
{
    count_ = 0U;
    examined_ = 0U;
    WriteProcessor(ProcessorRegister::kSystemControl, ReadProcessor(ProcessorRegister::kSystemControl) & ~kControlOn);
    const std::uint32_t regions = (ReadProcessor(ProcessorRegister::kMpuType) >> kTypeRegionsShift) & kTypeRegionsMask;
    room_ = regions;
    if (room_ > kMostRegions)
    {
        room_ = kMostRegions;
    }
    for (std::uint32_t number = 0U; number < room_; ++number)
    {
        WriteProcessor(ProcessorRegister::kRegionNumber, number);
        WriteProcessor(ProcessorRegister::kRegionSize, 0U);
    }
    constexpr hal::MemoryOwner kFixed = hal::MemoryOwner::kInvalid;
    Outcome outcome = Add(setup.flash, kNormalMemory | kNobodyWrites, kFixed);
    outcome = Both(outcome, Add(setup.ram, kNoExecution | kNormalMemory | kPrivilegedWrites, kFixed));
    outcome = Both(outcome, Add(setup.non_safety, kNoExecution | kNormalMemory | kAllWrite, kFixed));
    if (outcome != Outcome::kDone)
    {
        return Outcome::kFailed;
    }
    const std::uint32_t control = ReadProcessor(ProcessorRegister::kSystemControl);
    WriteProcessor(ProcessorRegister::kSystemControl, control | kControlOn | kControlBackground);
    return Examine();
}

Outcome Mpu::Add(const ProtectedSpan& span, const std::uint32_t access, const hal::MemoryOwner owner) noexcept
{
    const bool is_room = count_ < room_;
    if (!IsRegion(span) || !is_room)
    {
        return Outcome::kFailed;
    }
    const Region region{span.start, SizeBits(span.size_bytes), access, owner};
    const std::uint32_t number = count_;
    const std::uint32_t before = LockInterrupts();
    WriteProcessor(ProcessorRegister::kRegionNumber, number);
    WriteProcessor(ProcessorRegister::kRegionBase, region.start);
    WriteProcessor(ProcessorRegister::kRegionAccess, region.access);
    WriteProcessor(ProcessorRegister::kRegionSize, region.size);
    UnlockInterrupts(before);
    regions_[number] = region;
    const Outcome outcome = Compare(number);
    count_ += (outcome == Outcome::kDone) ? 1U : 0U;
    return outcome;
}

hal::ProtectStatus Mpu::Protect(const hal::MemoryRegion& region) noexcept
{
    const bool has_owner = (region.owner == hal::MemoryOwner::kChannelA) ||
                           (region.owner == hal::MemoryOwner::kChannelB) || (region.owner == hal::MemoryOwner::kKernel);
    if (!has_owner)
    {
        return hal::ProtectStatus::kRefused;
    }
    const auto start = static_cast<std::uint32_t>(reinterpret_cast<std::uintptr_t>(region.start)); // MISRA D-006
    const Outcome outcome =
        Add(ProtectedSpan{start, region.size_bytes}, AccessOf(region.owner, hal::MemoryOwner::kInvalid), region.owner);
    return (outcome == Outcome::kDone) ? hal::ProtectStatus::kProtected : hal::ProtectStatus::kRefused;
}

void Mpu::Enter(const hal::MemoryOwner owner) noexcept
{
    for (std::uint32_t number = kFixedRegions; number < count_; ++number)
    {
        Region& region = regions_[number];
        region.access = AccessOf(region.owner, owner);
        WriteRegionAccess(number, region.access);
    }
    Synchronise();
}

Outcome Mpu::Compare(const std::uint32_t number) const noexcept
{
    const Region& region = regions_[number];
    WriteProcessor(ProcessorRegister::kRegionNumber, number);
    const bool same_start = ReadProcessor(ProcessorRegister::kRegionBase) == region.start;
    const bool same_size = ReadProcessor(ProcessorRegister::kRegionSize) == region.size;
    const bool same_access = ReadProcessor(ProcessorRegister::kRegionAccess) == region.access;
    return (same_start && same_size && same_access) ? Outcome::kDone : Outcome::kFailed;
}

Outcome Mpu::Examine() noexcept
{
    constexpr std::uint32_t kOn = kControlOn | kControlBackground;
    if ((count_ == 0U) || ((ReadProcessor(ProcessorRegister::kSystemControl) & kOn) != kOn))
    {
        return Outcome::kFailed;
    }
    examined_ = ((examined_ + 1U) < count_) ? (examined_ + 1U) : 0U;
    return Compare(examined_);
}

} // namespace counterpoint::tms570
