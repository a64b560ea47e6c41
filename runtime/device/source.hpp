// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef RUNTIME_DEVICE_SOURCE_HPP
#define RUNTIME_DEVICE_SOURCE_HPP

#include "runtime/device/model.hpp"

#include "canopen/cia306/safety/device_parameters.hpp"
#include "canopen/cia306/safety/safety_configuration.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace counterpoint::runtime
{
/// A mappable variable of the DCF; `object.place` is not set yet.
struct SourceVariable
{
    MappableObject object{};
    std::uint64_t value{0U}; ///< At power-on.
};

/// A mapping that cannot be written. [SRS_SIM_009]
struct StaticMapping
{
    std::uint8_t number{0U};            ///< Of the SRDO.
    std::vector<std::uint32_t> entries; ///< 138xh sub 1 onward.
    std::vector<std::size_t> normal;    ///< Indices into Variables(), in the order of the entries.
    std::vector<std::size_t> inverse;
    cia306::Place place; ///< Where the DCF counts the entries.
};

/// Takes a DCF apart into what DeviceModel needs. Every function may throw cia306::InputError.
class DeviceSource
{
  public:
    /// @brief The device outlives it.
    DeviceSource(const cia306::Device& device, const std::string& file, std::optional<std::uint8_t> node_id,
                 SafetyNeed need);

    /// @brief What the file says about each SRDO.
    [[nodiscard]] std::vector<SrdoModel> Srdos() const;
    /// @brief The setups for the kernel, by number.
    [[nodiscard]] std::vector<SrdoSetup> Setups() const;
    /// @brief The mappable variables, ascending.
    [[nodiscard]] std::vector<SourceVariable> Variables() const;
    /// @brief The mapped pairs of them, normal data on the normal side. [SRS_NODE_550]
    [[nodiscard]] std::vector<VariablePair> Pairs() const;
    /// @brief The static mappings.
    [[nodiscard]] std::vector<StaticMapping> StaticMappings() const;
    /// @brief The values that a configuring master writes, without those of static mappings.
    [[nodiscard]] std::vector<ConfigurationWrite> Writes() const;
    /// @brief The description for the kernel, without pointers and counts. The controller of the normal frames is the
    /// first one whatever number the file gives it. [SRS_SIM_490]
    [[nodiscard]] DeviceConfig Config() const;

  private:
    [[noreturn]] void Refuse(std::uint8_t sub, const cia306::Problem& problem) const;
    void FollowNodeId();
    void RequireTimes() const;
    void RequirePort(std::uint8_t sub, std::uint8_t port) const;
    [[nodiscard]] MapAccess AccessOf(const cia306::Entry& entry) const;
    [[nodiscard]] std::size_t IndexOf(const cia306::MappingEntry& entry,
                                      const std::vector<SourceVariable>& variables) const;
    void AppendVariable(const cia306::Entry& entry, std::vector<SourceVariable>& variables) const;
    static void AppendMapping(const cia306::SrdoConfiguration& srdo, std::vector<ConfigurationWrite>& writes);
    void AppendParameters(const cia306::SrdoConfiguration& srdo, std::vector<ConfigurationWrite>& writes) const;

    const cia306::Device& device_;
    std::string file_;
    std::optional<std::uint8_t> node_id_;
    bool is_plain_{false}; ///< No object of the safety part.
    cia306::SafetyConfiguration safety_;
    cia306::DeviceParameters parameters_;
};
} // namespace counterpoint::runtime

#endif // RUNTIME_DEVICE_SOURCE_HPP
