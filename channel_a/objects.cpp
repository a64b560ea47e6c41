// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "channel_a/channel.hpp"
#include "channel_a/octets.hpp"
#include "channel_a/seal.hpp"
#include "channel_a/slots.hpp"
#include "channel_a/voice.hpp"

#include <cstddef>
#include <cstdint>

// Data to and from the normal objects. Places are read from memory that may be corrupted: each is compared with the
// number of objects at every use, an object is accessed by its own length.
namespace counterpoint::channel_a
{
namespace
{

constexpr std::uint32_t kByteMask = 0xFFU;
constexpr std::uint32_t kShiftMask = kMaxPayloadBits - 1U;

enum class Way : std::uint8_t
{
    kRead = 0U,
    kWrite = 1U,
};

// The bits of all objects one behind the other, byte by byte, in one register: what is written is taken from its low
// end, what is read enters it at its high end; objects of the mapping of `total` bits fill it from there.
[[gnu::noinline, gnu::cold]] std::uint64_t Exchange(const Voice& voice, const std::size_t slot, const Way way,
                                                    const std::uint64_t data) noexcept
{
    const Mapping mapping = MappingOf(voice, slot);
    std::uint64_t bits = data;
    for (std::uint32_t position = 0U; position < mapping.count; position += 2U)
    {
        const MappableObject& object = ObjectAt(*voice.config, mapping, position);
        std::uint8_t* place = object.place;
        std::uint32_t width = 0U;
        for (std::uint32_t left = object.length_bits; left != 0U; left -= width)
        {
            width = (left < kBitsPerByte) ? left : kBitsPerByte;
            const std::uint32_t mask = kByteMask >> (kBitsPerByte - width);
            if (way == Way::kWrite)
            {
                *place = static_cast<std::uint8_t>(LowOf(bits) & mask);
            }
            bits = (bits >> width) | (std::uint64_t{*place & mask} << (kMaxPayloadBits - width));
            ++place; // MISRA D-002
        }
        if (object.length_bits == 0U)
        {
            bits >>= mapping.entries[position] & kShiftMask; // A dummy. MISRA D-002
        }
    }
    return bits >> ((kMaxPayloadBits - At(voice, slot).total_bits) & kShiftMask);
}

// Two objects of four bytes each.
struct Words
{
    std::uint8_t* low;
    std::uint8_t* high;
};

// The usual mapping goes without a loop; false: the data are of other objects.
inline bool FindWords(const Voice& voice, const std::size_t slot, Words& words) noexcept
{
    const DeviceConfig& config = *voice.config;
    const std::uint16_t* const places = voice.storage.places + (slot * voice.storage.row); // MISRA D-002
    const std::size_t first = places[kFirstEntry];                                         // MISRA D-002
    const std::size_t second = places[kSecondWord];                                        // MISRA D-002
    if ((first >= config.object_count) || (second >= config.object_count) ||
        (At(voice, slot).length_bytes != kMaxPayloadBytes))
    {
        return false;
    }
    const MappableObject& low = config.objects[first];   // MISRA D-002
    const MappableObject& high = config.objects[second]; // MISRA D-002
    if ((low.length_bits != kBitsPerWord) || (high.length_bits != kBitsPerWord))
    {
        return false;
    }
    words = Words{low.place, high.place};
    return true;
}

} // namespace

void WriteObjects(const Voice& voice, const std::size_t slot, const Payload& data) noexcept
{
    Words words{};
    if (!FindWords(voice, slot, words))
    {
        static_cast<void>(Exchange(voice, slot, Way::kWrite, Joined(data.low, data.high)));
        return;
    }
    PutWord(words.low, data.low);
    PutWord(words.high, data.high);
}

// What is read is what is sent, once it is confirmed.
PreparedPair Channel::Prepare(const SlotIndex slot) noexcept
{
    Record& record = At(voice_, slot);
    PreparedPair pair{};
    pair.status = PrepareStatus::kNotProducer;
    if (record.mode != kProducer)
    {
        return pair;
    }
    SetMode(record, kNormalAwaited);
    Words words{};
    if (FindWords(voice_, slot, words))
    {
        record.held = Payload{WordAt(words.low), WordAt(words.high)};
    }
    else
    {
        const std::uint64_t bits = Exchange(voice_, slot, Way::kRead, 0U);
        record.held = Payload{LowOf(bits), HighOf(bits)};
    }
    voice_.wanted &= ~BitOf(slot);
    Demand(record, kInFlight);
    record.refreshed = kUnmarked;
    const Instant now = voice_.now;
    record.frame_since = now;
    if (voice_.may_send && (record.form != ProducerForm::kProviderCalled))
    {
        record.since = now;
    }
    pair.normal.identifier = record.values[kCobIdPlace];
    pair.normal.kind = FrameKind::kData;
    pair.normal.port = voice_.ports[0];
    pair.normal.length_bytes = record.length_bytes;
    PutWord(&pair.normal.data[0], record.held.low);
    PutWord(&pair.normal.data[kBytesPerWord], record.held.high);
    pair.status = PrepareStatus::kReady;
    return pair;
}

} // namespace counterpoint::channel_a
