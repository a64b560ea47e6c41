// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/models/tms570/vim_model.hpp"

#include "hal/tms570/interrupts.hpp"

namespace counterpoint::tms570::model
{

namespace
{

using namespace vim;

constexpr std::uint32_t kMain = kBase.address - kCheckBase.address;
constexpr std::uint32_t kCheckBitsStart = kTableCheckBits.address - kTable.address;
constexpr std::uint32_t kVector = kMain + 0x70U; ///< IRQVECREG; the next one is for fast requests.
constexpr std::uint32_t kFastVector = kMain + 0x74U;
constexpr std::uint32_t kErrorChannel = 15U;
constexpr std::uint32_t kOneBitChannel = 83U;
constexpr std::uint32_t kUnknownChannel = 90U;

constexpr std::uint32_t kKeyAt = 0xFU;
constexpr std::uint32_t kKeyA = 0xAU;
constexpr std::uint32_t kKey5 = 0x5U;
constexpr std::uint32_t kTestShift = 8U;
constexpr std::uint32_t kCorrectShift = 16U;
constexpr std::uint32_t kReportShift = 24U;
constexpr std::uint32_t kEccAfterReset = 0x050A0A05U;

/// The model keeps the check bits that were spoiled, not those that fit.
[[nodiscard]] bool AreCheckBits(const std::uint32_t offset)
{
    return offset >= kCheckBitsStart;
}

[[nodiscard]] std::uint32_t CountOf(std::uint32_t bits)
{
    std::uint32_t count = 0U;
    for (; bits != 0U; bits &= bits - 1U)
    {
        ++count;
    }
    return count;
}

} // namespace

VimModel::VimModel(const FaultSet& faults, const VimPlace& place, const TableCheck check)
    : Peripheral(faults), esm_(place.esm), first_(place.first), second_(place.second),
      has_ecc_(check == TableCheck::kEcc)
{
    Kept(kMain + kEnableSet) = 3U;
    Kept(kMain + kIsFast) = 3U;
    Kept(kCheckControl) = has_ecc_ ? kEccAfterReset : kKey5;
}

void VimModel::Report(const std::uint32_t wrong_bits, const std::uint32_t address)
{
    if (!IsOn() || (wrong_bits == 0U))
    {
        return;
    }
    if (!has_ecc_)
    {
        ReportParity();
        return;
    }
    if ((wrong_bits == 1U) || Has(Fault::kVimTwoBitsTakenForOne))
    {
        ReportOneBit();
        return;
    }
    ReportTwoBits(address);
}

void VimModel::ReportParity()
{
    if (!Has(Fault::kVimParityUnseen))
    {
        Kept(kCheckStatus) |= kErrorFlag;
        esm_.Raise(1U, kErrorChannel);
    }
}

/// Not corrected, it bypasses the table as two wrong bits do. That it raises channel 15 of the ESM too is said nowhere,
/// so that it does not here.
void VimModel::ReportOneBit()
{
    if (Has(Fault::kVimOneBitUnseen))
    {
        return;
    }
    const bool is_corrected = HasKey(kCorrectShift, kKeyA);
    Kept(kCheckStatus) |= kOneBitFlag | (is_corrected ? 0U : kErrorFlag);
    if (HasKey(kReportShift, kKeyA))
    {
        esm_.Raise(1U, kOneBitChannel);
    }
}

void VimModel::ReportTwoBits(const std::uint32_t address)
{
    if (Has(Fault::kVimTwoBitsUnseen))
    {
        return;
    }
    const bool is_first = (Kept(kCheckStatus) & kErrorFlag) == 0U;
    Kept(kErrorAddress) = is_first ? address : Kept(kErrorAddress);
    Kept(kCheckStatus) |= kErrorFlag;
    esm_.Raise(1U, kErrorChannel);
}

bool VimModel::HasKey(const std::uint32_t shift, const std::uint32_t key)
{
    return ((Kept(kCheckControl) >> shift) & kKeyAt) == key;
}

bool VimModel::IsTest()
{
    return has_ecc_ ? HasKey(kTestShift, kKey5) : ((Kept(kCheckControl) & kParityTest) != 0U);
}

bool VimModel::IsOn()
{
    return has_ecc_ ? !HasKey(0U, kKey5) : HasKey(0U, kParityOn);
}

/// Two of the keys take nothing but Ah and 5h.
void VimModel::WriteEccControl(const std::uint32_t value)
{
    std::uint32_t taken = value & 0x0F0F0F0FU;
    for (const std::uint32_t shift : {kCorrectShift, kReportShift})
    {
        const std::uint32_t key = (value >> shift) & kKeyAt;
        const std::uint32_t field = kKeyAt << shift;
        const bool is_valid = (key == kKeyA) || (key == kKey5);
        taken = is_valid ? taken : ((taken & ~field) | (Kept(kCheckControl) & field));
    }
    Kept(kCheckControl) = taken;
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
    const bool is_vector = (offset == kVector) || (offset == kFastVector);
    if (is_vector && ((Kept(kCheckStatus) & kErrorFlag) != 0U))
    {
        return Kept(kFallback);
    }
    if ((offset == kCheckControl) && Has(Fault::kVimCheckOff))
    {
        return (Kept(offset) & ~kKeyAt) | kKey5;
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
    if (offset == kCheckStatus)
    {
        Kept(offset) &= ~value;
        return;
    }
    if (has_ecc_ && (offset == kCheckControl))
    {
        WriteEccControl(value);
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
    if (!AreCheckBits(offset))
    {
        vim_.Report(CountOf(Kept(kCheckBitsStart + offset)), kTable.address + offset);
    }
    const bool is_stuck = Has(Fault::kVimTableStuck) && (offset == 20U);
    return Kept(offset) & (is_stuck ? ~0x100U : kWholeWord);
}

void VimTableModel::Write(const std::uint32_t offset, const std::uint32_t value)
{
    if (!AreCheckBits(offset) || vim_.IsTest())
    {
        Kept(offset) = value;
    }
}

} // namespace counterpoint::tms570::model
