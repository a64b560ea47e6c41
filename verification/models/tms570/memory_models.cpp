// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/models/tms570/memory_models.hpp"

#include "hal/tms570/chip/system_registers.hpp"
#include "hal/tms570/chip/variant.hpp"
#include "hal/tms570/diagnosis/ecc.hpp"

namespace counterpoint::tms570::model
{

namespace
{

constexpr std::uint32_t kRightEcc = 0x0CU;
constexpr std::uint32_t kOneBit = 1U;
constexpr std::uint32_t kTwoBits = 3U;

[[nodiscard]] std::uint32_t UnitOf(const std::uint32_t offset)
{
    return offset & ~7U;
}

[[nodiscard]] bool IsOdd(const std::uint32_t offset)
{
    return (offset & 8U) != 0U;
}

} // namespace

bool TcramModel::MayWriteEcc()
{
    return Kept(tcram::kControl) == tcram::kDetectAndWrite;
}

void TcramModel::Report(const std::uint32_t bit)
{
    Kept(tcram::kErrorStatus) |= bit;
}

void TcramModel::Write(const std::uint32_t offset, const std::uint32_t value)
{
    Kept(offset) = (offset == tcram::kErrorStatus) ? (Kept(offset) & ~value) : value;
}

RamModel::RamModel(const FaultSet& faults, const RamBanks& banks) : Peripheral(faults), banks_(banks)
{
}

TcramModel& RamModel::BankOf(const std::uint32_t offset)
{
    return IsOdd(offset) ? banks_.odd : banks_.even;
}

std::uint32_t RamModel::Read(const std::uint32_t offset)
{
    const std::uint32_t bits = banks_.processor.ChecksRam() ? spoiled_[UnitOf(offset)] : 0U;
    if (bits == kOneBit)
    {
        if (!Has(Fault::kRamOneBitUnseen))
        {
            BankOf(offset).Report(tcram::kCorrected);
            banks_.esm.Raise(1U, IsOdd(offset) ? 28U : 26U);
        }
        return Kept(offset) ^ (Has(Fault::kRamOneBitWrong) ? 1U : 0U);
    }
    if ((bits == kTwoBits) && !Has(Fault::kRamTwoBitsUnseen))
    {
        BankOf(offset).Report(tcram::kUncorrected);
        banks_.esm.Raise(3U, IsOdd(offset) ? 5U : 3U);
        banks_.esm.Raise(2U, IsOdd(offset) ? 8U : 6U);
        banks_.abort.is_raised = true;
        banks_.abort.accessed = kRamOrigin + offset;
    }
    return Kept(offset);
}

std::uint32_t RamModel::ReadEcc(const std::uint32_t offset)
{
    return kRightEcc ^ spoiled_[UnitOf(offset)];
}

void RamModel::WriteEcc(const std::uint32_t offset, const std::uint32_t value)
{
    if (BankOf(offset).MayWriteEcc())
    {
        spoiled_[UnitOf(offset)] = value ^ kRightEcc;
    }
}

RamEccModel::RamEccModel(const FaultSet& faults, RamModel& ram) : Peripheral(faults), ram_(ram)
{
}

std::uint32_t RamEccModel::Read(const std::uint32_t offset)
{
    return ram_.ReadEcc(offset);
}

void RamEccModel::Write(const std::uint32_t offset, const std::uint32_t value)
{
    ram_.WriteEcc(offset, value);
}

Level2RamModel::Level2RamModel(const FaultSet& faults, EsmModel& esm) : Peripheral(faults), esm_(esm)
{
    Kept(level_2_ram::kTest) = level_2_ram::kTestOff;
}

void Level2RamModel::Judge()
{
    // 12h is the ECC of Ah, the only data that anybody shows it.
    const bool is_known = (Kept(level_2_ram::kDataHigh) == 0U) && (Kept(level_2_ram::kDataLow) == 0xAU);
    const std::uint32_t bits = is_known ? (Kept(level_2_ram::kEccVector) ^ 0x12U) : 0U;
    const bool is_one_seen = (bits == kOneBit) && !Has(Fault::kRamOneBitUnseen);
    const bool are_two_seen = (bits == kTwoBits) && !Has(Fault::kRamTwoBitsUnseen);
    const std::uint32_t raised = (is_one_seen ? level_2_ram::kOneBitErrors : 0U) |
                                 (are_two_seen ? level_2_ram::kTwoBitErrors : 0U) |
                                 (((bits == 0U) && Has(Fault::kRamOneBitWrong)) ? level_2_ram::kOneBitErrors : 0U);
    Kept(level_2_ram::kErrorStatus) |= raised;
    if (raised != 0U)
    {
        esm_.Raise(2U, 7U);
    }
}

void Level2RamModel::Write(const std::uint32_t offset, const std::uint32_t value)
{
    using namespace level_2_ram;
    if (offset == kErrorStatus)
    {
        Kept(offset) &= ~value;
        return;
    }
    const bool was_on = Kept(kTest) == (kEquality | kTestOn);
    const bool is_start = (offset == kTest) && (value == (kEquality | kTestOn | kTrigger));
    Kept(offset) = (offset == kTest) ? (value & ~kTrigger) : value;
    if (is_start && was_on && ((Kept(kErrorStatus) & kAllDiagnosis) == 0U))
    {
        Judge();
    }
}

FlashModel::FlashModel(const FaultSet& faults, const std::uint32_t read_control)
    : Peripheral(faults), read_control_(read_control)
{
}

std::uint32_t FlashModel::SpoiledBits()
{
    const bool is_on = Kept(flash::kDiagnosisControl) == (flash::kDiagnosisOn | flash::kDiagnosisTrigger);
    return is_on ? (Kept(flash::kParityOverride) & 0xFFU) : 0U;
}

void FlashModel::Report(const std::uint32_t bit)
{
    Kept(flash::kErrorStatus) |= bit;
}

void FlashModel::Write(const std::uint32_t offset, const std::uint32_t value)
{
    if (offset == system_module::kReadControl)
    {
        Kept(offset) = value & read_control_;
        return;
    }
    Kept(offset) = (offset == flash::kErrorStatus) ? (Kept(offset) & ~value) : value;
}

FlashMirrorModel::FlashMirrorModel(const FaultSet& faults, FlashModel& flash, EsmModel& esm, AbortLine& abort)
    : Peripheral(faults), flash_(flash), esm_(esm), abort_(abort)
{
}

std::uint32_t FlashMirrorModel::Read(const std::uint32_t offset)
{
    const std::uint32_t bits = flash_.SpoiledBits();
    if ((bits == kOneBit) && !Has(Fault::kFlashOneBitUnseen))
    {
        flash_.Report(flash::kCorrected);
        esm_.Raise(1U, 6U);
    }
    if ((bits == kTwoBits) && !Has(Fault::kFlashTwoBitsUnseen))
    {
        flash_.Report(flash::kUncorrected);
        esm_.Raise(3U, 7U);
        abort_.is_raised = true;
        abort_.accessed = flash::kMirror.address + offset;
    }
    return Kept(offset);
}

} // namespace counterpoint::tms570::model
