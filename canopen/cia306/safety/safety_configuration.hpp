// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_CIA306_SAFETY_SAFETY_CONFIGURATION_HPP
#define CANOPEN_CIA306_SAFETY_SAFETY_CONFIGURATION_HPP

#include "canopen/cia306/file/device.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace counterpoint::cia306
{
constexpr std::uint16_t kGfcIndex = 0x1300U;
constexpr std::uint16_t kFirstCommunicationIndex = 0x1301U;
constexpr std::uint16_t kFirstMappingIndex = 0x1381U;
constexpr std::uint16_t kConfigurationValidIndex = 0x13FEU;
constexpr std::uint16_t kSignatureIndex = 0x13FFU;
constexpr std::uint16_t kFirstObjectIndex = 0x0020U; ///< Below are the data types of CiA 301.
constexpr std::uint8_t kMaxSrdos = 64U;
constexpr std::uint8_t kMaxMappingEntries = 128U;
constexpr std::uint8_t kConfigurationIsValid = 0xA5U;

/// A number of the configuration and its place (that of its object, where it is missing).
struct Field
{
    std::optional<std::uint64_t> value;
    Place place;

    /// Whether there is a value and it is this number.
    [[nodiscard]] bool Is(std::uint64_t number) const noexcept
    {
        return value && *value == number;
    }
};

/// One entry of 1381h to 13C0h. Odd sub-indices are normal data, even ones inverse data.
struct MappingEntry
{
    std::uint8_t sub{0U};
    std::uint32_t raw{0U};
    Place place;

    /// Index of the mapped object.
    [[nodiscard]] std::uint16_t Index() const noexcept
    {
        return static_cast<std::uint16_t>(raw >> 16U);
    }
    /// Its sub-index.
    [[nodiscard]] std::uint8_t Sub() const noexcept
    {
        return static_cast<std::uint8_t>((raw >> 8U) & 0xFFU);
    }
    /// Its length in bits.
    [[nodiscard]] std::uint8_t Bits() const noexcept
    {
        return static_cast<std::uint8_t>(raw & 0xFFU);
    }
    /// Whether it names a data type instead of an object: its bits are stored nowhere.
    [[nodiscard]] bool IsDummy() const noexcept
    {
        return Index() != 0U && Index() < kFirstObjectIndex;
    }
    /// Whether it is an entry of the normal data.
    [[nodiscard]] bool IsNormal() const noexcept
    {
        return (sub & 1U) != 0U;
    }
};

/// The configuration of one SRDO as a file has it.
struct SrdoConfiguration
{
    std::uint8_t number{0U}; ///< 1 to 64.
    Place place;             ///< Of its communication parameters.
    Field highest_sub;
    Field direction;
    Field sct_ms;
    Field srvt_ms;
    Field transmission_type;
    Field cob_id_1;
    Field cob_id_2;
    Field entry_count;
    std::vector<MappingEntry> mapping; ///< As many as `entry_count` tells, those that can be read.
    bool is_static{false};             ///< Sub-index 0 and every entry of the mapping are const or ro. [SRS_EDS_029]
    Field signature;                   ///< As the file has it.
    /// What keeps the signature from being computed; empty: every number that goes into it has a value.
    std::vector<Finding> signature_problems;
    std::vector<Finding> other_problems;

    /// Index of its communication parameters, 1301h to 1340h.
    [[nodiscard]] std::uint16_t CommunicationIndex() const noexcept
    {
        return static_cast<std::uint16_t>(kFirstCommunicationIndex + number - 1U);
    }
    /// Index of its mapping, 1381h to 13C0h.
    [[nodiscard]] std::uint16_t MappingIndex() const noexcept
    {
        return static_cast<std::uint16_t>(kFirstMappingIndex + number - 1U);
    }
    /// Whether its direction is 1.
    [[nodiscard]] bool IsProducer() const noexcept
    {
        return direction.Is(1U);
    }
    /// Whether its direction is 2.
    [[nodiscard]] bool IsConsumer() const noexcept
    {
        return direction.Is(2U);
    }
    /// Whether it is a producer or a consumer.
    [[nodiscard]] bool IsOn() const noexcept
    {
        return IsProducer() || IsConsumer();
    }
    /// Whether its mapping names this data element.
    [[nodiscard]] bool Maps(const Entry& entry) const noexcept;
};

/// The safety configuration that a file gives a device. [SRS_EDS_020, SRS_EDS_024]
struct SafetyConfiguration
{
    std::vector<SrdoConfiguration> srdos; ///< Those whose communication parameters exist, by number.
    Field gfc;
    Field configuration_valid;
    Field signature_count;
    std::vector<Finding> missing;  ///< Safety objects that are listed and not described: the file was cut.
    std::vector<Finding> problems; ///< Problems of objects that belong to no SRDO.
    std::vector<Finding> limits;   ///< Values of safety objects outside of their limits.

    /// Whether an SRDO maps this data element.
    [[nodiscard]] bool Maps(const Entry& entry) const noexcept;
    /// Whether a consumer does.
    [[nodiscard]] bool MapsToReceive(const Entry& entry) const noexcept;
};

/// The first object of 1300h to 13FFh that the file describes or lists, and its line; nothing: it has none. A file that
/// has one and no SRDO is no plain device, but one of which a part is missing. [SRS_CLI_033]
[[nodiscard]] std::optional<std::pair<std::uint16_t, Place>> FirstSafetyObject(const Device& device);

/// Reads the safety configuration of a file. Never throws for what the file says: what cannot be used becomes a
/// problem.
[[nodiscard]] SafetyConfiguration ExtractSafety(const Device& device, std::optional<std::uint8_t> node_id);

/// The value at index and sub-index; adds a finding where it is missing, of another data type, or out of range.
/// `place` is used where the object does not exist.
[[nodiscard]] Field ReadField(const Device& device, std::uint16_t index, std::uint8_t sub, std::uint16_t data_type,
                              std::optional<std::uint8_t> node_id, Place place, std::vector<Finding>& problems);

/// Throws an InputError for the first of the problems that is an error; warnings do not count.
void RequireNone(const std::string& file, const std::vector<Finding>& problems);
} // namespace counterpoint::cia306

#endif // CANOPEN_CIA306_SAFETY_SAFETY_CONFIGURATION_HPP
