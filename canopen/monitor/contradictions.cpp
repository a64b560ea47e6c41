// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/monitor/contradictions.hpp"

#include "canopen/cia306/text/input_error.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace counterpoint::monitor
{
namespace
{
using cia306::SrdoConfiguration;

/// An SRDO that is on, in its device.
struct End
{
    const NodeModel& node;
    const SrdoConfiguration& srdo;

    [[nodiscard]] std::array<std::uint64_t, 2> Identifiers() const
    {
        return {srdo.cob_id_1.value.value_or(0U), srdo.cob_id_2.value.value_or(0U)};
    }
    [[nodiscard]] std::string Name() const
    {
        return node.name + " SRDO " + std::to_string(srdo.number);
    }
};

std::string TextOf(const std::array<std::uint64_t, 2>& identifiers)
{
    return cia306::Hex(identifiers[0], 3) + " and " + cia306::Hex(identifiers[1], 3);
}

bool IsShared(const End& left, const End& right)
{
    const auto one = left.Identifiers();
    const auto other = right.Identifiers();
    return std::any_of(one.begin(), one.end(), [&other](const std::uint64_t identifier)
                       { return std::find(other.begin(), other.end(), identifier) != other.end(); });
}

std::uint32_t MappedBits(const End& end)
{
    std::uint32_t bits = 0U;
    for (const cia306::MappingEntry& entry : end.srdo.mapping)
    {
        bits += entry.IsNormal() ? entry.Bits() : 0U;
    }
    return bits;
}

/// Compares two ends; what is found is a finding in the file of the later one, an SCT in that of the consumer.
class Comparison
{
  public:
    Comparison(const End& earlier, const End& later, std::vector<Contradiction>& found)
        : earlier_(earlier), later_(later), found_(found)
    {
    }

    void Run() const
    {
        if (!IsShared(earlier_, later_))
        {
            return;
        }
        if (earlier_.Identifiers() != later_.Identifiers())
        {
            Tell(later_, later_.srdo.cob_id_1.place, later_.srdo.CommunicationIndex(), 5U,
                 "identifiers " + TextOf(later_.Identifiers()) + ", while " + earlier_.Name() + " has " +
                     TextOf(earlier_.Identifiers()) + ", expected the same pair, or none of its identifiers");
            return;
        }
        if (earlier_.srdo.IsProducer() && later_.srdo.IsProducer())
        {
            Tell(later_, later_.srdo.direction.place, later_.srdo.CommunicationIndex(), 1U,
                 "sends " + TextOf(later_.Identifiers()) + ", which " + earlier_.Name() +
                     " sends, too, expected one producer");
        }
        if (MappedBits(earlier_) != MappedBits(later_))
        {
            Tell(later_, later_.srdo.entry_count.place, later_.srdo.MappingIndex(), 0U,
                 std::to_string(MappedBits(later_)) + " bits mapped, while " + earlier_.Name() + " maps " +
                     std::to_string(MappedBits(earlier_)) + ", expected the same length");
        }
        CompareTimes(earlier_, later_);
        CompareTimes(later_, earlier_);
    }

  private:
    void CompareTimes(const End& producer, const End& consumer) const
    {
        const std::uint64_t refresh_ms = producer.srdo.sct_ms.value.value_or(0U);
        const std::uint64_t sct_ms = consumer.srdo.sct_ms.value.value_or(0U);
        if (producer.srdo.IsProducer() && consumer.srdo.IsConsumer() && sct_ms <= refresh_ms)
        {
            Tell(consumer, consumer.srdo.sct_ms.place, consumer.srdo.CommunicationIndex(), 2U,
                 "SCT " + std::to_string(sct_ms) + " ms, while " + producer.Name() + " has a refresh time of " +
                     std::to_string(refresh_ms) + " ms, expected an SCT above it");
        }
    }

    void Tell(const End& end, const cia306::Place& place, const std::uint16_t index, const std::uint8_t sub,
              const std::string& text) const
    {
        found_.push_back(
            {end.node.device.file, {cia306::Severity::kWarning, place, cia306::ObjectName(index, sub), text}});
    }

    const End& earlier_;
    const End& later_;
    std::vector<Contradiction>& found_;
};

/// A file that sets SRDOs up and does not declare them valid. [SRS_MON_021]
void TellInactive(const NodeModel& node, std::vector<Contradiction>& found)
{
    const auto& srdos = node.safety.srdos;
    const auto on = std::find_if(srdos.begin(), srdos.end(), [](const SrdoConfiguration& srdo) { return srdo.IsOn(); });
    if (on == srdos.end() || !node.active.empty())
    {
        return;
    }
    const cia306::Field& valid = node.safety.configuration_valid;
    const std::string what = valid.value ? cia306::Hex(*valid.value, 2) + ", so" : "is missing, so";
    found.push_back({node.device.file,
                     {cia306::Severity::kWarning, valid.value ? valid.place : on->place,
                      cia306::ObjectName(cia306::kConfigurationValidIndex, 0U),
                      what + " that no SRDO of " + node.name +
                          " is active and none is watched, expected 0xA5 where the device was declared valid"}});
}
} // namespace

std::vector<Contradiction> ContradictionsOf(const Network& network)
{
    std::vector<End> ends;
    std::vector<Contradiction> found;
    for (const NodeModel& node : network.Nodes())
    {
        for (const SrdoConfiguration& srdo : node.active)
        {
            ends.push_back({node, srdo});
        }
        TellInactive(node, found);
    }
    for (std::size_t later = 0U; later < ends.size(); ++later)
    {
        for (std::size_t earlier = 0U; earlier < later; ++earlier)
        {
            if (&ends[earlier].node != &ends[later].node)
            {
                Comparison(ends[earlier], ends[later], found).Run();
            }
        }
    }
    return found;
}
} // namespace counterpoint::monitor
