// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/models/tms570/machine.hpp"

#include "hal/tms570/chip/system_registers.hpp"
#include "hal/tms570/diagnosis/ecc.hpp"
#include "hal/tms570/diagnosis/esm_registers.hpp"
#include "hal/tms570/diagnosis/lockstep.hpp"
#include "hal/tms570/interrupts.hpp"
#include "hal/tms570/output/gio_registers.hpp"
#include "hal/tms570/time/clock_comparator.hpp"
#include "hal/tms570/time/rti_registers.hpp"

#include <iterator>
#include <stdexcept>
#include <utility>

namespace counterpoint::tms570::model
{

namespace
{

Machine* the_machine = nullptr;

/// 4 cycles of an 80 MHz bus.
constexpr std::uint64_t kAccessNs = 50U;
constexpr std::uint64_t kNsPerUs = 1000U;
constexpr std::uint32_t kDcan1Parity = 21U;
constexpr std::uint32_t kDcan2Parity = 23U;
constexpr std::uint32_t kFrame = 0x100U;
constexpr std::uint32_t kDcanBytes = 0x200U;
constexpr std::uint32_t kMirrorBytes = 0x100U;
/// SPNU563A, 7.10.1: wait states and prefetch.
constexpr std::uint32_t kLc43xReadControl = 0xF03U;
/// The vendor's register headers: one controller of power, or three on an LC43x.
constexpr std::uint32_t kPower = 0xFFFFE000U;
constexpr std::uint32_t kLc43xPower[] = {0xFFFF1000U, 0xFCFF1000U, 0xFFF78000U};

[[nodiscard]] bool IsLc43x(const Variant& variant)
{
    return variant.level_2_ram == Presence::kPresent;
}

} // namespace

Machine::Machine(const Variant& variant)
    : dcan1(faults, esm, kDcan1Parity), dcan2(faults, esm, kDcan2Parity),
      vim(faults, VimPlace{esm, dcan1, dcan2}, variant.table_check), vim_table(faults, vim),
      rti(faults, esm, variant.clocks.rti_mhz), ccm(faults, esm, variant.comparators), dcc(faults, esm, variant.clocks),
      system(faults, IsLc43x(variant) ? kLc43xBits : kCortexR4Bits), stc(faults, system), pbist(faults, system),
      processor(faults, variant.mpu_regions), flash_(faults, IsLc43x(variant) ? kLc43xReadControl : kWholeWord),
      ram_(faults, RamBanks{even_, odd_, esm, processor, abort_}), ram_ecc_(faults, ram_),
      mirror_(faults, flash_, esm, abort_)
{
    if (the_machine != nullptr)
    {
        throw std::logic_error("there is a machine already");
    }
    the_machine = this;
    constexpr std::uint32_t kVimBytes = (vim::kBase.address - vim::kCheckBase.address) + kFrame;
    Map(kDcan1Base.address, kDcanBytes, dcan1);
    Map(kDcan2Base.address, kDcanBytes, dcan2);
    Map(rti::kBase.address, kFrame, rti);
    Map(gio::kBase.address, kFrame, gio);
    Map(esm::kBase.address, kFrame, esm);
    Map(ccm::kBase.address, kFrame, ccm);
    Map(vim::kCheckBase.address, kVimBytes, vim);
    Map(vim::kTable.address, 2U * (vim::kTableCheckBits.address - vim::kTable.address), vim_table);
    Map(dcc::kBase.address, kFrame, dcc);
    Map(system_module::kBase.address, kFrame, system);
    Map(system_module::kSystem2.address, kFrame, system2_);
    MapPower(variant);
    Map(system_module::kStc.address, kFrame, stc);
    Map(system_module::kPbist.address, 2U * kFrame, pbist);
    Map(flash::kBase.address, kFrame, flash_);
    Map(flash::kMirror.address, kMirrorBytes, mirror_);
    if (variant.tcram_test == Presence::kPresent)
    {
        Map(tcram::kEvenBank.address, kFrame, even_);
        Map(tcram::kOddBank.address, kFrame, odd_);
        Map(kRamOrigin + tcram::kEccOffset, variant.ram_bytes, ram_ecc_);
    }
    if (variant.level_2_ram == Presence::kPresent)
    {
        Map(level_2_ram::kBase.address, kFrame, level_2_ram_);
    }
    Map(kRamOrigin, variant.ram_bytes, ram_);
}

void Machine::MapPower(const Variant& variant)
{
    if (!IsLc43x(variant))
    {
        Map(kPower, kFrame, power_[0]);
        return;
    }
    for (std::size_t number = 0U; number < std::size(kLc43xPower); ++number)
    {
        Map(kLc43xPower[number], kFrame, power_[number]);
    }
}

Machine::~Machine()
{
    the_machine = nullptr;
}

Machine& Machine::Current()
{
    if (the_machine == nullptr)
    {
        throw std::logic_error("no machine");
    }
    return *the_machine;
}

void Machine::Map(const std::uint32_t first, const std::uint32_t bytes, Peripheral& peripheral)
{
    ranges_.push_back(Range{first, bytes, &peripheral});
}

const Machine::Range* Machine::Find(const std::uint32_t address)
{
    for (const Range& range : ranges_)
    {
        if ((address - range.first) < range.bytes)
        {
            return &range;
        }
    }
    strays_.push_back(address);
    return nullptr;
}

std::uint32_t Machine::Read(const std::uint32_t address)
{
    Pass(kAccessNs);
    const Range* const range = Find(address);
    return (range == nullptr) ? 0U : range->peripheral->Read(address - range->first);
}

void Machine::Write(const std::uint32_t address, const std::uint32_t value)
{
    Pass(kAccessNs);
    const Range* const range = Find(address);
    if (range != nullptr)
    {
        range->peripheral->Write(address - range->first, value);
    }
}

std::uint64_t Machine::NowUs() const
{
    return now_ns_ / kNsPerUs;
}

void Machine::SetSurroundings(std::function<void()> surroundings)
{
    surroundings_ = std::move(surroundings);
}

void Machine::OfferInterrupts()
{
    if (surroundings_ && !interrupts_locked && !is_interrupted_)
    {
        is_interrupted_ = true;
        surroundings_();
        is_interrupted_ = false;
    }
}

void Machine::Pass(const std::uint64_t ns)
{
    now_ns_ += ns;
    esm.Advance(ns);
    rti.Advance(ns);
    ccm.Advance(ns);
    dcc.Advance(ns);
    system.Advance(ns);
    pbist.Advance(ns);
}

void Machine::Advance(const std::uint64_t us)
{
    // In steps, so that a comparison of clocks within them is not passed over.
    for (std::uint64_t i = 0U; i < us; ++i)
    {
        Pass(kNsPerUs);
    }
}

void Machine::Sleep()
{
    processor_reset_ = stc.OnSleep() || processor_reset_;
}

bool Machine::TakeProcessorReset()
{
    const bool was_reset = processor_reset_;
    processor_reset_ = false;
    return was_reset;
}

AbortLine Machine::TakeAbort()
{
    const AbortLine line = abort_;
    abort_ = AbortLine{};
    return line;
}

} // namespace counterpoint::tms570::model
