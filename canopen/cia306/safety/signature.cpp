// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia306/safety/signature.hpp"

#include <boost/crc.hpp>

namespace counterpoint::cia306
{
namespace
{
std::string DirectionName(const std::uint64_t direction)
{
    switch (direction)
    {
    case 0U:
        return "off";
    case 1U:
        return "producer";
    case 2U:
        return "consumer";
    default:
        return "reserved";
    }
}

std::string MappingMeaning(const MappingEntry& entry)
{
    return std::string(entry.IsNormal() ? "normal data " : "inverse data ") + ObjectName(entry.Index(), entry.Sub()) +
           ", " + std::to_string(entry.Bits()) + " bit";
}
} // namespace

std::vector<std::uint8_t> LittleEndian(const std::uint64_t value, const std::uint32_t count)
{
    std::vector<std::uint8_t> bytes;
    for (std::uint32_t place = 0U; place < count; ++place)
    {
        bytes.push_back(static_cast<std::uint8_t>((value >> (8U * place)) & 0xFFU));
    }
    return bytes;
}

std::vector<SignedField> SignedFields(const SrdoConfiguration& srdo)
{
    const std::uint16_t communication = srdo.CommunicationIndex();
    const std::uint16_t mapping = srdo.MappingIndex();
    const std::uint64_t direction = srdo.direction.value.value_or(0U);
    const std::uint64_t sct = srdo.sct_ms.value.value_or(0U);
    const std::uint64_t srvt = srdo.srvt_ms.value.value_or(0U);
    const std::uint64_t cob_id_1 = srdo.cob_id_1.value.value_or(0U);
    const std::uint64_t cob_id_2 = srdo.cob_id_2.value.value_or(0U);
    const std::string sct_name = srdo.IsProducer() ? "refresh time " : "SCT ";
    std::vector<SignedField> fields{
        {ObjectName(communication, 1U),
         "direction " + std::to_string(direction) + " (" + DirectionName(direction) + ")", LittleEndian(direction, 1U)},
        {ObjectName(communication, 2U), sct_name + std::to_string(sct) + " ms", LittleEndian(sct, 2U)},
        {ObjectName(communication, 3U), "SRVT " + std::to_string(srvt) + " ms", LittleEndian(srvt, 1U)},
        {ObjectName(communication, 5U), "COB-ID 1 " + Hex(cob_id_1, 3), LittleEndian(cob_id_1, 4U)},
        {ObjectName(communication, 6U), "COB-ID 2 " + Hex(cob_id_2, 3), LittleEndian(cob_id_2, 4U)},
        {ObjectName(mapping, 0U), std::to_string(srdo.mapping.size()) + " mapping entries",
         LittleEndian(srdo.mapping.size(), 1U)},
    };
    for (const MappingEntry& entry : srdo.mapping)
    {
        const std::string object = ObjectName(mapping, entry.sub);
        fields.push_back({object, "sub-index " + std::to_string(entry.sub), LittleEndian(entry.sub, 1U)});
        fields.push_back({object, MappingMeaning(entry), LittleEndian(entry.raw, 4U)});
    }
    return fields;
}

std::vector<std::uint8_t> BytesOf(const std::vector<SignedField>& fields)
{
    std::vector<std::uint8_t> bytes;
    for (const SignedField& field : fields)
    {
        bytes.insert(bytes.end(), field.bytes.begin(), field.bytes.end());
    }
    return bytes;
}

std::vector<std::uint8_t> CanonicalBytes(const SrdoConfiguration& srdo)
{
    return BytesOf(SignedFields(srdo));
}

std::uint16_t SignatureOf(const std::vector<std::uint8_t>& bytes)
{
    boost::crc_optimal<16U, 0x1021U, 0x0000U, 0x0000U, false, false> crc;
    crc.process_bytes(bytes.data(), bytes.size());
    return static_cast<std::uint16_t>(crc.checksum());
}

std::uint16_t SignatureOf(const SrdoConfiguration& srdo)
{
    return SignatureOf(CanonicalBytes(srdo));
}

std::optional<std::uint16_t> SignatureWithNode(const SrdoConfiguration& of_file, const SrdoConfiguration& of_node)
{
    const bool is_right = of_file.signature_problems.empty() && of_file.signature.Is(SignatureOf(of_file));
    return is_right ? std::optional(SignatureOf(of_node)) : std::nullopt;
}

std::string HexBytes(const std::vector<std::uint8_t>& bytes)
{
    std::string text;
    for (const std::uint8_t byte : bytes)
    {
        text += (text.empty() ? "" : " ") + Hex(byte, 2).substr(2U);
    }
    return text;
}
} // namespace counterpoint::cia306
