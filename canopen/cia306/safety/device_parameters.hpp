// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_CIA306_SAFETY_DEVICE_PARAMETERS_HPP
#define CANOPEN_CIA306_SAFETY_DEVICE_PARAMETERS_HPP

#include "canopen/cia306/safety/safety_configuration.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace counterpoint::cia306
{
constexpr std::uint16_t kDeviceParametersIndex = 0x5F00U;
constexpr std::uint16_t kReleasePolicyIndex = 0x5F01U;
constexpr std::uint16_t kSafeValueIndex = 0x5F02U;
constexpr std::uint16_t kProducerFormIndex = 0x5F03U;
constexpr std::uint16_t kDigestIndex = 0x5F04U;
constexpr std::uint16_t kDetectionIndex = 0x5F05U;
constexpr std::uint8_t kGranularitySub = 0x0AU;
constexpr std::uint8_t kMapEntriesSub = 0x0BU;
constexpr std::uint8_t kDummyMappingSub = 0x0CU;
constexpr std::uint8_t kNumberGapsSub = 0x0DU;
constexpr std::uint8_t kGfcUseSub = 0x0EU;
constexpr std::uint8_t kNormalPortSub = 0x0FU;
constexpr std::uint8_t kInversePortSub = 0x10U;

constexpr std::uint8_t kAutomaticRelease = 0x5AU;
constexpr std::uint8_t kProviderCalled = 1U;
constexpr std::uint8_t kLateDetection = 0x3CU;
constexpr std::uint8_t kDummiesAllowed = 0x66U;
constexpr std::uint8_t kGapsSearched = 0x99U;
constexpr std::uint8_t kGfcPresent = 0x5AU;
constexpr std::uint8_t kUsualEntries = 16U; ///< 8 normal and 8 inverse objects: all without one shorter than a byte.
constexpr std::uint32_t kLongestUs = 0x3FFFFFFFU;
constexpr std::uint32_t kLongestMs = kLongestUs / 1000U;

/// What belongs to one SRDO and is not covered by 13FFh.
struct SrdoParameters
{
    std::uint8_t release_policy{0U}; ///< 5F01h: kAutomaticRelease, everything else is the restart interlock.
    std::uint64_t safe_value{0U};    ///< 5F02h: image of the normal data, first mapped bit lowest.
    std::uint8_t producer_form{0U};  ///< 5F03h: 0 the application sends, 1 a provider is called at each refresh.
    std::uint8_t srvt_detection{0U}; ///< 5F05h: kLateDetection, everything else is early.
};

/// Manufacturer objects 5F00h to 5F05h of a Counterpoint device, with the values where a file has none. What they mean
/// and their ranges: docs/device_objects.md. [SRS_EDS_023]
struct DeviceParameters
{
    std::uint32_t cycle_us{1000U};
    std::uint32_t cycle_tolerance_us{500U};
    std::uint32_t discrepancy_us{5000U};
    std::uint32_t diagnostic_interval_ms{1000U};
    std::uint32_t test_interval_ms{1000U};
    std::uint32_t clock_tolerance_us{500U};
    std::uint32_t clock_tolerance_interval_us{100000U};
    std::uint32_t output_us{1000U};
    std::uint32_t acknowledge_window_us{1000000U};
    std::uint8_t granularity_bits{8U};       ///< Default: Granularity of DeviceInfo where it is one.
    std::uint8_t map_entries{kUsualEntries}; ///< Default: as many as the greatest mapping has, if those are more.
    std::uint8_t dummy_mapping{0U};          ///< Default: kDummiesAllowed where DummyUsage allows a type.
    std::uint8_t number_gaps{kGapsSearched};
    std::uint8_t gfc_use{0U}; ///< Default: kGfcPresent where 1300h is there.
    std::uint8_t normal_port{1U};
    std::uint8_t inverse_port{1U};
    std::uint32_t digest{0U};                      ///< 5F04h. 0: none is expected.
    std::array<SrdoParameters, kMaxSrdos> srdos{}; ///< SRDO n at n - 1.

    /// Parameters of an SRDO; `number` is 1 to 64, checked by the caller.
    [[nodiscard]] const SrdoParameters& Srdo(std::uint8_t number) const
    {
        return srdos.at(number - 1U);
    }
};

/// Reads 5F00h to 5F05h of a safety device (Device::IsSafetyObject). Objects that the file does not have keep their
/// default; for one that cannot be used a finding is added to `problems`.
[[nodiscard]] DeviceParameters ReadDeviceParameters(const Device& device, std::optional<std::uint8_t> node_id,
                                                    std::vector<Finding>& problems);
} // namespace counterpoint::cia306

#endif // CANOPEN_CIA306_SAFETY_DEVICE_PARAMETERS_HPP
