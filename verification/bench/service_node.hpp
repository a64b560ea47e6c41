// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_BENCH_SERVICE_NODE_HPP
#define VERIFICATION_BENCH_SERVICE_NODE_HPP

#include "canopen/device/device.hpp"
#include "canopen/device/safety_objects.hpp"
#include "verification/bench/device.hpp"

#include <cstdint>

namespace counterpoint::bench
{

constexpr std::uint8_t kTpdos = 8U;
constexpr std::uint8_t kSupervised = 16U; ///< Nodes 1 to 16.
constexpr std::uint16_t kDomainIndex = 0x3000U;
constexpr std::uint32_t kDomainBytes = 4096U;
constexpr std::uint16_t kSrdoPeriodMs = 25U;
constexpr std::uint16_t kHeartbeatMs = 100U;
constexpr std::uint16_t kTpdoMs = 10U;

/// The device of SRS_BEN_012: 64 consumers, 8 TPDOs (four on SYNC, four on their event timer), heartbeat, 16 supervised
/// nodes, an SDO server with a DOMAIN. Its controller passes every frame on.
class ServiceNode final : public device::Owner
{
  public:
    explicit ServiceNode(hal::CanPorts& can) noexcept;

    [[nodiscard]] device::LoadResult OnResetNode() noexcept override;
    [[nodiscard]] device::LoadResult OnResetCommunication() noexcept override;

    [[nodiscard]] bool Start(Instant now) noexcept;
    void OnFrame(const StampedFrame& frame) noexcept;
    void OnConfirm(const StampedFrame& frame) noexcept;
    /// @brief What the application does before a cycle: values that differ from the last ones.
    void Prepare(Instant now) noexcept;
    void Cycle(Instant now) noexcept;

    [[nodiscard]] bool IsOperational() const noexcept;
    /// @brief Pairs that were released by now.
    [[nodiscard]] std::uint32_t Released() const noexcept;
    /// @brief True while nothing went wrong: no fault, no error of an SRDO, no emergency, nothing refused.
    [[nodiscard]] bool IsWell() const noexcept;

  private:
    static constexpr std::uint32_t kFields = 2U * kTpdos;
    static constexpr std::uint32_t kEntries = kFields + 1U;
    static constexpr std::uint8_t kFieldsEach = 2U;
    static constexpr std::uint32_t kSafetyRoom = (2U * kMaxSrdoCount) + 2U;
    static constexpr std::uint32_t kServiceRoom = 16U;
    static constexpr std::uint8_t kHistory = 8U;

    [[nodiscard]] static cia301::EntryTable Fill(ServiceNode& node) noexcept;
    [[nodiscard]] device::ServiceRooms Rooms() noexcept;
    [[nodiscard]] bool SetTpdo(std::uint8_t place) noexcept;
    void Take(bool good) noexcept;

    bool well_{true};
    std::uint32_t counter_{0U};
    SafetySetup setup_{};
    BenchOutput output_{};
    BenchWatchdog watchdog_{};
    BenchApplication application_{};
    channel_a::StorageFor<kMaxSrdoCount> storage_a_{};
    channel_b::StorageFor<kMaxSrdoCount> storage_b_{};
    channel_a::Channel channel_a_{storage_a_.Handle()};
    channel_b::Channel channel_b_{storage_b_.Handle()};
    std::uint8_t values_[kFields][4]{};
    std::uint8_t domain_[kDomainBytes]{};
    std::uint32_t domain_length_{kDomainBytes};
    std::uint8_t sdo_buffer_[kDomainBytes]{};
    cia301::Entry entries_[kEntries]{};
    cia301::PdoField fields_[kTpdos][kFieldsEach]{};
    cia301::Tpdo tpdos_[kTpdos]{};
    cia301::SupervisedNode supervised_[kSupervised]{};
    device::QueuedFrame safety_frames_[kSafetyRoom]{};
    device::QueuedFrame service_frames_[kServiceRoom]{};
    // From here on in the order of DeviceParts.
    std::uint32_t history_[kHistory]{};
    cia301::EmergencyProducer emergency_{cia301::NodeId{kNodeId}, cia301::ErrorHistory{history_, kHistory}};
    device::KernelWatch watch_{emergency_, application_};
    Kernel kernel_;
    device::SafetyObjects facade_;
    cia301::Dictionary dictionary_;
    device::Services services_;
    device::Device device_;
};

/// Of everything that a node sends, in its order: a replay on another processor sends the same.
class FrameDigest
{
  public:
    void Add(const CanFrame& frame) noexcept;
    [[nodiscard]] std::uint32_t Value() const noexcept;

  private:
    void AddByte(std::uint32_t byte) noexcept;

    std::uint32_t value_{0x811C9DC5U}; // FNV-1a.
};

} // namespace counterpoint::bench

#endif
