// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/injection/outside.hpp"

#include "verification/injection/image/mailbox.hpp"

namespace counterpoint::injection
{
namespace
{

constexpr std::uint32_t kPortOffsets[2] = {0x34U, 0x54U};
constexpr std::uint32_t kErrorPin = 0xFFFFF538U; ///< ESMEKR

} // namespace

std::uint32_t Outside::ReadPort(const std::uint32_t address) const
{
    for (std::uint32_t port = 0U; port < 2U; ++port)
    {
        const std::uint32_t offset = address - kGio - kPortOffsets[port];
        if (offset == 0x00U)
        {
            return world_.direction[port];
        }
        if (offset == 0x04U)
        {
            return world_.direction[port] & world_.output[port];
        }
        if ((offset == 0x08U) || (offset == 0x0CU) || (offset == 0x10U))
        {
            return world_.output[port];
        }
    }
    return (address == kGio) ? 1U : 0U;
}

void Outside::WritePin(const std::uint32_t offset, const std::uint32_t value)
{
    for (std::uint32_t port = 0U; port < 2U; ++port)
    {
        switch (offset - kPortOffsets[port])
        {
        case 0x00U:
            world_.direction[port] = value;
            break;
        case 0x08U:
            world_.output[port] = value;
            break;
        case 0x0CU:
            world_.output[port] |= value;
            break;
        case 0x10U:
            world_.output[port] &= ~value;
            break;
        default:
            break;
        }
    }
}

void Outside::WritePort(const std::uint32_t address, const std::uint32_t value)
{
    switch (address)
    {
    case kPortAddress + kPortIdentifier:
        sending_.identifier = value;
        break;
    case kPortAddress + kPortLength:
        sending_.length_bytes = value;
        break;
    case kPortAddress + kPortFirst:
        sending_.first = value;
        break;
    case kPortAddress + kPortSecond:
        sending_.second = value;
        seen_.sent.push_back(sending_);
        break;
    case kPortAddress + kPortAnswer:
        seen_.answer = value;
        seen_.is_answered = true;
        break;
    case kPortAddress + kPortEvent:
        seen_.events.push_back(value);
        break;
    case kPortAddress + kPortDeviceFault:
        seen_.device_fault = value;
        break;
    case kPortAddress + kPortRefused:
        seen_.refused += value;
        break;
    case kErrorPin:
        world_.is_error_pin_low = world_.is_error_pin_low || (value != 0U);
        break;
    default:
        if ((address & ~(kPage - 1U)) == (kGio & ~(kPage - 1U)))
        {
            WritePin(address - kGio, value);
        }
        break;
    }
}

void Outside::Begin()
{
    seen_ = Seen{};
    world_.pending.clear();
}

const Seen& Outside::End(const StepEnd end, const std::array<ObjectPair, 3>& objects)
{
    seen_.end = end;
    seen_.pins = world_.direction[0] & world_.output[0];
    seen_.is_cut_off = world_.is_error_pin_low || (world_.direction[0] == 0U);
    seen_.objects = objects;
    world_.pending = seen_.sent;
    return seen_;
}

void Outside::Add(Digest& to) const
{
    for (std::uint32_t port = 0U; port < 2U; ++port)
    {
        to.Add((std::uint64_t{world_.direction[port]} << 32U) | world_.output[port]);
    }
    to.Add(world_.is_error_pin_low ? 1U : 0U);
    to.Add(world_.pending.size());
    for (const SentFrame& frame : world_.pending)
    {
        to.Add((std::uint64_t{frame.identifier} << 32U) | frame.length_bytes);
        to.Add((std::uint64_t{frame.first} << 32U) | frame.second);
    }
}

} // namespace counterpoint::injection
