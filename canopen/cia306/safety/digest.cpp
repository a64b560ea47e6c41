// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia306/safety/digest.hpp"

#include "canopen/cia306/file/data_type.hpp"

#include <boost/crc.hpp>

namespace counterpoint::cia306
{
namespace
{
constexpr std::uint32_t kUsPerMs = 1000U;

/// The value where it is the one that grants, else 00h: what a device makes of it.
std::uint8_t Either(const std::uint8_t value, const std::uint8_t granted)
{
    return value == granted ? granted : std::uint8_t{0U};
}

class FieldList
{
  public:
    void Add(const std::string& object, const std::string& meaning, const std::uint64_t value,
             const std::uint32_t length_bytes)
    {
        fields_.push_back({object, meaning, LittleEndian(value, length_bytes)});
    }

    void AddDevice(const std::uint8_t sub, const std::string& meaning, const std::uint8_t value)
    {
        Add(ObjectName(kDeviceParametersIndex, sub), meaning + " " + Hex(value, 2), value, 1U);
    }

    void AddTime(const std::uint8_t sub, const std::string& meaning, const std::uint32_t time_us)
    {
        Add(ObjectName(kDeviceParametersIndex, sub), meaning + " " + std::to_string(time_us) + " us", time_us, 4U);
    }

    [[nodiscard]] const std::vector<SignedField>& Fields() const noexcept
    {
        return fields_;
    }

  private:
    std::vector<SignedField> fields_;
};

void AddDeviceFields(const SafetyConfiguration& configuration, const DeviceParameters& own, const std::uint8_t node_id,
                     FieldList& list)
{
    list.Add("", "node-ID " + std::to_string(node_id), node_id, 1U);
    list.Add(ObjectName(kDeviceParametersIndex, kGranularitySub),
             "granularity " + std::to_string(own.granularity_bits) + " bit", own.granularity_bits, 1U);
    list.AddDevice(kDummyMappingSub, "dummy mapping", Either(own.dummy_mapping, kDummiesAllowed));
    list.AddDevice(kNumberGapsSub, "gaps between SRDO numbers", Either(own.number_gaps, kGapsSearched));
    list.AddDevice(kGfcUseSub, "GFC", Either(own.gfc_use, kGfcPresent));
    list.AddDevice(kNormalPortSub, "controller of the normal frames", own.normal_port);
    list.AddDevice(kInversePortSub, "controller of the inverse frames", own.inverse_port);
    list.AddTime(1U, "cycle time", own.cycle_us);
    list.AddTime(2U, "cycle tolerance", own.cycle_tolerance_us);
    list.AddTime(3U, "discrepancy time", own.discrepancy_us);
    list.AddTime(9U, "acknowledge window", own.acknowledge_window_us);
    list.AddTime(4U, "diagnostic interval", own.diagnostic_interval_ms * kUsPerMs);
    list.AddTime(5U, "test interval", own.test_interval_ms * kUsPerMs);
    list.AddTime(6U, "clock tolerance", own.clock_tolerance_us);
    list.AddTime(7U, "clock tolerance interval", own.clock_tolerance_interval_us);
    list.AddTime(8U, "output time", own.output_us);
    const std::uint64_t gfc = configuration.gfc.value.value_or(0U);
    list.Add(ObjectName(kGfcIndex, 0U), "GFC parameter " + std::to_string(gfc), gfc, 1U);
}

void AddSrdoFields(const SrdoConfiguration& srdo, const SrdoParameters& own, FieldList& list)
{
    const std::uint8_t policy = Either(own.release_policy, kAutomaticRelease);
    const std::uint8_t form = Either(own.producer_form, kProviderCalled);
    const std::uint8_t detection = Either(own.srvt_detection, kLateDetection);
    const std::uint64_t type = srdo.transmission_type.value.value_or(0U);
    const std::string safe_value = ObjectName(kSafeValueIndex, srdo.number);
    list.Add(ObjectName(srdo.CommunicationIndex(), 0U), "SRDO " + std::to_string(srdo.number), srdo.number, 1U);
    list.Add(ObjectName(kReleasePolicyIndex, srdo.number), "release policy " + Hex(policy, 2), policy, 1U);
    list.Add(ObjectName(kProducerFormIndex, srdo.number), "producer form " + Hex(form, 2), form, 1U);
    list.Add(ObjectName(kDetectionIndex, srdo.number), "SRVT detection " + Hex(detection, 2), detection, 1U);
    list.Add(ObjectName(srdo.CommunicationIndex(), 4U), "transmission type " + std::to_string(type), type, 1U);
    list.Add(safe_value, "safe value, bytes 0 to 3", own.safe_value & 0xFFFFFFFFU, 4U);
    list.Add(safe_value, "safe value, bytes 4 to 7", own.safe_value >> 32U, 4U);
}
} // namespace

std::vector<SignedField> DigestFields(const SafetyConfiguration& configuration, const DeviceParameters& parameters,
                                      const std::uint8_t node_id)
{
    FieldList list;
    AddDeviceFields(configuration, parameters, node_id, list);
    for (const SrdoConfiguration& srdo : configuration.srdos)
    {
        AddSrdoFields(srdo, parameters.Srdo(srdo.number), list);
    }
    return list.Fields();
}

std::uint32_t DigestOf(const std::vector<SignedField>& fields)
{
    const std::vector<std::uint8_t> bytes = BytesOf(fields);
    boost::crc_32_type crc;
    crc.process_bytes(bytes.data(), bytes.size());
    return static_cast<std::uint32_t>(crc.checksum());
}

std::string DigestName()
{
    return ObjectName(kDigestIndex, 0U);
}

DigestRecord ExtractDigest(const Device& device, const SafetyConfiguration& configuration,
                           const std::optional<std::uint8_t> node_id)
{
    DigestRecord record;
    const Entry* const entry = device.Find(kDigestIndex, 0U);
    record.is_present = device.Find(kDigestIndex) != nullptr && !configuration.srdos.empty();
    if (!record.is_present)
    {
        return record;
    }
    const bool is_read = entry == nullptr || entry->Configured().IsSet();
    record.stored.place = is_read ? Place{} : entry->place;
    if (is_read)
    {
        record.stored = ReadField(device, kDigestIndex, 0U, kUnsigned32, node_id, {}, record.problems);
    }
    // Read once more for their problems: each is one of the digest only if it keeps the digest from being computed.
    if (device.Find(kGfcIndex) != nullptr)
    {
        (void)ReadField(device, kGfcIndex, 0U, kUnsigned8, node_id, {}, record.problems);
    }
    for (const SrdoConfiguration& srdo : configuration.srdos)
    {
        (void)ReadField(device, srdo.CommunicationIndex(), 4U, kUnsigned8, node_id, srdo.place, record.problems);
    }
    std::vector<Finding> parameter_problems;
    const DeviceParameters parameters = ReadDeviceParameters(device, node_id, parameter_problems);
    record.problems.insert(record.problems.end(), parameter_problems.begin(), parameter_problems.end());
    if (!node_id)
    {
        record.problems.push_back({Severity::kError, record.stored.place, DigestName(),
                                   "the digest needs the node-ID and there is none, expected --node-id, or NodeID in "
                                   "[DeviceComissioning]"});
    }
    if (record.problems.empty())
    {
        record.fields = DigestFields(configuration, parameters, *node_id);
    }
    return record;
}
} // namespace counterpoint::cia306
