// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_CIA306_DEVICE_PARAMETERS_HPP
#define CANOPEN_CIA306_DEVICE_PARAMETERS_HPP

#include "canopen/cia306/safety_configuration.hpp"

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
constexpr std::uint8_t kAutomaticRelease = 0x5AU;

/// What belongs to one SRDO and is not covered by 13FFh.
struct SrdoParameters
{
    std::uint8_t release_policy{0U}; ///< 5F01h: kAutomaticRelease, everything else is the restart interlock.
    std::uint64_t safe_value{0U};    ///< 5F02h: image of the normal data, first mapped bit lowest.
    std::uint8_t producer_form{0U};  ///< 5F03h: 0 the application sends, 1 a provider is called at each refresh.
};

/// Manufacturer objects 5F00h to 5F03h of a Counterpoint device, with the values where a file has none. [SRS-EDS-023]
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
    std::array<SrdoParameters, kMaxSrdos> srdos{}; ///< SRDO n at n - 1.

    /// `number` from 1 to 64, checked by the caller.
    [[nodiscard]] const SrdoParameters& Srdo(std::uint8_t number) const
    {
        return srdos.at(number - 1U);
    }
};

/// Objects that are not there keep their default; one that is there and cannot be used is added to `problems`.
[[nodiscard]] DeviceParameters ReadDeviceParameters(const Device& device, std::optional<std::uint8_t> node_id,
                                                    std::vector<Finding>& problems);
} // namespace counterpoint::cia306

#endif // CANOPEN_CIA306_DEVICE_PARAMETERS_HPP
