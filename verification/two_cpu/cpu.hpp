// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_TWO_CPU_CPU_HPP
#define VERIFICATION_TWO_CPU_CPU_HPP

#include "canopen/device/device.hpp"
#include "channel_a/channel.hpp"
#include "channel_a/storage.hpp"
#include "channel_b/channel.hpp"
#include "channel_b/storage.hpp"
#include "hal/api/output_gate.hpp"
#include "hal/api/watchdog_timer.hpp"
#include "safety_core/crosslink/peer.hpp"
#include "safety_core/kernel/kernel.hpp"
#include "verification/conformance/forwarding.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace counterpoint::two_cpu
{

/// Everything that both CPUs have alike.
struct Timing
{
    std::uint32_t cycle_us{25'000U};
    std::uint32_t tolerance_us{12'500U}; ///< By which a cycle may be late.
    std::uint32_t timeout_us{300'000U};  ///< Three cycles, two delays, three messages lost in a row in each direction.
    std::uint32_t discrepancy_us{400'000U}; ///< Six cycles, four delays, losses: a producer's way there and back.
    std::uint32_t refresh_us{125'000U};     ///< Of the sensor's pairs; of the own ones the same in milliseconds.
    std::uint16_t sct_ms{400U};
    std::uint8_t srvt_ms{250U};
    std::uint32_t stamp_tolerance_us{50U}; ///< Stamps of one frame on both CPUs.
};

/// A clock of one CPU over true time, with a rate of its own. Stopped, it keeps its reading.
struct CpuClock
{
    std::uint32_t start_us{0U};
    double rate{1.0};
    double stopped_at_us{-1.0};

    [[nodiscard]] Instant At(const double true_us) const
    {
        const double until = ((stopped_at_us >= 0.0) && (true_us > stopped_at_us)) ? stopped_at_us : true_us;
        return Instant{start_us + static_cast<std::uint32_t>(static_cast<std::uint64_t>(until * rate))};
    }
};

/// Stands between own voice and channel, for faults of the channel.
class ChannelTap final : public conformance::Forwarding
{
  public:
    explicit ChannelTap(Channel& inner) noexcept : Forwarding{inner}, inner_{inner}
    {
    }
    void OnFrame(const CanFrame& frame, const Instant stamp) noexcept override
    {
        if (!is_deaf)
        {
            inner_.OnFrame(frame, stamp);
        }
    }
    [[nodiscard]] CycleOutcome OnCycle(const CycleInput& input) noexcept override
    {
        if (!is_frozen)
        {
            last_ = inner_.OnCycle(input);
        }
        return last_;
    }
    [[nodiscard]] HeldPair Held(const SlotIndex slot) const noexcept override
    {
        HeldPair held = inner_.Held(slot);
        held.data.low ^= (held.holds_pair != 0U) ? flip : 0U;
        return held;
    }

    bool is_deaf{false};
    bool is_frozen{false};
    std::uint32_t flip{0U};

  private:
    Channel& inner_;
    CycleOutcome last_{};
};

/// Frames that a CPU sends; the rig takes them from here.
class SendPorts final : public hal::CanPorts
{
  public:
    [[nodiscard]] hal::CanGuarantees Guarantees() const noexcept override
    {
        return hal::CanGuarantees{hal::Guarantee::kGiven, hal::Guarantee::kGiven, hal::Guarantee::kGiven};
    }
    std::vector<CanFrame> sent{};

  private:
    [[nodiscard]] hal::TransmitStatus DoTransmit(const CanFrame& frame) noexcept override
    {
        sent.push_back(frame);
        return hal::TransmitStatus::kAccepted;
    }
};

/// The output stage runs on true time: it is hardware of its own.
class Output final : public hal::SafetyOutput
{
  public:
    [[nodiscard]] std::uint32_t Challenge() noexcept override
    {
        return gate.Challenge();
    }
    void Drive(const hal::PermitSet& permits) noexcept override
    {
        gate.Drive(permits, now);
    }
    hal::OutputGate gate{};
    Instant now{0U};
};

class Guard final : public hal::Watchdog
{
  public:
    [[nodiscard]] hal::WatchdogQuestion Question() noexcept override
    {
        return timer.Question();
    }
    void Answer(const hal::WatchdogAnswer& answer) noexcept override
    {
        timer.Answer(answer, now);
    }
    hal::WatchdogTimer timer{};
    Instant now{0U};
};

/// Both objects of the own pair, a new value every 64 seconds; the same on both CPUs, but for the moment of the change.
class ProcessApplication final : public Application
{
  public:
    [[nodiscard]] RefreshAnswer OnRefresh(CommunicationIndex /*index*/) noexcept override;
    void OnSrdoEvent(CommunicationIndex index) noexcept override;
    void OnSrdoError(CommunicationIndex index, SrdoCause cause) noexcept override;
    void OnConfigurationInvalid(CommunicationIndex /*index*/) noexcept override
    {
    }
    void OnDeviceFault(const DeviceFaultReport& report) noexcept override
    {
        fault = report;
    }

    std::array<std::uint8_t, 2U> tx_normal{};
    std::array<std::uint8_t, 2U> tx_inverse{};
    std::array<std::uint8_t, 2U> rx_normal{};
    std::array<std::uint8_t, 2U> rx_inverse{};
    std::uint16_t process{0U};
    std::uint16_t offset{0U}; ///< Of this CPU's value from the other's.
    std::uint64_t received{0U};
    std::uint64_t sent{0U};
    std::uint64_t consumer_errors{0U};
    std::uint64_t producer_errors{0U};
    DeviceFaultReport fault{DeviceFault::kNone, kNoSlot, 0U};
};

/// NMT, to all nodes.
inline constexpr CanFrame kStartCommand{0U, FrameKind::kData, CanPortId::kFirst, 2U, {1U, 0U}};

/// One CPU: SRDO 1 consumes 101h/102h (automatic release), SRDO 2 produces 103h/104h by its provider. CPU A sends the
/// boot-up message of both.
class Cpu final : private device::Owner
{
  public:
    Cpu(PeerRole role, const Timing& timing, const CpuClock& clock);

    /// @brief Start and configuration. The only way to fail is a mistake in this program: it throws.
    void PowerOn(double true_us);
    /// @brief A frame of the bus, at its end.
    void OnBus(const CanFrame& frame, bool is_own, double true_us);
    /// @brief What came over the link.
    void OnLink(const hal::LinkFrame& frame, double true_us);
    /// @brief One cycle; the message for the other CPU.
    void Cycle(double true_us, hal::LinkFrame& message);
    /// @brief Whether the consumer's output is open: gate and watchdog.
    [[nodiscard]] bool IsOpen(double true_us);
    [[nodiscard]] DeviceConfig& Config()
    {
        return config_;
    }

    CpuClock clock;
    ProcessApplication application{};
    SendPorts ports{};
    Output output{};
    Guard watchdog{};

  private:
    [[nodiscard]] static LinkConfig LinkOf(PeerRole role, const Timing& timing);
    [[nodiscard]] device::LoadResult OnResetNode() noexcept override;
    [[nodiscard]] device::LoadResult OnResetCommunication() noexcept override;
    void Describe() noexcept;
    void Write(std::uint16_t index, std::uint8_t sub, std::uint32_t value, std::uint8_t size) noexcept;

    Timing timing_;
    channel_a::StorageFor<2U> storage_a_{};
    channel_b::StorageFor<2U> storage_b_{};
    channel_a::Channel channel_a_;
    channel_b::Channel channel_b_;
    std::array<MappableObject, 4U> objects_{};
    std::array<SrdoSetup, 2U> setups_{};
    DeviceConfig config_{};
    bool is_configured_{true}; ///< The kernel took every value.

  public:
    ChannelTap tap;
    Peer peer;
    Kernel kernel;

  private:
    std::array<device::QueuedFrame, 6U> frames_{};
    device::NoServices services_;
    device::Device device_;
};

} // namespace counterpoint::two_cpu

#endif
