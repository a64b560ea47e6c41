// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_BENCH_MIX_BUS_HPP
#define VERIFICATION_BENCH_MIX_BUS_HPP

#include "canopen/cia301/sdo/client.hpp"
#include "hal/host/virtual/bus.hpp"
#include "verification/bench/frame_mix.hpp"
#include "verification/bench/service_node.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace counterpoint::bench
{

/// Kinds of frames, as they are told apart in the summary.
enum class MixShare : std::uint8_t
{
    kSrdo = 0U,
    kTpdo = 1U,
    kSdo = 2U,
    kHeartbeat = 3U,
    kSync = 4U,
    kOther = 5U,
    kCount = 6U,
};

/// What was on the bus while it was measured.
struct MixSums
{
    std::array<std::uint64_t, 6> frames{};
    std::array<std::uint64_t, 6> bits{}; ///< With the three bits after each frame.
};

/// The bus that ServiceNode is measured on: its partners, and who writes down what it lives through.
class MixBus final : public host::BusObserver
{
  public:
    MixBus();

    /// @brief Runs everything. False if the node was not well.
    [[nodiscard]] bool Run();
    /// @brief Words of the file, after Run.
    [[nodiscard]] const std::vector<std::uint32_t>& Words() const noexcept;
    [[nodiscard]] const MixSums& Sums() const noexcept;
    /// @brief Bytes that the SDO client wrote by now.
    [[nodiscard]] std::uint64_t Transferred() const noexcept;

    void OnBusRecord(const host::BusRecord& record) override;

  private:
    /// The controller of the node.
    class NodePorts final : public hal::CanPorts, public host::BusListener
    {
      public:
        explicit NodePorts(MixBus& mix);
        [[nodiscard]] hal::CanGuarantees Guarantees() const noexcept override;
        void OnReceived(const CanFrame& frame, host::BusTime at) override;
        void OnConfirmed(const CanFrame& frame, host::BusTime at) override;

        FrameDigest digest{};

      private:
        [[nodiscard]] hal::TransmitStatus DoTransmit(const CanFrame& frame) noexcept override;

        MixBus& mix_;
        host::NodeIndex node_;
    };
    /// A partner: sends when it is told; the SDO client listens, too.
    class Partner final : public host::BusListener, public cia301::FrameSink
    {
      public:
        Partner(MixBus& mix, std::size_t mailboxes);
        [[nodiscard]] bool Send(const CanFrame& frame) noexcept override;
        void OnReceived(const CanFrame& frame, host::BusTime at) override;
        void OnConfirmed(const CanFrame& frame, host::BusTime at) override;

        std::vector<CanFrame> answers{};
        bool is_paced{false}; ///< Sends only while less than the wanted load is on the bus.

      private:
        MixBus& mix_;
        host::NodeIndex node_;
    };

    void Write(MixKind kind, const CanFrame& frame, host::BusTime at);
    void RunPartners(host::BusTime now);
    void SendSrdo(std::uint32_t number);
    void RunClient(host::BusTime now);
    [[nodiscard]] bool IsBelowLoad() const;
    [[nodiscard]] static Instant At(host::BusTime now);

    host::VirtualBus bus_{host::BitRate::k1M};
    std::vector<std::uint32_t> words_{};
    MixSums sums_{};
    std::uint64_t bits_{0U}; ///< Since power-on.
    std::uint64_t transferred_{0U};
    std::uint32_t pairs_{0U};
    bool is_measuring_{false};
    NodePorts ports_{*this};
    Partner producers_{*this, 512U};
    Partner others_{*this, 64U};
    Partner commissioner_{*this, 3U};
    ServiceNode node_{ports_};
    std::vector<std::uint8_t> download_ = std::vector<std::uint8_t>(kDomainBytes);
    cia301::SdoClient client_{cia301::SdoClientParts{commissioner_, cia301::NodeId{kNodeId}, 1000000U, 127U}};
};

} // namespace counterpoint::bench

#endif
