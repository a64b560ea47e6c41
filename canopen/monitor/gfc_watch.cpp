// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/monitor/gfc_watch.hpp"

#include "canopen/monitor/texts.hpp"

#include <algorithm>
#include <limits>

namespace counterpoint::monitor
{
namespace
{
/// Refresh time of a producer; 0: none of its own.
Time RefreshOf(const cia306::SrdoConfiguration& srdo)
{
    return srdo.IsProducer() ? static_cast<Time>(srdo.sct_ms.value.value_or(0U)) * kMillisecond : 0;
}
} // namespace

GfcWatch::GfcWatch(const Network& network)
{
    for (const NodeModel& node : network.Nodes())
    {
        Time shortest = std::numeric_limits<Time>::max();
        for (const cia306::SrdoConfiguration& srdo : node.active)
        {
            const Time refresh = RefreshOf(srdo);
            shortest = refresh != 0 ? std::min(shortest, refresh) : shortest;
        }
        for (const cia306::SrdoConfiguration& srdo : node.active)
        {
            const std::uint64_t place = srdo.cob_id_1.value.value_or(0U) - kFirstSrdo;
            const bool may_send = node.safety.gfc.Is(1U) && RefreshOf(srdo) != 0 && place < kSrdoIdentifiers;
            if (may_send)
            {
                limits_.at(place) = shortest;
                greatest_ = std::max(greatest_, shortest);
            }
        }
    }
}

void GfcWatch::OnFrame(const LogFrame& frame) noexcept
{
    const bool is_gfc = frame.identifier == kGfc && frame.length == 0U;
    if (is_gfc && greatest_ != 0 && !open_)
    {
        open_ = frame.time; // A second one changes nothing: the first is still to be followed.
    }
    const std::uint32_t place = frame.identifier - kFirstSrdo;
    const bool is_of_sender = place < kSrdoIdentifiers && limits_[place] != 0;
    if (open_ && is_of_sender && frame.time - *open_ <= limits_[place])
    {
        open_.reset();
    }
}

void GfcWatch::Stop() noexcept
{
    open_.reset();
}

std::optional<Breach> GfcWatch::Advance(const Time now)
{
    if (now <= Deadline())
    {
        return std::nullopt;
    }
    const Breach breach{Deadline(), Cause::kGfc,
                        "no SRDO of a device that may send it within " + MillisecondsText(greatest_) +
                            " after the GFC at " + SecondsText(*open_)};
    open_.reset();
    return breach;
}

Time GfcWatch::Deadline() const noexcept
{
    return open_ ? *open_ + greatest_ : std::numeric_limits<Time>::max();
}
} // namespace counterpoint::monitor
