// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "simulator/world/node.hpp"

#include <algorithm>

// What the world does to a node, and what it may look at.
namespace counterpoint::simulator
{
namespace
{
constexpr std::int32_t kTrueRate = 1000000; ///< Millionths.
} // namespace

void Node::SetAcknowledge(const std::uint8_t srdo, const bool level)
{
    const SrdoMask bit = SrdoMask{1U} << model_.SlotOf(srdo).value_or(0U);
    acknowledge_ = level ? (acknowledge_ | bit) : (acknowledge_ & ~bit);
    journal_.Tell({Now(), EventKind::kAcknowledge, place_.index, srdo, level ? 1U : 0U, 0U});
}

void Node::SendGfc()
{
    Result result = Result::kDeviceFault;
    if (!is_hung_ && is_on_)
    {
        Guarded(
            [this, &result]()
            {
                RequireSound();
                result = assembly_.Core().SendGfc();
            });
    }
    journal_.Tell({Now(), EventKind::kGfc, place_.index, 0U, (result == Result::kSuccessful) ? 1U : 0U, 0U});
}

void Node::ShiftCycle(const Nanoseconds by)
{
    next_cycle_ = std::max(next_cycle_ + by, Now());
    SettleNextEvent();
}

void Node::SetCounterRate(const bool is_counter_a, const std::int32_t drift_ppm)
{
    host::HostClock& clock = is_counter_a ? clocks_.A() : clocks_.B();
    clock.SetRate(Now(), static_cast<std::uint32_t>(kTrueRate + drift_ppm));
}

void Node::JumpCounter(const bool is_counter_a, const Nanoseconds by)
{
    host::HostClock& clock = is_counter_a ? clocks_.A() : clocks_.B();
    clock.Jump(Now(), static_cast<std::int32_t>(by / kNanosecondsPerMicrosecond));
}

std::vector<MemoryPiece> Node::PiecesOfPart(const Part part, const std::uint8_t srdo)
{
    if (part == Part::kChannelA || part == Part::kChannelB)
    {
        runtime::OwnedChannel& channel = (part == Part::kChannelA) ? *channel_a_ : *channel_b_;
        return {{channel.Bytes(), channel.Size()}};
    }
    if (part >= Part::kProgram)
    {
        return WatchedPieces(part);
    }
    const bool is_of_device =
        part == Part::kSetup || part == Part::kSafeValue || part == Part::kObjects || part == Part::kVariables;
    return is_of_device ? PiecesOf(part, model_, srdo) : PiecesOf(part, assembly_.Core());
}

const std::vector<host::NodeIndex>& Node::BusNodes() const noexcept
{
    return bus_nodes_;
}

SrdoMask Node::Level(const Part part, const SrdoMask frozen)
{
    const PartCondition& condition = faults_.Condition(part);
    if (!condition.is_faulty)
    {
        return acknowledge_;
    }
    if (frozen != acknowledge_)
    {
        faults_.HasEffect(condition);
    }
    return frozen;
}

const runtime::DeviceModel& Node::Model() const noexcept
{
    return model_;
}

NodeApplication& Node::App() noexcept
{
    return application_;
}

PartFaults& Node::Faults() noexcept
{
    return faults_;
}

host::HostCanPorts& Node::Can() noexcept
{
    return can_;
}

Kernel& Node::Core() noexcept
{
    return assembly_.Core();
}

const PairTimes& Node::TimesOf(const SlotIndex slot) const noexcept
{
    return times_[slot];
}

cia301::NodeState Node::State() const noexcept
{
    return is_on_ ? state_ : cia301::NodeState::kInvalid;
}

void Node::SetSerial(const std::uint32_t serial) noexcept
{
    serial_ = serial;
}

void Node::Store(const ObjectAddress& object, const std::uint32_t value)
{
    if (is_on_ && !is_hung_ && place_.file != nullptr)
    {
        Guarded(
            [this, &object, value]()
            {
                const cia301::Reading size = assembly_.Dictionary().SizeOf(object);
                static_cast<void>(assembly_.Dictionary().WriteNumber(object, value, size.size_bytes));
            });
    }
}

SrdoMask Node::Open() const noexcept
{
    return open_;
}

Nanoseconds Node::Now() const noexcept
{
    return bus_.Now();
}

std::uint8_t Node::NumberOf(const SlotIndex slot) const noexcept
{
    return model_.NumberOf(slot);
}
} // namespace counterpoint::simulator
