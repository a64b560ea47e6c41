// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef TESTS_CANOPEN_DEVICE_DEVICE_RIG_HPP
#define TESTS_CANOPEN_DEVICE_DEVICE_RIG_HPP

#include "canopen/device/device.hpp"
#include "canopen/device/safety_objects.hpp"
#include "tests/safety_core/kernel/rig.hpp"

#include <array>
#include <cstdint>
#include <initializer_list>
#include <vector>

namespace counterpoint::device
{

using Octets = std::vector<std::uint8_t>;

/// The device of Rig, whole: its kernel behind a watch, a table of services, every own frame confirmed at once or when
/// the test says so. Node-ID 2, supervises up to two nodes.
class DeviceRig : public Rig, public Owner
{
  public:
    DeviceRig();

    LoadResult OnResetNode() noexcept override;
    LoadResult OnResetCommunication() noexcept override;
    [[nodiscard]] bool IsStoring() const noexcept override
    {
        return is_storing;
    }

    /// PowerOn; must succeed unless the test expects otherwise.
    void Start();
    /// Power on, start command, one cycle.
    void Run();
    void Cycle(SrdoMask acknowledge = 0U);
    void Cycles(std::uint32_t count);
    /// A data frame 10 us after the one before.
    void Frame(std::uint32_t identifier, const Octets& bytes);
    void Remote(std::uint32_t identifier);
    void Command(std::uint8_t command, std::uint8_t node = 2U);
    /// 12h 34h for SRDO 1.
    void Pair();
    /// Everything that was sent and is not confirmed comes back.
    void ConfirmAll();
    /// What was sent with this identifier since the last Forget.
    std::vector<Octets> Sent(std::uint32_t identifier) const;
    /// In which order, but SRDOs, heartbeats and boot-ups.
    std::vector<std::uint32_t> IdentifiersSent() const;
    void Forget();
    /// One expedited write; the abort code, 0 for none.
    std::uint32_t Download(std::uint16_t index, std::uint8_t sub, std::uint32_t value, std::uint8_t size);
    std::uint32_t Upload(std::uint16_t index, std::uint8_t sub);
    /// Emergency codes that were sent.
    std::vector<unsigned> Emergencies() const;
    AbortCode Store(std::uint16_t index, std::uint8_t sub, std::uint32_t value, std::uint8_t size);

    std::array<std::uint8_t, 4> u32{0x44U, 0x33U, 0x22U, 0x11U};
    std::array<std::uint8_t, 4> start_up{};
    std::array<cia301::Entry, 12> entries{};
    std::uint32_t entry_count{11U}; ///< 12: 1F80h is there.
    std::array<cia301::SupervisedNode, 2> supervised{};
    std::array<std::uint8_t, 64> sdo_buffer{};
    std::array<QueuedFrame, 8> safety_frames{};
    std::array<QueuedFrame, 16> service_frames{};

    std::array<std::uint32_t, 8> history{};
    cia301::EmergencyProducer emergency{cia301::NodeId{2U}, cia301::ErrorHistory{history.data(), 8U}};
    KernelWatch watch{emergency, application};
    Kernel core{KernelParts{a, b, ports, output, watchdog, watch}};
    SafetyObjects facade;
    cia301::Dictionary dictionary;
    Services services;
    std::uint32_t safety_room{8U};
    Device device;

    LoadResult node_answer{LoadResult::kLoaded};
    bool is_storing{false};
    bool is_configured{true}; ///< OnResetCommunication declares the configuration valid.
    int node_resets{0};
    int communication_resets{0};
    std::uint16_t stored_heartbeat_ms{0U};
    std::size_t confirmed{0U}; ///< Of ports.sent.
    std::size_t forgotten{0U};

  private:
    cia301::EntryTable FillTable();
};

} // namespace counterpoint::device

#endif
