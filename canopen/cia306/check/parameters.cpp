// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia306/check/rules.hpp"
#include "canopen/cia306/safety/digest.hpp"

#include <algorithm>

namespace counterpoint::cia306
{
namespace
{
constexpr std::uint32_t kShortestCycleUs = 100U;
constexpr std::uint32_t kLongestCycleUs = 1000000U;
constexpr std::uint64_t kUsPerMs = 1000U;
constexpr std::uint64_t kClockCycles = 4U;      ///< Cycles that the kernel needs in an interval of the clock tolerance.
constexpr std::uint64_t kComparatorTests = 15U; ///< Cycles that the kernel needs in a test interval.
constexpr std::uint64_t kDiscrepancyCycles = 2U; ///< By which the pairs of the channels may be apart without a fault.
constexpr std::uint8_t kPorts = 2U;

/// Rules of the objects 5F00h to 5F05h.
class ParameterCheck
{
  public:
    ParameterCheck(const CheckContext& context, Findings& findings) noexcept
        : context_(context), own_(context.parameters), findings_(findings)
    {
    }

    void CheckTimes();
    void CheckForm();
    void CheckGaps();
    void CheckGfc();
    void CheckSrdo(const SrdoConfiguration& srdo);

  private:
    [[nodiscard]] Place PlaceOf(const std::uint16_t index, const std::uint8_t sub) const
    {
        const Entry* const entry = context_.device.Find(index, sub);
        return entry == nullptr ? Place{1U, 1U} : entry->ValuePlace();
    }

    void Require(const bool holds, const std::uint8_t sub, const std::string& wrong, const std::string& expected)
    {
        if (!holds)
        {
            findings_.Error(PlaceOf(kDeviceParametersIndex, sub), ObjectName(kDeviceParametersIndex, sub), wrong,
                            expected);
        }
    }

    void RequireTime(const std::uint8_t sub, const std::string& name, const std::uint32_t time_us)
    {
        Require(time_us <= kLongestUs, sub, name + " of " + std::to_string(time_us) + " us",
                "at most " + std::to_string(kLongestUs) + " us");
    }

    void RequireEither(const std::uint8_t sub, const std::string& name, const std::uint8_t value,
                       const std::uint8_t granted)
    {
        Require(value == 0U || value == granted, sub, name + " " + Hex(value, 2), "0x00 or " + Hex(granted, 2));
    }

    void RequirePort(const std::uint8_t sub, const std::string& frames, const std::uint8_t port)
    {
        Require(port != 0U && port <= kPorts, sub,
                "controller " + std::to_string(port) + " of the " + frames + " frames", "1 or 2");
    }

    /// The kernel takes less, and a device may go to its safe state when nothing is wrong. [SRS_CLI_400]
    void WarnDiscrepancy(const std::uint64_t least_us)
    {
        if (!context_.configuration.srdos.empty() && own_.discrepancy_us < least_us)
        {
            findings_.Warning(
                PlaceOf(kDeviceParametersIndex, 3U), ObjectName(kDeviceParametersIndex, 3U),
                "discrepancy time of " + std::to_string(own_.discrepancy_us) + " us",
                "at least " + std::to_string(least_us) +
                    " us, 2 cycles with their tolerance, or late cycles may end in the device safe state");
        }
    }

    void WarnSrdo(const std::uint16_t index, const std::uint8_t number, const std::string& wrong,
                  const std::string& expected)
    {
        findings_.Warning(PlaceOf(index, number), ObjectName(index, number), wrong, expected);
    }

    const CheckContext& context_;
    const DeviceParameters& own_;
    Findings& findings_;
};

void ParameterCheck::CheckTimes()
{
    const bool is_cycle = own_.cycle_us >= kShortestCycleUs && own_.cycle_us <= kLongestCycleUs;
    Require(is_cycle, 1U, "cycle time " + std::to_string(own_.cycle_us) + " us", "100 us to 1000000 us");
    Require(own_.cycle_tolerance_us <= own_.cycle_us, 2U,
            "cycle tolerance of " + std::to_string(own_.cycle_tolerance_us) + " us",
            "at most the cycle time of " + std::to_string(own_.cycle_us) + " us");
    RequireTime(3U, "discrepancy time", own_.discrepancy_us);
    RequireTime(7U, "clock tolerance interval", own_.clock_tolerance_interval_us);
    RequireTime(8U, "output time", own_.output_us);
    RequireTime(9U, "acknowledge window", own_.acknowledge_window_us);
    Require(own_.clock_tolerance_us < own_.clock_tolerance_interval_us, 6U,
            "clock tolerance of " + std::to_string(own_.clock_tolerance_us) + " us",
            "less than its interval of " + std::to_string(own_.clock_tolerance_interval_us) + " us (0x5F00:07)");
    if (!is_cycle)
    {
        return; // Nothing can be said about what is counted in cycles.
    }
    const std::uint64_t late_us = std::uint64_t{own_.cycle_us} + own_.cycle_tolerance_us;
    const std::uint64_t steps_us = 2U * context_.configuration.srdos.size() * late_us;
    Require(own_.diagnostic_interval_ms * kUsPerMs >= steps_us, 4U,
            "diagnostic interval of " + std::to_string(own_.diagnostic_interval_ms) + " ms",
            "at least " + std::to_string(steps_us) + " us, 2 cycles with their tolerance for each SRDO");
    const std::uint64_t round_us = kComparatorTests * late_us;
    Require(own_.test_interval_ms * kUsPerMs >= round_us, 5U,
            "test interval of " + std::to_string(own_.test_interval_ms) + " ms",
            "at least " + std::to_string(round_us) + " us, 15 cycles with their tolerance");
    const std::uint64_t clock_us = kClockCycles * late_us;
    Require(own_.clock_tolerance_interval_us >= clock_us, 7U,
            "clock tolerance interval of " + std::to_string(own_.clock_tolerance_interval_us) + " us",
            "at least " + std::to_string(clock_us) + " us, 4 cycles with their tolerance");
    WarnDiscrepancy(kDiscrepancyCycles * late_us);
}

void ParameterCheck::CheckForm()
{
    Require(IsGranularity(own_.granularity_bits), kGranularitySub,
            "granularity of " + std::to_string(own_.granularity_bits) + " bit", "1, 8, 16, 32 or 64 bit");
    const bool is_room = own_.map_entries <= kMaxMappingEntries && (own_.map_entries & 1U) == 0U;
    Require(is_room, kMapEntriesSub, "room for " + std::to_string(own_.map_entries) + " mapping entries",
            "an even number from 0 to 128");
    RequireEither(kDummyMappingSub, "dummy mapping", own_.dummy_mapping, kDummiesAllowed);
    RequireEither(kNumberGapsSub, "gaps between SRDO numbers", own_.number_gaps, kGapsSearched);
    RequireEither(kGfcUseSub, "use of the GFC", own_.gfc_use, kGfcPresent);
    RequirePort(kNormalPortSub, "normal", own_.normal_port);
    RequirePort(kInversePortSub, "inverse", own_.inverse_port);
}

void ParameterCheck::CheckGaps()
{
    std::uint8_t expected = 1U;
    for (const SrdoConfiguration& srdo : context_.configuration.srdos)
    {
        const bool is_gap = own_.number_gaps != kGapsSearched && srdo.number != expected;
        if (is_gap)
        {
            findings_.Error(srdo.place, Hex(srdo.CommunicationIndex(), 4),
                            "SRDO " + std::to_string(srdo.number) + " in a device without gaps",
                            "SRDO " + std::to_string(expected) + " before it, or 0x99 in " +
                                ObjectName(kDeviceParametersIndex, kNumberGapsSub));
            return;
        }
        ++expected;
    }
}

void ParameterCheck::CheckGfc()
{
    const bool has_object = context_.device.Find(kGfcIndex) != nullptr;
    const bool has_use = own_.gfc_use == kGfcPresent;
    Require(has_object || !has_use, kGfcUseSub, "the GFC is used and there is no 0x1300", "0x00, or the object 0x1300");
    Require(!has_object || has_use, kGfcUseSub, "the GFC is removed and there is 0x1300", "0x5A, or no object 0x1300");
}

void ParameterCheck::CheckSrdo(const SrdoConfiguration& srdo)
{
    const SrdoParameters& own = own_.Srdo(srdo.number);
    const bool is_known_policy = own.release_policy == 0U || own.release_policy == kAutomaticRelease;
    if (!is_known_policy)
    {
        WarnSrdo(kReleasePolicyIndex, srdo.number,
                 "release policy " + Hex(own.release_policy, 2) + " is taken for the restart interlock",
                 "0x00 (restart interlock) or 0x5A (automatic)");
    }
    if (own.producer_form > kProviderCalled)
    {
        WarnSrdo(kProducerFormIndex, srdo.number, "producer form " + std::to_string(own.producer_form),
                 "0 (the application sends) or 1 (provider)");
    }
    const bool is_known_detection = own.srvt_detection == 0U || own.srvt_detection == kLateDetection;
    if (!is_known_detection)
    {
        WarnSrdo(kDetectionIndex, srdo.number,
                 "SRVT detection " + Hex(own.srvt_detection, 2) + " is taken for the early one",
                 "0x00 (early) or 0x3C (late)");
    }
    std::uint32_t bits = 0U;
    for (const MappingEntry& entry : srdo.mapping)
    {
        bits += entry.IsNormal() ? entry.Bits() : 0U;
    }
    const bool has_more = bits < 64U && (own.safe_value >> bits) != 0U;
    if (has_more)
    {
        WarnSrdo(kSafeValueIndex, srdo.number, "safe value " + Hex(own.safe_value, 2),
                 "no bit above the " + std::to_string(bits) + " mapped bits");
    }
}

/// Without a digest nothing binds what 13FFh does not cover; that matters from the first SRDO that is on.
void WarnOfNoDigest(const CheckContext& context, const DigestRecord& record, Findings& findings)
{
    const auto& srdos = context.configuration.srdos;
    const auto on = std::find_if(srdos.begin(), srdos.end(), [](const SrdoConfiguration& srdo) { return srdo.IsOn(); });
    const bool is_told = findings.HasErrorAt(record.stored.place, DigestName());
    if (on == srdos.end() || is_told)
    {
        return;
    }
    const std::string unbound = "; a wrong device parameter, 0x1300 included, is not found";
    if (record.is_present)
    {
        findings.Warning(record.stored.place, DigestName(), "no device digest" + unbound,
                         "the one that 'counterpoint sign' computes");
    }
    else
    {
        findings.Warning(on->place, DigestName(), "is missing" + unbound,
                         "an object of type UNSIGNED32 with the device digest");
    }
}
} // namespace

void CheckTimes(const CheckContext& context, Findings& findings)
{
    ParameterCheck(context, findings).CheckTimes();
}

void CheckParameters(const CheckContext& context, Findings& findings)
{
    ParameterCheck check(context, findings);
    check.CheckTimes();
    check.CheckForm();
    if (context.configuration.srdos.empty())
    {
        return;
    }
    check.CheckGaps();
    check.CheckGfc();
    for (const SrdoConfiguration& srdo : context.configuration.srdos)
    {
        check.CheckSrdo(srdo);
    }
}

void CheckDigest(const CheckContext& context, Findings& findings)
{
    const DigestRecord record = ExtractDigest(context.device, context.configuration, context.node_id);
    const bool has_place = !record.is_present || context.device.Find(kDigestIndex, 0U) != nullptr;
    if (!has_place)
    {
        findings.Error(record.stored.place, DigestName(), "is missing", "an object of type UNSIGNED32");
    }
    const bool is_expected = record.stored.value.value_or(0U) != 0U;
    if (!is_expected)
    {
        WarnOfNoDigest(context, record, findings);
        return;
    }
    if (!context.node_id)
    {
        // The other problems are found where they are.
        findings.Error(record.stored.place, DigestName(), "the digest needs the node-ID and there is none",
                       "--node-id, or NodeID in [DeviceComissioning]");
    }
    else if (record.problems.empty() && !record.stored.Is(DigestOf(record.fields)))
    {
        findings.Error(record.stored.place, DigestName(), "device digest " + Hex(*record.stored.value, 8),
                       Hex(DigestOf(record.fields), 8) + ", computed from the device's parameters");
    }
}
} // namespace counterpoint::cia306
