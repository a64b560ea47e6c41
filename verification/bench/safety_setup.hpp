// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_BENCH_SAFETY_SETUP_HPP
#define VERIFICATION_BENCH_SAFETY_SETUP_HPP

#include "safety_core/kernel/kernel.hpp"

#include <cstdint>

namespace counterpoint::bench
{

constexpr std::uint32_t kCycleUs = 1000U;
/// Above 64 a node has no default identifiers: all SRDOs are off until they are configured.
constexpr std::uint8_t kNodeId = 100U;

enum class DeviceRole : std::uint8_t
{
    kInvalid = 0U,
    kConsumers = 1U,
    kProducers = 2U,
};

/// How the data of each SRDO is mapped: so many objects of so many bits (8, 16 or 32), normal and as many inverse.
struct MapShape
{
    std::uint8_t parts;
    std::uint8_t bits;
};

constexpr MapShape kTwoWords{2U, 32U};

struct DevicePlan
{
    DeviceRole role;
    std::uint8_t srdo_count;
    /// Diagnostic and test interval.
    std::uint32_t interval_us;
    MapShape shape{kTwoWords};
    /// As a rule longer than any item runs: no time-out and no refresh of its own comes in between.
    std::uint16_t sct_ms{60000U};
};

/// A number as an object holds it.
struct ObjectNumber
{
    std::uint32_t value;
    std::uint8_t size_bytes;
};

/// What a measured kernel is told: SRDOs with the mapping of the plan; SRDO n with the identifiers 101h + 2 (n - 1) and
/// the next one. Kept by reference by the kernel.
class SafetySetup
{
  public:
    [[nodiscard]] const DeviceConfig& Describe(const DevicePlan& plan) noexcept;
    /// @brief Writes, signs and declares valid what Describe was told. False if anything was refused.
    [[nodiscard]] bool Configure(Kernel& kernel) const noexcept;
    /// @brief Gives all variables values that are each other's inverse.
    void FillVariables() noexcept;
    [[nodiscard]] std::uint8_t SrdoCount() const noexcept;
    /// @brief Length of a frame of an SRDO.
    [[nodiscard]] std::uint8_t FrameBytes() const noexcept;

  private:
    [[nodiscard]] bool ConfigureSlot(Kernel& kernel, std::uint8_t slot) const noexcept;

    static constexpr std::uint32_t kMostObjects = kUsualMapEntries * kMaxSrdoCount;

    std::uint8_t places_[kMostObjects][4]{};
    MappableObject objects_[kMostObjects]{};
    SrdoSetup setups_[kMaxSrdoCount]{};
    DeviceConfig config_{};
    DevicePlan plan_{};
};

} // namespace counterpoint::bench

#endif
