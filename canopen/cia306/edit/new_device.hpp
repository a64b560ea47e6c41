// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_CIA306_EDIT_NEW_DEVICE_HPP
#define CANOPEN_CIA306_EDIT_NEW_DEVICE_HPP

#include "canopen/cia306/edit/srdo_plan.hpp"
#include "canopen/cia306/text/ini_document.hpp"

#include <array>
#include <cstdint>
#include <ctime>
#include <string>
#include <vector>

namespace counterpoint::cia306
{
/// The bit rates that CiA 306 knows, in kbit/s.
constexpr std::array<std::uint16_t, 8U> kBitRates{10U, 20U, 50U, 125U, 250U, 500U, 800U, 1000U};

/// A device that is to be described. Texts are one line each.
struct DevicePlan
{
    std::string file_name;    ///< Without folder.
    std::uint8_t node_id{1U}; ///< 1 to 127.
    std::string name;
    std::string vendor_name;
    std::uint32_t vendor_id{0U};
    std::uint32_t product_code{0U};
    std::uint16_t bit_rate_kbit{500U}; ///< One of kBitRates.
    bool is_gfc_on{false};             ///< 1300h
    std::time_t created{0};            ///< Told in UTC.
    std::vector<SrdoPlan> srdos;       ///< In the order of their numbers, from 1 on.
};

/// A signed DCF of the device: identity, heartbeat, emergency, its SRDOs, 1300h, 13FEh with A5h, 13FFh, and 5F00h to
/// 5F05h with their defaults. Lines end in LF. Throws InputError where an SRDO cannot be signed. [SRS_NEW_001]
[[nodiscard]] IniDocument NewDevice(const std::string& file, const DevicePlan& plan);
} // namespace counterpoint::cia306

#endif // CANOPEN_CIA306_EDIT_NEW_DEVICE_HPP
