// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/proof/signature.hpp"

namespace counterpoint::proof
{

namespace
{
constexpr SlotIndex kSlot = 1U;
constexpr std::uint32_t kPlaces = 32U;
constexpr std::uint32_t kStep = 8U;
constexpr std::uint32_t kByteValues = 256U;
/// Of SRDO 2 behind direction, SCT and SRVT: COB-ID 1 and 2, count, two entries. [SRS_CFG_010]
constexpr std::uint8_t kRest[] = {0x11U, 1U, 0U, 0U, 0x12U, 1U, 0U, 0U, 2U,         // identifiers and count
                                  1U,    8U, 1U, 0U, 0x22U, 2U, 8U, 1U, 1U, 0x22U}; // entries
/// Of SRDO 2: number, policy, form, detection, transmission type, safe value. [SRS_CFG_348]
constexpr std::uint8_t kDigested[] = {2U,    0x5AU, 0U,    0x3CU, 254U,  0x78U, 0x56U,
                                      0x34U, 0x12U, 0xEFU, 0xCDU, 0xABU, 0x89U};
} // namespace

SignatureRig::SignatureRig(Channel& channel) : channel_{channel}
{
    srdos_[0].number = 1U;
    srdos_[1].number = 2U;
    srdos_[1].policy = ReleasePolicy::kAutomatic;
    srdos_[1].detection = SrvtDetection::kLate;
    srdos_[1].safe_value = Payload{0x12345678U, 0x89ABCDEFU};
    objects_[0] = MappableObject{0x2200U, 1U, 8U, MapAccess::kConsumer, &bytes_[0]};
    objects_[1] = MappableObject{0x2201U, 1U, 8U, MapAccess::kConsumer, &bytes_[1]};
    config_.srdos = &srdos_[0];
    config_.objects = &objects_[0];
    config_.object_count = 2U;
    config_.srdo_count = 2U;
    config_.node_id = 1U;
    config_.granularity_bits = 8U;
    config_.map_entries = 2U;
    config_.normal_port = CanPortId::kFirst;
    config_.inverse_port = CanPortId::kFirst;
    config_.cycle_us = 1000U;
    channel_.Restart(config_);
    Store(ConfigField::kDirection, kDirectionConsumer, 0U);
    Store(ConfigField::kTransmissionType, kTransmissionTypeAsynchronous, 0U);
    Store(ConfigField::kCobId1, 0x111U, 0U);
    Store(ConfigField::kCobId2, 0x112U, 0U);
    Store(ConfigField::kMapCount, 2U, 0U);
    Store(ConfigField::kMapEntry, 0x22000108U, 1U);
    Store(ConfigField::kMapEntry, 0x22010108U, 2U);
}

void SignatureRig::Store(const ConfigField field, const std::uint32_t value, const std::uint8_t sub)
{
    channel_.Store(ConfigItem{ConfigAddress{kSlot, field, sub}, value});
}

Shown SignatureRig::ProveSignature(const std::uint32_t srvts)
{
    Shown shown;
    for (std::uint32_t sct = 0U; (sct <= 0xFFFFU) && shown.refused.empty(); ++sct)
    {
        Store(ConfigField::kSct, sct, 0U);
        std::uint16_t before = Divided16(0U, kDirectionConsumer);
        before = Divided16(before, static_cast<std::uint8_t>(sct % kByteValues));
        before = Divided16(before, static_cast<std::uint8_t>(sct / kByteValues));
        for (std::uint32_t srvt = 0U; srvt < srvts; ++srvt)
        {
            Store(ConfigField::kSrvt, srvt, 0U);
            std::uint16_t right = Divided16(before, static_cast<std::uint8_t>(srvt));
            for (const std::uint8_t byte : kRest)
            {
                right = Divided16(right, byte);
            }
            const std::uint16_t found = channel_.Validate(kSlot).signature;
            ++shown.steps;
            if (found != right)
            {
                shown.refused = WrongStep("signature, state behind SCT", before, srvt, found, right);
                break;
            }
        }
    }
    return shown;
}

void SignatureRig::CompareDigest(Shown& shown, const std::uint32_t before)
{
    std::uint32_t right = ~before;
    for (const std::uint8_t byte : kDigested)
    {
        right = Divided32(right, byte);
    }
    const std::uint32_t found = channel_.Digest(kSlot, DeviceDigest{before}).value;
    ++shown.steps;
    if ((found != ~right) && shown.refused.empty())
    {
        shown.refused = WrongStep("digest", before, 0U, found, ~right);
    }
}

Shown SignatureRig::ProveDigest(const std::uint32_t draws)
{
    Shown shown;
    for (std::uint32_t place = 0U; place < kPlaces; place += kStep)
    {
        for (std::uint32_t byte = 0U; byte < kByteValues; ++byte)
        {
            CompareDigest(shown, byte << place);
        }
    }
    std::uint64_t drawn = 1U;
    for (std::uint32_t draw = 0U; draw < draws; ++draw)
    {
        drawn = (drawn * 6364136223846793005U) + 1442695040888963407U;
        CompareDigest(shown, static_cast<std::uint32_t>(drawn >> 32U));
    }
    return shown;
}

} // namespace counterpoint::proof
