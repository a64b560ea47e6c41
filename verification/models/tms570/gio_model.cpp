// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/models/tms570/gio_model.hpp"

#include "hal/tms570/output/gio_registers.hpp"

namespace counterpoint::tms570::model
{

namespace
{

using namespace gio;

constexpr std::uint32_t kPortOffsetA = kPortA.address - kBase.address;
constexpr std::uint32_t kPortOffsetB = kPortB.address - kBase.address;

} // namespace

std::uint32_t GioModel::PinsA()
{
    return Pins(kPortOffsetA);
}

std::uint32_t GioModel::PinsB()
{
    return Pins(kPortOffsetB) | (inputs_b & ~Kept(kPortOffsetB + kDirection));
}

std::uint32_t GioModel::Pins(const std::uint32_t port)
{
    std::uint32_t pins = Kept(port + kDirection) & Kept(port + kOutput);
    const bool is_high = Has(Fault::kPinStuckHigh) || Has(Fault::kPinStuckHighAtStart);
    pins |= is_high ? 1U : 0U;
    pins &= Has(Fault::kPinStuckLow) ? ~1U : 0xFFU;
    return pins;
}

std::uint32_t GioModel::Read(const std::uint32_t offset)
{
    for (const std::uint32_t port : {kPortOffsetA, kPortOffsetB})
    {
        if (offset == port + kInput)
        {
            return (port == kPortOffsetB) ? PinsB() : Pins(port);
        }
        if ((offset == port + kDirection) && Has(Fault::kPinNotOutput))
        {
            return 0U;
        }
        if ((offset == port + kSet) || (offset == port + kClear))
        {
            return Kept(port + kOutput);
        }
    }
    return Kept(offset);
}

void GioModel::Write(const std::uint32_t offset, const std::uint32_t value)
{
    for (const std::uint32_t port : {kPortOffsetA, kPortOffsetB})
    {
        if (offset == port + kSet)
        {
            Kept(port + kOutput) |= value;
            return;
        }
        if (offset == port + kClear)
        {
            Kept(port + kOutput) &= ~value;
            return;
        }
        if ((offset == port + kDirection) && Has(Fault::kPinStaysOutput))
        {
            Kept(offset) |= value;
            return;
        }
    }
    Kept(offset) = value;
}

} // namespace counterpoint::tms570::model
