// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "safety_core/kernel/configuration_image.hpp"

namespace counterpoint
{
namespace
{

constexpr std::uint32_t kPolynomial = 0xEDB88320U; // 04C11DB7h, reflected
constexpr std::uint32_t kStart = 0xFFFFFFFFU;
constexpr std::uint32_t kWordBits = 32U;
constexpr std::uint32_t kBitsPerByte = 8U;

constexpr std::uint32_t kItemsBesideEntries = 8U; // signature, communication 1 to 6, map count
constexpr std::uint32_t kGfcKey = 0x130000U;
constexpr std::uint32_t kCommunicationKey = 0x130000U; // of an SRDO 0
constexpr std::uint32_t kSignatureKey = 0x13FF00U;
// The item of the map count, 138xh sub-index 0, follows that of the last communication parameter.
constexpr std::uint32_t kFromCommunicationToMapping = 0x8000U - (kCommunicationSubs + 1U);
constexpr std::uint32_t kGfcSupported = 1U;

constexpr std::uint32_t kDefaultConsumerSctMs = 50U;
// By the number of the field: SCT 25 ms, SRVT 20 ms, transmission type 254, all others 0. MISRA D-001
constexpr std::uint8_t kDefaults[] = {0U, 0U, 25U, 20U, kTransmissionTypeAsynchronous, 0U, 0U, 0U, 0U, 0U, 0U, 0U};

constexpr std::uint8_t kLastProducerNode = 32U;
constexpr std::uint8_t kLastDefaultNode = 64U;
constexpr std::uint32_t kDefaultCobId1Base = 0xFFU;

// One more word, low byte first.
std::uint32_t Continue(const std::uint32_t crc, const std::uint32_t word) noexcept
{
    std::uint32_t rest = crc ^ word;
    for (std::uint32_t bit = 0U; bit < kWordBits; ++bit)
    {
        rest = (rest >> 1U) ^ (kPolynomial & (0U - (rest & 1U)));
    }
    return rest;
}

// Bits that a value of this object may have.
std::uint32_t WidthOf(const ObjectPlace& place) noexcept
{
    const std::uint32_t all = ~std::uint32_t{0U} >> (kWordBits - (kBitsPerByte * place.size_bytes));
    return (place.item.address.field == ConfigField::kGfcParameter) ? kGfcSupported : all;
}

} // namespace

Connection DefaultConnection(const NodeId node_id) noexcept
{
    // 0 - 1 is the greatest value.
    if ((node_id.value - 1U) >= kLastDefaultNode)
    {
        return Connection{0U, 0U, kDirectionOff};
    }
    const std::uint32_t first = kDefaultCobId1Base + (2U * node_id.value);
    const std::uint8_t direction = (node_id.value <= kLastProducerNode) ? kDirectionProducer : kDirectionConsumer;
    return Connection{static_cast<std::uint16_t>(first), static_cast<std::uint16_t>(first + 1U), direction};
}

std::uint32_t ConfigurationImage::ItemCount() const noexcept
{
    return (guard_.Config().srdo_count * (kItemsBesideEntries + guard_.Config().map_entries)) + 1U;
}

// place in a slot   0        1 to 6       7             8 ...
//                   13FFh    130xh sub    138xh sub 0   sub 1 ...       behind the last slot: 1300h
ObjectKey ConfigurationImage::KeyAt(const std::uint32_t number) const noexcept
{
    const std::uint32_t items = kItemsBesideEntries + guard_.Config().map_entries;
    const std::uint32_t slot = number / items;
    const std::uint32_t place = number - (slot * items);
    std::uint32_t key = kGfcKey;
    if (slot < guard_.Config().srdo_count)
    {
        const std::uint32_t srdo = guard_.Config().srdos[slot].number; // MISRA D-002
        key = kCommunicationKey + (srdo << kBitsPerByte) + place;
        if (place > kCommunicationSubs)
        {
            key += kFromCommunicationToMapping;
        }
        if (place == 0U)
        {
            key = kSignatureKey + srdo;
        }
    }
    return ObjectKey{key};
}

// [SRS_KRN_030]
Result ConfigurationImage::FindItem(const std::uint32_t number) const noexcept
{
    if (guard_.Nmt() == NmtState::kInvalid)
    {
        return Result::kDeviceFault;
    }
    return (number < ItemCount()) ? Result::kSuccessful : Result::kNotExist;
}

ItemReply ConfigurationImage::ReadItem(const std::uint32_t number) const noexcept
{
    const Result found = FindItem(number);
    if (found != Result::kSuccessful)
    {
        return ItemReply{found, 0U};
    }
    const ObjectReading reading = guard_.Read(KeyAt(number));
    const bool is_general = reading.abort == AbortCode::kGeneral;
    return ItemReply{is_general ? Result::kDeviceFault : Result::kSuccessful, ToValue(reading.data)};
}

HeaderReply ConfigurationImage::HeaderWith(const std::uint8_t valid) const noexcept
{
    HeaderReply reply{Result::kSuccessful, ImageHeader{ItemCount(), kStart, valid}};
    std::uint32_t crc = kStart;
    for (std::uint32_t number = 0U; number < reply.header.count; ++number)
    {
        const ItemReply item = ReadItem(number);
        crc = Continue(crc, KeyAt(number).value);
        crc = Continue(crc, item.value);
        if (item.result != Result::kSuccessful)
        {
            reply.result = item.result;
        }
    }
    reply.header.crc = ~Continue(crc, valid);
    return reply;
}

Result ConfigurationImage::LoadItem(const std::uint32_t number, const std::uint32_t value) const noexcept
{
    const Result found = FindItem(number);
    const Result readiness = (found == Result::kSuccessful) ? guard_.Changeable() : found;
    if (readiness != Result::kSuccessful)
    {
        return readiness;
    }
    ObjectPlace place = Locate(guard_.Config(), KeyAt(number));
    if (place.kind != ObjectKind::kConfiguration)
    {
        return Result::kSuccessful; // The CRC tells whether the program has the same.
    }
    if ((value & ~WidthOf(place)) != 0U)
    {
        return Result::kDamagedImage;
    }
    guard_.Invalidate();
    place.item.value = value;
    guard_.Store(place.item);
    return Result::kSuccessful;
}

Result ConfigurationImage::Load(const ImageHeader& header) const noexcept
{
    Result result = guard_.Changeable();
    if (result != Result::kSuccessful)
    {
        return result;
    }
    guard_.Invalidate();
    const HeaderReply held = HeaderWith(header.valid);
    result = held.result;
    if (header.crc != held.header.crc)
    {
        result = Result::kDamagedImage;
    }
    if (header.count != held.header.count)
    {
        result = Result::kForeignImage;
    }
    if ((result == Result::kSuccessful) && (header.valid == kConfigurationValidValue))
    {
        result = guard_.Declare();
    }
    if (result != Result::kSuccessful)
    {
        (void)RestoreDefaults();
    }
    return result;
}

std::uint32_t ConfigurationImage::DefaultOf(const ConfigAddress& address) const noexcept
{
    const DeviceConfig& config = guard_.Config();
    const bool is_first = config.srdos[address.slot].number == 1U; // MISRA D-002
    const NodeId node{is_first ? config.node_id : 0U};
    const Connection own = DefaultConnection(node);
    if (address.field == ConfigField::kCobId1)
    {
        return own.cob_id_1;
    }
    if (address.field == ConfigField::kCobId2)
    {
        return own.cob_id_2;
    }
    if ((address.field == ConfigField::kSct) && (own.direction == kDirectionConsumer))
    {
        return kDefaultConsumerSctMs;
    }
    return kDefaults[static_cast<std::uint8_t>(address.field)]; // MISRA D-002
}

Result ConfigurationImage::RestoreDefaults() const noexcept
{
    const Result readiness = guard_.Changeable();
    if (readiness == Result::kSuccessful)
    {
        guard_.Invalidate();
        for (std::uint32_t number = 0U; number < ItemCount(); ++number)
        {
            ObjectPlace place = Locate(guard_.Config(), KeyAt(number));
            if (place.kind == ObjectKind::kConfiguration)
            {
                place.item.value = DefaultOf(place.item.address);
                guard_.Store(place.item);
            }
        }
    }
    return readiness;
}

} // namespace counterpoint
