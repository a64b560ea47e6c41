// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/conformance/dictionary.hpp"

#include "verification/conformance/hash.hpp"

namespace counterpoint::conformance
{

namespace
{
std::uint8_t BytesOf(std::uint8_t bits) noexcept
{
    return static_cast<std::uint8_t>((bits + 7U) / 8U);
}
} // namespace

Dictionary::Dictionary() noexcept
{
    Add(0x2000U, 0U, 8U, MapAccess::kProducer);
    Add(0x2001U, 0U, 8U, MapAccess::kProducer);
    AddRange(0x6010U, 2U, 8U, MapAccess::kConsumer);
    AddRange(0x6011U, 2U, 8U, MapAccess::kConsumer);
    AddRange(0x6200U, 1U, 32U, MapAccess::kConsumer);
    AddRange(0x6201U, 1U, 32U, MapAccess::kConsumer);
    AddRange(0x6210U, 2U, 8U, MapAccess::kProducer);
    AddRange(0x6211U, 2U, 8U, MapAccess::kProducer);
    AddSizes(0x6300U, MapAccess::kConsumer);
    AddSizes(0x6301U, MapAccess::kConsumer);
    AddBits(0x6302U, MapAccess::kConsumer);
    AddBits(0x6303U, MapAccess::kConsumer);
    AddRange(0x6304U, kMaxPayloadBits, 1U, MapAccess::kConsumer);
    AddRange(0x6305U, kMaxPayloadBits, 1U, MapAccess::kConsumer);
    AddSizes(0x6400U, MapAccess::kProducer);
    AddSizes(0x6401U, MapAccess::kProducer);
    AddBits(0x6402U, MapAccess::kProducer);
    AddBits(0x6403U, MapAccess::kProducer);
    AddRange(0x6404U, kMaxPayloadBits, 1U, MapAccess::kProducer);
    AddRange(0x6405U, kMaxPayloadBits, 1U, MapAccess::kProducer);
    AddRange(0x6621U, 8U, 8U, MapAccess::kProducer);
    AddRange(0x6623U, 8U, 8U, MapAccess::kProducer);
    AddRange(0x6631U, 8U, 8U, MapAccess::kConsumer);
    AddRange(0x6633U, 8U, 8U, MapAccess::kConsumer);
    Add(0x6700U, 0U, 8U, MapAccess::kNone);
    for (std::uint16_t slot = 0U; slot < kMaxSrdoCount; ++slot)
    {
        AddRange(static_cast<std::uint16_t>(0x7000U + slot), 4U, 32U, MapAccess::kConsumer);
    }
}

void Dictionary::Add(std::uint16_t index, std::uint8_t sub, std::uint8_t bits, MapAccess access) noexcept
{
    const std::uint16_t bytes = BytesOf(bits);
    if ((count_ < kObjectCount) && (used_ + bytes <= kPlaceBytes))
    {
        objects_[count_] = MappableObject{index, sub, bits, access, &places_[used_]};
        used_ = static_cast<std::uint16_t>(used_ + bytes);
        ++count_;
    }
}

void Dictionary::AddRange(std::uint16_t index, std::uint8_t last_sub, std::uint8_t bits, MapAccess access) noexcept
{
    for (std::uint8_t sub = 1U; sub <= last_sub; ++sub)
    {
        Add(index, sub, bits, access);
    }
}

void Dictionary::AddSizes(std::uint16_t index, MapAccess access) noexcept
{
    for (std::uint8_t sub = 1U; sub <= 8U; ++sub)
    {
        Add(index, sub, static_cast<std::uint8_t>(8U * sub), access);
    }
}

void Dictionary::AddBits(std::uint16_t index, MapAccess access) noexcept
{
    static constexpr std::uint8_t kLengths[] = {1U,  2U,  3U,  4U,  5U,  7U,  9U,  12U, 13U,
                                                16U, 20U, 31U, 32U, 33U, 60U, 62U, 63U, 64U};
    for (const std::uint8_t bits : kLengths)
    {
        Add(index, bits, bits, access);
    }
}

void Dictionary::Fill(std::uint8_t fill) noexcept
{
    for (std::uint8_t& byte : places_)
    {
        byte = fill;
    }
    std::uint16_t used = 0U;
    for (std::uint16_t i = 0U; i < count_; ++i)
    {
        objects_[i].place = &places_[used];
        used = static_cast<std::uint16_t>(used + BytesOf(objects_[i].length_bits));
    }
}

void Dictionary::Share(std::uint16_t index, std::uint8_t sub, std::uint16_t other_index,
                       std::uint8_t other_sub) noexcept
{
    std::uint8_t* const place = Place(other_index, other_sub);
    for (std::uint16_t i = 0U; i < count_; ++i)
    {
        const bool is_it = (objects_[i].index == index) && (objects_[i].sub == sub);
        if (is_it && (place != nullptr))
        {
            objects_[i].place = place;
        }
    }
}

const MappableObject* Dictionary::Find(std::uint16_t index, std::uint8_t sub) const noexcept
{
    for (std::uint16_t i = 0U; i < count_; ++i)
    {
        if ((objects_[i].index == index) && (objects_[i].sub == sub))
        {
            return &objects_[i];
        }
    }
    return nullptr;
}

void Dictionary::Put(std::uint16_t index, std::uint8_t sub, const ObjectValue& value) noexcept
{
    const MappableObject* const object = Find(index, sub);
    if (object == nullptr)
    {
        return;
    }
    for (std::uint32_t i = 0U; i < BytesOf(object->length_bits); ++i)
    {
        const std::uint32_t half = (i < 4U) ? value.low : value.high;
        object->place[i] = static_cast<std::uint8_t>((half >> (8U * (i % 4U))) & 0xFFU);
    }
}

ObjectValue Dictionary::Get(std::uint16_t index, std::uint8_t sub) const noexcept
{
    ObjectValue value{0U, 0U};
    const MappableObject* const object = Find(index, sub);
    if (object == nullptr)
    {
        return value;
    }
    for (std::uint32_t i = 0U; i < BytesOf(object->length_bits); ++i)
    {
        std::uint32_t& half = (i < 4U) ? value.low : value.high;
        half |= static_cast<std::uint32_t>(object->place[i]) << (8U * (i % 4U));
    }
    return value;
}

std::uint8_t Dictionary::Bytes(std::uint16_t index, std::uint8_t sub) const noexcept
{
    const MappableObject* const object = Find(index, sub);
    return (object == nullptr) ? std::uint8_t{0U} : BytesOf(object->length_bits);
}

std::uint8_t* Dictionary::Place(std::uint16_t index, std::uint8_t sub) const noexcept
{
    const MappableObject* const object = Find(index, sub);
    return (object == nullptr) ? nullptr : object->place;
}

std::uint32_t Dictionary::Digest() const noexcept
{
    Hash hash;
    for (std::uint16_t i = 0U; i < used_; ++i)
    {
        hash.Add(places_[i]);
    }
    return hash.Value();
}

} // namespace counterpoint::conformance
