// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_GENERATE_SAFETY_PART_HPP
#define CANOPEN_GENERATE_SAFETY_PART_HPP

#include "canopen/generate/element.hpp"

#include "canopen/cia306/safety/device_parameters.hpp"
#include "canopen/cia306/safety/safety_configuration.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace counterpoint::generate
{
/// One write of the configuration.
struct SafetySetting
{
    std::uint16_t index{0U};
    std::uint8_t sub{0U};
    std::uint8_t size_bytes{0U};
    std::uint32_t value{0U};
    std::optional<std::uint32_t> node_addend; ///< The value is the node-ID and so much.
    std::vector<std::uint16_t> signatures;    ///< For each node-ID from 1 on, where they differ.
};

/// A mapping that is a part of the program: its variables by their places in the list of elements.
struct StaticPart
{
    std::uint8_t number{0U};
    std::vector<std::uint32_t> entries;
    std::vector<std::size_t> normal;
    std::vector<std::size_t> inverse;
    cia306::Place place;
};

/// The safety configuration of a file. Every call may throw InputError.
class SafetyPart
{
  public:
    /// @brief Reads it; the device is kept by reference.
    SafetyPart(const cia306::Device& device, std::optional<std::uint8_t> node_id);

    /// @brief Its SRDOs, by number.
    [[nodiscard]] const std::vector<cia306::SrdoConfiguration>& Srdos() const noexcept
    {
        return safety_.srdos;
    }
    /// @brief Parameters of the device, 5F00h to 5F05h.
    [[nodiscard]] const cia306::DeviceParameters& Parameters() const noexcept
    {
        return parameters_;
    }
    /// @brief The expected device digest; 0 (none) with another node-ID than that of the file. [SRS_GEN_009]
    [[nodiscard]] std::uint32_t Digest() const noexcept;
    /// @brief kProduced or kConsumed for a variable of the kernel, nothing else for the others. [SRS_GEN_009]
    [[nodiscard]] std::optional<Home> HomeOf(const cia306::Entry& entry) const;
    /// @brief Joins the variables of each pair. [SRS_GEN_013]
    void JoinPairs(std::vector<Element>& elements) const;
    /// @brief Its static mappings.
    [[nodiscard]] std::vector<StaticPart> StaticParts(const std::vector<Element>& elements) const;
    /// @brief In the order in which the kernel takes them, without those of static mappings. [SRS_GEN_011, SRS_GEN_016]
    [[nodiscard]] std::vector<SafetySetting> Settings() const;

    /// @brief Values with $NODEID that some node-IDs give more than their type holds. [SRS_GEN_730]
    [[nodiscard]] std::vector<cia306::Finding> ValuesTooGreat() const;

  private:
    [[nodiscard]] std::vector<SafetySetting> SettingsFor(const cia306::SafetyConfiguration& safety) const;
    [[nodiscard]] std::vector<cia306::Finding> ProblemsWith(std::uint8_t node_id) const;
    void RequireSameMappings(const cia306::SafetyConfiguration& other) const;
    void FollowNodeId(std::vector<SafetySetting>& settings) const;

    const cia306::Device& device_;
    std::optional<std::uint8_t> node_id_;
    cia306::SafetyConfiguration safety_;
    cia306::DeviceParameters parameters_;
};
} // namespace counterpoint::generate

#endif // CANOPEN_GENERATE_SAFETY_PART_HPP
