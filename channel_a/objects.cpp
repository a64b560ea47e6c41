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

// All objects one behind the other, byte by byte, through one register: a byte that is written is its low end, and the
// byte that the object then holds comes in at the high end, without the bits above the object's length.
[[gnu::noinline]] std::uint64_t Exchange(const Voice& voice, const std::size_t slot, const Way way,
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
            if (way == Way::kWrite)
            {
                *place = static_cast<std::uint8_t>(LowOf(bits) & (kByteMask >> (kBitsPerByte - width)));
            }
            bits = (bits >> width) | (std::uint64_t{*place} << (kMaxPayloadBits - width));
            ++place; // MISRA D-002
        }
        if (object.length_bits == 0U)
        {
            bits >>= mapping.entries[position] & kShiftMask; // A dummy. MISRA D-002
        }
    }
    return bits >> ((kMaxPayloadBits - std::uint32_t{At(voice, slot).total_bits}) & kShiftMask);
}

// Two objects of four bytes each.
struct Words
{
    std::uint8_t* low;
    std::uint8_t* high;
};

// Four bytes of an object; false: there is no such object, or it is of another length.
inline bool FindWord(const DeviceConfig& config, const std::size_t place, std::uint8_t*& word) noexcept
{
    if ((place >= config.object_count) || (config.objects[place].length_bits != kBitsPerWord)) // MISRA D-002
    {
        return false;
    }
    word = config.objects[place].place; // MISRA D-002
    return true;
}

// The usual mapping of a full frame goes without a loop; false: the data are of other objects.
inline bool FindWords(const Voice& voice, const std::size_t slot, Words& words) noexcept
{
    const std::uint16_t* const places = voice.storage.places + (slot * voice.storage.row); // MISRA D-002
    return FindWord(*voice.config, places[kFirstEntry], words.low) &&                      // MISRA D-002
           FindWord(*voice.config, places[kSecondWord], words.high);                       // MISRA D-002
}

// Mode and length of a record at once.
constexpr std::uint32_t Shape(const std::uint32_t mode, const std::uint32_t length_bytes) noexcept
{
    return mode | (length_bytes << kBitsPerByte);
}

template <std::uint32_t kPlace> constexpr std::uint8_t Octet(const std::uint64_t bits) noexcept
{
    return static_cast<std::uint8_t>((bits >> (kPlace * kBitsPerByte)) & kByteMask);
}

inline void Hold(Record& record, const std::uint64_t bits) noexcept
{
    record.held = Payload{LowOf(bits), HighOf(bits)};
}

// What was read is what is sent, once it is confirmed. The way of the usual mapping has it inline, without a call, so
// that it has no registers to save.
inline PreparedPair Send(Voice& voice, const std::size_t slot, const std::uint8_t length_bytes) noexcept
{
    Record& record = At(voice, slot);
    const Instant now = voice.now;
    StepMode(record, kProducer, kNormalAwaited);
    Demand(record, kInFlight);
    record.refreshed = kUnmarked;
    record.frame_since = now;
    if (record.form != ProducerForm::kProviderCalled)
    {
        record.since = voice.origin;
    }
    voice.wanted &= ~BitOf(slot);
    const std::uint64_t bits = Joined(record.held.low, record.held.high);
    return PreparedPair{CanFrame{record.values[kCobIdPlace],
                                 FrameKind::kData,
                                 voice.ports[0],
                                 length_bytes,
                                 {Octet<0U>(bits), Octet<1U>(bits), Octet<2U>(bits), Octet<3U>(bits), Octet<4U>(bits),
                                  Octet<5U>(bits), Octet<6U>(bits), Octet<7U>(bits)}},
                        PrepareStatus::kReady};
}

} // namespace

void WriteObjects(const Voice& voice, const std::size_t slot, const Payload& data) noexcept
{
    Words words{};
    if ((At(voice, slot).length_bytes != kMaxPayloadBytes) || !FindWords(voice, slot, words))
    {
        static_cast<void>(Exchange(voice, slot, Way::kWrite, Joined(data.low, data.high)));
        return;
    }
    PutWord(words.low, data.low);
    PutWord(words.high, data.high);
}

[[gnu::noinline]] PreparedPair Channel::PrepareOther(const SlotIndex slot) noexcept
{
    if (At(voice_, slot).mode != kProducer)
    {
        PreparedPair none{};
        none.status = PrepareStatus::kNotProducer;
        return none;
    }
    Hold(At(voice_, slot), Exchange(voice_, slot, Way::kRead, 0U));
    return Send(voice_, slot, At(voice_, slot).length_bytes);
}

PreparedPair Channel::Prepare(const SlotIndex slot) noexcept
{
    Words words{};
    const Record& record = At(voice_, slot);
    if ((Shape(record.mode, record.length_bytes) != Shape(kProducer, kMaxPayloadBytes)) ||
        !FindWords(voice_, slot, words))
    {
        return PrepareOther(slot);
    }
    Hold(At(voice_, slot), Joined(WordAt(words.low), WordAt(words.high)));
    return Send(voice_, slot, kMaxPayloadBytes);
}

} // namespace counterpoint::channel_a
