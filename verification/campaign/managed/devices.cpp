// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/campaign/managed/devices.hpp"

#include <algorithm>

namespace counterpoint::campaign::managed
{
namespace
{
constexpr Nanoseconds kMs = runtime::kNanosecondsPerMillisecond;
constexpr Nanoseconds kCycles = 5 * kMs; ///< An output follows the state of its device within this.

[[nodiscard]] bool IsAcknowledged(Stage& stage, const Slave& slave, const std::uint32_t slot, const Nanoseconds from,
                                  const Nanoseconds now)
{
    const std::uint8_t number = stage.World().At(slave.index).Model().NumberOf(static_cast<SlotIndex>(slot));
    const auto& all = stage.Setting().acknowledges;
    return std::any_of(
        all.begin(), all.end(), [&slave, number, from, now](const simulator::Acknowledge& each)
        { return each.node == slave.index && each.srdo == number && each.at <= now && each.at + each.pulse >= from; });
}
} // namespace

Devices::Devices(Stage& stage) : stage_(stage)
{
    constexpr Nanoseconds kSlack = 20 * kMs;
    constexpr Nanoseconds kChain = 2; // From a sensor to a controller to an actuator.
    for (const Slave& slave : stage.Slaves())
    {
        for (const runtime::SrdoModel& srdo : stage.World().At(slave.index).Model().Srdos())
        {
            phase_ = std::max(phase_, kChain * srdo.times.sct_ms * kMs / 2);
            age_ = std::max(age_, kChain * (srdo.times.sct_ms + srdo.times.srvt_ms) * kMs + kSlack);
        }
    }
}

Wrong Devices::LookAtOutputs(const Reference* const reference, Reference& made, const Nanoseconds now)
{
    Wrong wrong = Wrong::kNothing;
    for (const Slave& slave : stage_.Slaves())
    {
        const simulator::Node& node = stage_.World().At(slave.index);
        for (std::uint32_t slot = 0U; slot < node.Model().Srdos().size(); ++slot)
        {
            const Wrong found = LookAtOutput(slave, slot, reference, made, now);
            wrong = (wrong == Wrong::kNothing) ? found : wrong;
        }
    }
    return wrong;
}

Wrong Devices::LookAtOutput(const Slave& slave, const std::uint32_t slot, const Reference* const reference,
                            Reference& made, const Nanoseconds now)
{
    const simulator::Node& node = stage_.World().At(slave.index);
    Output& output = outputs_[{slave.index, slot}];
    const bool is_open = node.HasSupply() && ((node.Open() >> slot) & 1U) != 0U;
    const bool may_be = node.State() == cia301::NodeState::kOperational;
    output.without_leave = (is_open && !may_be) ? output.without_leave + kMs : 0;
    Wrong wrong = (output.without_leave > kCycles) ? Wrong::kNoLeave : Wrong::kNothing;
    if (!is_open)
    {
        output.closed = output.is_open ? now : output.closed;
    }
    else if (!output.is_open && !IsAcknowledged(stage_, slave, slot, output.closed - kMs, now))
    {
        if (reference == nullptr)
        {
            made.automatic.insert({slave.index, slot});
        }
        else if (reference->automatic.count({slave.index, slot}) == 0U && wrong == Wrong::kNothing)
        {
            wrong = Wrong::kNoAcknowledge;
        }
    }
    output.is_open = is_open;
    return wrong;
}

void Devices::Draw(Picture& picture, const Nanoseconds now)
{
    picture.words.clear();
    picture.values.clear();
    for (const Slave& slave : stage_.Slaves())
    {
        simulator::Node& node = stage_.World().At(slave.index);
        picture.words.push_back(static_cast<std::uint32_t>(node.State()) |
                                (node.HasSupply() ? static_cast<std::uint32_t>(node.Open()) << 8U : 0U));
        for (const runtime::PairValue& pair : node.App().Logic().Pairs())
        {
            if (pair.is_consumer)
            {
                const bool is_open = node.HasSupply() && (node.Open() & pair.slot) != 0U;
                picture.values.push_back(is_open ? pair.normal : pair.safe);
            }
        }
    }
    for (std::size_t index = 0U; index < stage_.Managers().size(); ++index)
    {
        const simulator::SimulatedManager& manager = *stage_.Managers()[index];
        picture.words.push_back(manager.HasSupply() ? 1U : 0U);
        if (manager.HasSupply())
        {
            stage_.Guards()[index]->Look(now, [&picture, &manager]() { DrawManager(picture, manager); });
        }
    }
}

void Devices::DrawManager(Picture& picture, const simulator::SimulatedManager& manager)
{
    const cia302::Manager& core = manager.Station()->Assembly().Core();
    picture.words.push_back((core.IsActive() ? 1U : 0U) | (static_cast<std::uint32_t>(core.OwnState()) << 1U));
    for (const auto& slave : manager.Net().Slaves())
    {
        const cia302::NodeId id{slave->plan.node};
        const cia302::NodeStatus status = core.Status(id);
        picture.words.push_back(static_cast<std::uint32_t>(core.Table().Record(id).state) |
                                (static_cast<std::uint32_t>(core.Gate().State(id)) << 8U) |
                                (static_cast<std::uint32_t>(static_cast<std::uint8_t>(status.letter)) << 16U));
        picture.words.push_back(static_cast<std::uint32_t>(status.code) | (status.is_started ? 0x10000U : 0U));
    }
}

/// An output that is open has what it has without fault: now, not longer ago than data may be old, or as much sooner as
/// its producers may send in another phase.
Wrong Devices::LookAtValues(const Picture& picture, const Reference& reference, const Nanoseconds now)
{
    Wrong wrong = Wrong::kNothing;
    std::size_t place = 0U;
    for (const Slave& slave : stage_.Slaves())
    {
        simulator::Node& node = stage_.World().At(slave.index);
        for (const runtime::PairValue& pair : node.App().Logic().Pairs())
        {
            if (pair.is_consumer)
            {
                wrong = IsKnown(reference, place, pair, picture.values.at(place), now) ? wrong : Wrong::kData;
                ++place;
            }
        }
    }
    return wrong;
}

/// Of an output that is never open without fault that run says nothing.
bool Devices::IsKnown(const Reference& reference, const std::size_t place, const runtime::PairValue& pair,
                      const std::uint64_t value, const Nanoseconds now) const
{
    const std::vector<Picture>& all = reference.pictures;
    const auto here = static_cast<std::size_t>(now / kMs);
    const auto age = static_cast<std::size_t>(age_ / kMs);
    const std::size_t first = (here > age) ? here - age : 0U;
    const std::size_t last = std::min(here + static_cast<std::size_t>(phase_ / kMs), all.size() - 1U);
    bool is_known = value == pair.safe;
    for (std::size_t ms = first; ms <= last && !is_known; ++ms)
    {
        is_known = place < all[ms].values.size() && all[ms].values[place] == value;
    }
    return is_known || std::none_of(all.begin(), all.end(), [place, &pair](const Picture& each)
                                    { return place < each.values.size() && each.values[place] != pair.safe; });
}

bool Devices::IsHeldByItself(const Slave& slave)
{
    constexpr ObjectAddress kValid{0x13FEU, 0U};
    constexpr std::uint32_t kIsValid = 0xA5U;
    const std::optional<std::uint32_t> valid = stage_.ValueIn(slave, kValid);
    const DeviceFault fault = stage_.World().At(slave.index).Firmware().Assembly().Core().DeviceState().fault;
    return !valid || *valid != kIsValid || fault != DeviceFault::kNone;
}
} // namespace counterpoint::campaign::managed
