// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_NETWORK_PLAN_CONCISE_MAKER_HPP
#define CANOPEN_NETWORK_PLAN_CONCISE_MAKER_HPP

#include "canopen/cia306/file/device.hpp"

#include <cstdint>
#include <vector>

namespace counterpoint::network_plan
{
/// One entry of a concise DCF.
struct ConciseEntry
{
    std::uint16_t index{0U};
    std::uint8_t sub{0U};
    std::vector<std::uint8_t> value;
};

/// @brief What has to be written to a device that has its defaults: every writable entry with a ParameterValue, but
/// for the objects of the safety configuration and those that command something; PDOs in the order of CiA 301 (off,
/// parameters, mapping off, mapping, on); 1020h at the end. Throws cia306::InputError. [SRS_NET_003]
[[nodiscard]] std::vector<ConciseEntry> MakeConcise(const cia306::Device& device, std::uint8_t node_id);

/// @brief The entries as the bytes of 1F22h.
[[nodiscard]] std::vector<std::uint8_t> ConciseBytes(const std::vector<ConciseEntry>& entries);

/// @brief The configured value as it goes over the bus. Throws cia306::InputError.
[[nodiscard]] std::vector<std::uint8_t> BytesOf(const cia306::Device& device, const cia306::Entry& entry,
                                                std::uint8_t node_id);

/// @brief The configured number of an entry, `usual` where there is none. Throws cia306::InputError.
[[nodiscard]] std::uint32_t NumberOf(const cia306::Device& device, std::uint8_t node_id, std::uint16_t index,
                                     std::uint8_t sub, std::uint32_t usual);
} // namespace counterpoint::network_plan

#endif // CANOPEN_NETWORK_PLAN_CONCISE_MAKER_HPP
