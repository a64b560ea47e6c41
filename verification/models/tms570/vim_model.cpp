// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/models/tms570/vim_model.hpp"

#include "hal/tms570/interrupts.hpp"

namespace counterpoint::tms570::model
{

namespace
{

using namespace vim;

constexpr std::uint32_t kMain = kBase.address - kParityBase.address;
constexpr std::uint32_t kParityStart = kTableParity.address - kTable.address;
constexpr std::uint32_t kParityChannel = 15U;
constexpr std::uint32_t kUnknownChannel = 90U;

/// The model keeps one bit a word: whether its parity was spoiled.
[[nodiscard]] bool IsParity(const std::uint32_t offset)
{
    return offset >= kParityStart;
}

} // namespace

VimModel::VimModel(const FaultSet& faults, EsmModel& esm, DcanModel& first, DcanModel& second)
    : Peripheral(faults), esm_(esm), first_(first), second_(second)
{
    Kept(kMain + kEnableSet) = 3U;
    Kept(kMain + kIsFast) = 3U;
}

void VimModel::ReportParity()
{
    if (IsParityOn() && !Has(Fault::kVimParityUnseen))
    {
        Kept(kParityFlag) |= 1U;
        esm_.Raise(1U, kParityChannel);
    }
}

bool VimModel::IsParityTest()
{
    return (Kept(kParityControl) & kParityTest) != 0U;
}

bool VimModel::IsParityOn()
{
    return (Kept(kParityControl) & 0xFU) == kParityOn;
}

bool VimModel::IsEnabled(const std::uint32_t channel)
{
    return ((Kept(kMain + kEnableSet + (4U * (channel / 32U))) >> (channel % 32U)) & 1U) != 0U;
}

std::uint32_t VimModel::Index()
{
    if (Has(Fault::kVimUnknownRequest) && !unknown_masked_)
    {
        return kUnknownChannel + 1U;
    }
    if (first_.Line() && IsEnabled(static_cast<std::uint32_t>(InterruptRequest::kDcan1)))
    {
        return static_cast<std::uint32_t>(InterruptRequest::kDcan1) + 1U;
    }
    if (esm_.LowLine() && IsEnabled(static_cast<std::uint32_t>(InterruptRequest::kEsmLow)))
    {
        return static_cast<std::uint32_t>(InterruptRequest::kEsmLow) + 1U;
    }
    if (second_.Line() && IsEnabled(static_cast<std::uint32_t>(InterruptRequest::kDcan2)))
    {
        return static_cast<std::uint32_t>(InterruptRequest::kDcan2) + 1U;
    }
    return 0U;
}

bool VimModel::Line()
{
    return Index() != 0U;
}

bool VimModel::FastLine()
{
    return esm_.HighLine();
}

std::uint32_t VimModel::Read(const std::uint32_t offset)
{
    if (offset == kMain + kIrqIndex)
    {
        return Index();
    }
    if (offset == kMain + kFiqIndex)
    {
        return FastLine() ? 1U : 0U;
    }
    return Kept(offset);
}

void VimModel::Write(const std::uint32_t offset, const std::uint32_t value)
{
    const bool is_set = (offset >= kMain + kEnableSet) && (offset < kMain + kEnableClear);
    const bool is_clear = (offset >= kMain + kEnableClear) && (offset < kMain + kEnableClear + 16U);
    if (is_set)
    {
        Kept(offset) |= Has(Fault::kVimEnableLost) ? 0U : value;
        return;
    }
    if (is_clear)
    {
        unknown_masked_ = Has(Fault::kVimUnknownRequest);
        const std::uint32_t set = offset - (kEnableClear - kEnableSet);
        const std::uint32_t always = (set == kMain + kEnableSet) ? 3U : 0U;
        Kept(set) = (Kept(set) & ~value) | always;
        return;
    }
    if (offset == kParityFlag)
    {
        Kept(offset) &= ~value;
        return;
    }
    const bool is_lost = (offset == kFallback) && Has(Fault::kVimFallbackLost);
    Kept(offset) = is_lost ? 0U : value;
}

VimTableModel::VimTableModel(const FaultSet& faults, VimModel& vim) : Peripheral(faults), vim_(vim)
{
}

std::uint32_t VimTableModel::Read(const std::uint32_t offset)
{
    if (!IsParity(offset) && (Kept(kParityStart + offset) != 0U))
    {
        vim_.ReportParity();
    }
    const bool is_stuck = Has(Fault::kVimTableStuck) && (offset == 20U);
    return Kept(offset) & (is_stuck ? ~0x100U : kWholeWord);
}

void VimTableModel::Write(const std::uint32_t offset, const std::uint32_t value)
{
    if (!IsParity(offset) || vim_.IsParityTest())
    {
        Kept(offset) = value;
    }
}

} // namespace counterpoint::tms570::model
