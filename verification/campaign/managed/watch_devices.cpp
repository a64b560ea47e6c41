// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// The devices themselves: what they are, and what their outputs do.
#include "verification/campaign/managed/watch.hpp"

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

void Watch::LookAtOutputs(const Nanoseconds now)
{
    for (const Slave& slave : stage_.Slaves())
    {
        const simulator::Node& node = stage_.World().At(slave.index);
        for (std::uint32_t slot = 0U; slot < node.Model().Srdos().size(); ++slot)
        {
            LookAtOutput(slave, slot, now);
        }
    }
}

void Watch::LookAtOutput(const Slave& slave, const std::uint32_t slot, const Nanoseconds now)
{
    const simulator::Node& node = stage_.World().At(slave.index);
    Output& output = outputs_[{slave.index, static_cast<std::uint8_t>(slot)}];
    const bool is_open = node.HasSupply() && ((node.Open() >> slot) & 1U) != 0U;
    const bool may_be = node.State() == cia301::NodeState::kOperational;
    output.without_leave = (is_open && !may_be) ? output.without_leave + kMs : 0;
    if (output.without_leave > kCycles)
    {
        Tell(Wrong::kNoLeave);
    }
    if (!is_open)
    {
        output.closed = output.is_open ? now : output.closed;
    }
    else if (!output.is_open && !IsAcknowledged(stage_, slave, slot, output.closed - kMs, now))
    {
        if (reference_ == nullptr)
        {
            made_.automatic.insert({slave.index, slot});
        }
        else if (reference_->automatic.count({slave.index, slot}) == 0U)
        {
            Tell(Wrong::kNoAcknowledge);
        }
    }
    output.is_open = is_open;
}

void Watch::Draw()
{
    picture_.words.clear();
    picture_.values.clear();
    for (const Slave& slave : stage_.Slaves())
    {
        simulator::Node& node = stage_.World().At(slave.index);
        picture_.words.push_back(static_cast<std::uint32_t>(node.State()) |
                                 (node.HasSupply() ? static_cast<std::uint32_t>(node.Open()) << 8U : 0U));
        for (const runtime::PairValue& pair : node.App().Logic().Pairs())
        {
            if (pair.is_consumer)
            {
                const bool is_open = node.HasSupply() && (node.Open() & pair.slot) != 0U;
                picture_.values.push_back(is_open ? pair.normal : pair.safe);
            }
        }
    }
    for (const auto& manager : stage_.Managers())
    {
        picture_.words.push_back(manager->HasSupply() ? 1U : 0U);
        if (!manager->HasSupply())
        {
            continue;
        }
        const cia302::Manager& core = manager->Station()->Assembly().Core();
        picture_.words.push_back((core.IsActive() ? 1U : 0U) | (static_cast<std::uint32_t>(core.OwnState()) << 1U));
        for (const auto& slave : manager->Net().Slaves())
        {
            const cia302::NodeId id{slave->plan.node};
            const cia302::NodeStatus status = core.Status(id);
            picture_.words.push_back(static_cast<std::uint32_t>(core.Table().Record(id).state) |
                                     (static_cast<std::uint32_t>(core.Gate().State(id)) << 8U) |
                                     (static_cast<std::uint32_t>(static_cast<std::uint8_t>(status.letter)) << 16U));
            picture_.words.push_back(static_cast<std::uint32_t>(status.code) | (status.is_started ? 0x10000U : 0U));
        }
    }
}

/// An output that is open has what it has without fault: now, not longer ago than data may be old, or as much sooner as
/// its producers may send in another phase.
void Watch::LookAtValues(const Nanoseconds now)
{
    if (reference_ == nullptr)
    {
        return;
    }
    const auto here = static_cast<std::size_t>(now / kMs);
    const auto age = static_cast<std::size_t>(age_ / kMs);
    const std::size_t first = (here > age) ? here - age : 0U;
    const std::size_t last = std::min(here + static_cast<std::size_t>(phase_ / kMs), reference_->pictures.size() - 1U);
    std::size_t place = 0U;
    for (const Slave& slave : stage_.Slaves())
    {
        simulator::Node& node = stage_.World().At(slave.index);
        for (const runtime::PairValue& pair : node.App().Logic().Pairs())
        {
            if (!pair.is_consumer)
            {
                continue;
            }
            const std::uint64_t value = picture_.values.at(place);
            bool is_known = value == pair.safe;
            for (std::size_t ms = first; ms <= last && !is_known; ++ms)
            {
                const std::vector<std::uint64_t>& values = reference_->pictures[ms].values;
                is_known = place < values.size() && values[place] == value;
            }
            const std::vector<Picture>& all = reference_->pictures;
            const bool is_ever_open =
                !is_known && std::any_of(all.begin(), all.end(), [place, &pair](const Picture& each)
                                         { return place < each.values.size() && each.values[place] != pair.safe; });
            if (is_ever_open) // Else the run without fault says nothing of its data.
            {
                Tell(Wrong::kData);
            }
            ++place;
        }
    }
}
} // namespace counterpoint::campaign::managed
