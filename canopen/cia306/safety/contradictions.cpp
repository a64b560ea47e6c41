// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia306/safety/contradictions.hpp"

#include "canopen/cia306/text/input_error.hpp"

#include <algorithm>
#include <array>
#include <cstdint>

namespace counterpoint::cia306
{
namespace
{
using Identifiers = std::array<std::uint64_t, 2>;

Identifiers IdentifiersOf(const SrdoEnd& end)
{
    return {end.srdo->cob_id_1.value.value_or(0U), end.srdo->cob_id_2.value.value_or(0U)};
}

std::string NameOf(const SrdoEnd& end)
{
    return end.name + " SRDO " + std::to_string(end.srdo->number);
}

std::string TextOf(const Identifiers& identifiers)
{
    return Hex(identifiers[0], 3) + " and " + Hex(identifiers[1], 3);
}

bool IsShared(const SrdoEnd& left, const SrdoEnd& right)
{
    const Identifiers one = IdentifiersOf(left);
    const Identifiers other = IdentifiersOf(right);
    return std::any_of(one.begin(), one.end(), [&other](const std::uint64_t identifier)
                       { return std::find(other.begin(), other.end(), identifier) != other.end(); });
}

std::uint32_t MappedBits(const SrdoEnd& end)
{
    std::uint32_t bits = 0U;
    for (const MappingEntry& entry : end.srdo->mapping)
    {
        bits += entry.IsNormal() ? entry.Bits() : 0U;
    }
    return bits;
}

/// Compares two ends; what is found is a finding in the file of the later one, an SCT in that of the consumer.
class Comparison
{
  public:
    Comparison(const SrdoEnd& earlier, const SrdoEnd& later, std::vector<Contradiction>& found)
        : earlier_(earlier), later_(later), found_(found)
    {
    }

    void Run() const
    {
        if (!IsShared(earlier_, later_))
        {
            return;
        }
        if (IdentifiersOf(earlier_) != IdentifiersOf(later_))
        {
            Tell(later_, later_.srdo->cob_id_1.place, later_.srdo->CommunicationIndex(), 5U,
                 "identifiers " + TextOf(IdentifiersOf(later_)) + ", while " + NameOf(earlier_) + " has " +
                     TextOf(IdentifiersOf(earlier_)) + ", expected the same pair, or none of its identifiers");
            return;
        }
        if (earlier_.srdo->IsProducer() && later_.srdo->IsProducer())
        {
            Tell(later_, later_.srdo->direction.place, later_.srdo->CommunicationIndex(), 1U,
                 "sends " + TextOf(IdentifiersOf(later_)) + ", which " + NameOf(earlier_) +
                     " sends, too, expected one producer");
        }
        if (MappedBits(earlier_) != MappedBits(later_))
        {
            Tell(later_, later_.srdo->entry_count.place, later_.srdo->MappingIndex(), 0U,
                 std::to_string(MappedBits(later_)) + " bits mapped, while " + NameOf(earlier_) + " maps " +
                     std::to_string(MappedBits(earlier_)) + ", expected the same length");
        }
        CompareTimes(earlier_, later_);
        CompareTimes(later_, earlier_);
    }

  private:
    void CompareTimes(const SrdoEnd& producer, const SrdoEnd& consumer) const
    {
        const std::uint64_t refresh_ms = producer.srdo->sct_ms.value.value_or(0U);
        const std::uint64_t sct_ms = consumer.srdo->sct_ms.value.value_or(0U);
        if (producer.srdo->IsProducer() && consumer.srdo->IsConsumer() && sct_ms <= refresh_ms)
        {
            Tell(consumer, consumer.srdo->sct_ms.place, consumer.srdo->CommunicationIndex(), 2U,
                 "SCT " + std::to_string(sct_ms) + " ms, while " + NameOf(producer) + " has a refresh time of " +
                     std::to_string(refresh_ms) + " ms, expected an SCT above it");
        }
    }

    void Tell(const SrdoEnd& end, const Place& place, const std::uint16_t index, const std::uint8_t sub,
              const std::string& text) const
    {
        found_.push_back({end.file, {Severity::kWarning, place, ObjectName(index, sub), text}});
    }

    const SrdoEnd& earlier_;
    const SrdoEnd& later_;
    std::vector<Contradiction>& found_;
};

} // namespace

std::vector<Contradiction> ContradictionsOf(const std::vector<SrdoEnd>& ends)
{
    std::vector<Contradiction> found;
    for (std::size_t later = 0U; later < ends.size(); ++later)
    {
        for (std::size_t earlier = 0U; earlier < later; ++earlier)
        {
            if (ends[earlier].device != ends[later].device)
            {
                Comparison(ends[earlier], ends[later], found).Run();
            }
        }
    }
    return found;
}
} // namespace counterpoint::cia306
