// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "channel_a/objects.hpp"

#include "channel_a/mapping.hpp"

#include <cstdint>

// Steps come from memory that may be corrupted: an object is looked for below the number of objects, is accessed by its
// own length, and only where its bits lie within the frame. Bits of the last byte of an object above its length are not
// read and are written as 0. [SRS_CFG_036]
namespace counterpoint::channel_a
{
namespace
{

// The object of a step; null where there is none, or not within the frame.
const MappableObject* ObjectOf(const DeviceConfig& config, const Step& step) noexcept
{
    if (step.normal >= config.object_count)
    {
        return nullptr;
    }
    const MappableObject* const object = &config.objects[step.normal]; // MISRA D-002
    return ((std::uint32_t{step.first_bit} + object->length_bits) <= kMaxPayloadBits) ? object : nullptr;
}

// Whether an object is whole bytes of the frame; else it is moved bit by bit.
bool IsOfBytes(const Step& step, const MappableObject& object) noexcept
{
    return ((step.first_bit % kBitsPerByte) | (object.length_bits % kBitsPerByte)) == 0U;
}

// Bit `bit` of the bytes from `bytes` on.
std::uint32_t BitAt(const std::uint8_t* const bytes, const std::uint32_t bit) noexcept
{
    return (std::uint32_t{bytes[bit / kBitsPerByte]} >> (bit % kBitsPerByte)) & 1U; // MISRA D-002
}

// Sets or clears it.
void PutBit(std::uint8_t* const bytes, const std::uint32_t bit, const std::uint32_t value) noexcept
{
    std::uint8_t& byte = bytes[bit / kBitsPerByte]; // MISRA D-002
    const std::uint32_t others = byte & ~(std::uint32_t{1U} << (bit % kBitsPerByte));
    byte = static_cast<std::uint8_t>(others | (value << (bit % kBitsPerByte)));
}

void CopyBytes(std::uint8_t* const to, const std::uint8_t* const from, const std::uint32_t length_bytes) noexcept
{
    for (std::uint32_t place = 0U; place < length_bytes; ++place)
    {
        to[place] = from[place]; // MISRA D-002
    }
}

// The bits that are not the same in both, of all bytes together.
std::uint8_t Differing(const std::uint8_t* const one, const std::uint8_t* const other,
                       const std::uint32_t length_bytes) noexcept
{
    std::uint8_t differing = 0U;
    for (std::uint32_t place = 0U; place < length_bytes; ++place)
    {
        differing = static_cast<std::uint8_t>(differing | (std::uint32_t{one[place]} ^ other[place])); // MISRA D-002
    }
    return differing;
}

// Bits from `from_bit` on become those from `to_bit` on.
void CopyBits(std::uint8_t* const to, const std::uint32_t to_bit, const std::uint8_t* const from,
              const std::uint32_t from_bit, const std::uint32_t length_bits) noexcept
{
    for (std::uint32_t bit = 0U; bit < length_bits; ++bit)
    {
        PutBit(to, to_bit + bit, BitAt(from, from_bit + bit));
    }
}

// The bits of an object and those above them in its last byte.
std::uint32_t RoundedUp(const std::uint32_t length_bits) noexcept
{
    return ((length_bits + (kBitsPerByte - 1U)) / kBitsPerByte) * kBitsPerByte;
}

void WriteObject(const MappableObject& object, const Step& step, const Bytes& data) noexcept
{
    const std::uint32_t length_bits = object.length_bits;
    if (IsOfBytes(step, object))
    {
        CopyBytes(object.place, &data.at[step.first_bit / kBitsPerByte], length_bits / kBitsPerByte);
        return;
    }
    CopyBits(object.place, 0U, &data.at[0], step.first_bit, length_bits);
    for (std::uint32_t above = length_bits; above < RoundedUp(length_bits); ++above)
    {
        PutBit(object.place, above, 0U);
    }
}

void ReadObject(const MappableObject& object, const Step& step, Bytes& data) noexcept
{
    const std::uint32_t length_bits = object.length_bits;
    if (IsOfBytes(step, object))
    {
        CopyBytes(&data.at[step.first_bit / kBitsPerByte], object.place, length_bits / kBitsPerByte);
        return;
    }
    CopyBits(&data.at[0], step.first_bit, object.place, 0U, length_bits);
}

// What of an object is not its part of the data; 0: nothing. Bits above its length are not looked at.
std::uint32_t WrongPart(const MappableObject& object, const Step& step, const Bytes& data) noexcept
{
    const std::uint32_t length_bits = object.length_bits;
    std::uint32_t wrong = 0U;
    if (IsOfBytes(step, object))
    {
        return Differing(object.place, &data.at[step.first_bit / kBitsPerByte], length_bits / kBitsPerByte);
    }
    for (std::uint32_t bit = 0U; bit < length_bits; ++bit)
    {
        wrong |= BitAt(object.place, bit) ^ BitAt(&data.at[0], step.first_bit + bit);
    }
    return wrong;
}

} // namespace

Bytes ReadObjects(Voice& voice, const std::size_t slot) noexcept
{
    const DeviceConfig& config = *voice.config;
    const StepRange steps = StepsOf(voice, slot);
    Bytes data{};
    for (const Step* step = steps.first; step != steps.end; ++step) // MISRA D-002
    {
        const MappableObject* const object = ObjectOf(config, *step);
        if (object != nullptr)
        {
            ReadObject(*object, *step, data);
        }
    }
    return data;
}

void WriteObjects(Voice& voice, const std::size_t slot, const Bytes& data) noexcept
{
    const DeviceConfig& config = *voice.config;
    const StepRange steps = StepsOf(voice, slot);
    for (const Step* step = steps.first; step != steps.end; ++step) // MISRA D-002
    {
        const MappableObject* const object = ObjectOf(config, *step);
        if (object != nullptr)
        {
            WriteObject(*object, *step, data);
        }
    }
}

// A step that is not of dummies and leads to no object is wrong, too.
bool HoldObjects(Voice& voice, const std::size_t slot, const Bytes& data) noexcept
{
    const DeviceConfig& config = *voice.config;
    const StepRange steps = StepsOf(voice, slot);
    std::uint32_t wrong = 0U;
    for (const Step* step = steps.first; step != steps.end; ++step) // MISRA D-002
    {
        const MappableObject* const object = ObjectOf(config, *step);
        wrong |= (object != nullptr) ? WrongPart(*object, *step, data) : (std::uint32_t{step->normal} ^ kNoObject);
    }
    return wrong == 0U;
}

} // namespace counterpoint::channel_a
