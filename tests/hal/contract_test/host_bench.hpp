// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef TESTS_HAL_CONTRACT_TEST_HOST_BENCH_HPP
#define TESTS_HAL_CONTRACT_TEST_HOST_BENCH_HPP

#include "hal/absent/absent.hpp"
#include "hal/contract_test/contract_test.hpp"
#include "hal/host/can_ports.hpp"
#include "hal/host/clocks.hpp"
#include "hal/host/frame_queue.hpp"
#include "hal/host/output.hpp"
#include "hal/host/watchdog.hpp"

#include <array>
#include <cstdint>
#include <cstring>
#include <deque>
#include <optional>
#include <string>

namespace counterpoint::hal::contract
{

/// What is planted into a port: one thing that its contract forbids.
enum class Defect
{
    kNone,
    kFramesReordered,
    kStampsSwapped,
    kStampedWhenTaken,
    kBytesSwapped,
    kForeignDelivered,
    kRemoteAsData,
    kFirstBitsAsData,
    kLastBitsAsData,
    kLossNotTold,
    kLossInControllerNotTold,
    kConfirmedTwice,
    kConfirmedOther,
    kConfirmedAtOnce,
    kOwnFrameReceived,
    kInverseOvertakes,
    kOtherOnTheBus,
    kOtherLengthOnTheBus,
    kLaterOvertakes,
    kOwnAfterForeign,
    kOwnMissingWhenLate,
    kOldAfterBusOff,
    kStampedAtRequest,
    kRefusalSwallowed,
    kOneGuaranteeAbsent,
    kAbsentControllerTaken,
    kTransmitWaits,
    kOneSourceForBoth,
    kCounterGoesBack,
    kCounterWrapsEarly,
    kCounterBSlow,
    kQuestionStays,
    kEarlyAnswerTaken,
    kMissingAnswerTaken,
    kWrongAnswerTaken,
    kRevivedAfterTrip,
    kImpossibleRegionTaken,
    kEraseTakesBoth,
    kProgramsNothing,
    kChallengeStays,
    kOpenAfterStart,
    kNeverOpens,
    kOnePermitNotLookedAt,
    kForgetsInterruption,
    kNeverCloses,
    kClosesLate,
    kOpenAfterTrip,
    kNotReadBack,
    kCutOffForgotten,
};

/// Two banks in plain memory, each operation done at once.
class RamParameterMemory final : public ParameterMemory
{
  public:
    explicit RamParameterMemory(const Defect defect) : defect_(defect)
    {
    }
    [[nodiscard]] std::uint32_t BankBytes() const noexcept override
    {
        return 64U;
    }
    [[nodiscard]] MemoryStatus Status() noexcept override
    {
        return MemoryStatus::kReady;
    }
    void Erase(const MemoryBank bank) noexcept override
    {
        Of(bank).fill(0xFFU);
        if (defect_ == Defect::kEraseTakesBoth)
        {
            banks_[0].fill(0xFFU);
            banks_[1].fill(0xFFU);
        }
    }
    void Program(const MemorySection& section, const std::uint8_t* const from) noexcept override
    {
        if (defect_ != Defect::kProgramsNothing)
        {
            std::memcpy(&Of(section.bank)[section.offset], from, section.count);
        }
    }
    [[nodiscard]] bool Read(const MemorySection& section, std::uint8_t* const to) noexcept override
    {
        std::memcpy(to, &Of(section.bank)[section.offset], section.count);
        return true;
    }

  private:
    [[nodiscard]] std::array<std::uint8_t, 64U>& Of(const MemoryBank bank)
    {
        return banks_[(bank == MemoryBank::kSecond) ? 1U : 0U];
    }

    std::array<std::array<std::uint8_t, 64U>, 2U> banks_{};
    Defect defect_;
};

/// The host layer as a port that is examined, with a second node on its bus, and with a defect if one is asked for.
class HostBench final : public CanPorts,
                        public Clocks,
                        public SafetyOutput,
                        public OutputCutoff,
                        public Watchdog,
                        public MemoryProtection
{
  public:
    /// @brief One controller, or both on one bus: then the inverse data are on the second one.
    explicit HostBench(Defect defect, std::uint8_t controllers = 1U);

    [[nodiscard]] PortUnderTest Table();
    [[nodiscard]] const std::string& Text() const
    {
        return text_;
    }

    [[nodiscard]] CanGuarantees Guarantees() const noexcept override;
    [[nodiscard]] InstantPair Now() noexcept override;
    [[nodiscard]] std::uint32_t Challenge() noexcept override;
    void Drive(const PermitSet& permits) noexcept override;
    void CutOff() noexcept override;
    [[nodiscard]] WatchdogQuestion Question() noexcept override;
    void Answer(const WatchdogAnswer& answer) noexcept override;
    [[nodiscard]] ProtectStatus Protect(const MemoryRegion& region) noexcept override;
    void Enter(MemoryOwner owner) noexcept override;

  private:
    class Peer final : public host::BusListener
    {
      public:
        void OnReceived(const CanFrame& frame, host::BusTime /*at*/) override
        {
            seen.push_back(frame);
        }
        void OnConfirmed(const CanFrame& /*frame*/, host::BusTime /*at*/) override
        {
        }

        std::deque<CanFrame> seen{};
    };
    class Events final : public host::FrameSink
    {
      public:
        explicit Events(HostBench& bench) : bench_(bench)
        {
        }
        void OnFrame(const StampedFrame& frame) override
        {
            bench_.Take(PortEvent{EventKind::kReceived, frame});
        }
        void OnConfirm(const StampedFrame& frame) override
        {
            bench_.Take(PortEvent{EventKind::kConfirmed, frame});
        }
        void OnOverflow() override
        {
            bench_.Take(PortEvent{EventKind::kLoss, StampedFrame{}});
        }

      private:
        HostBench& bench_;
    };

    [[nodiscard]] TransmitStatus DoTransmit(const CanFrame& frame) noexcept override;
    void Take(PortEvent event);
    void Reorder();
    [[nodiscard]] PortEvent Next();
    [[nodiscard]] bool PeerSend(const CanFrame& frame);
    [[nodiscard]] bool PeerTake(CanFrame& frame);
    void BusOff(Hold hold);
    void Restart();
    void HoldBus(Hold hold);
    void HoldCounter(Counter counter, Hold hold);
    [[nodiscard]] SrdoMask Pins();
    [[nodiscard]] bool Has(const Defect defect) const
    {
        return defect_ == defect;
    }

    Defect defect_;
    std::uint8_t controllers_;
    host::VirtualBus bus_{host::BitRate::k500k};
    host::HostClocks clocks_{bus_, InstantPair{{1000U}, {1000U}}};
    host::HostWatchdog watchdog_{bus_};
    host::HostWatchdog never_trips_{bus_};
    std::optional<host::HostOutput> output_{};
    host::FrameQueue queue_{32U};
    host::HostCanPorts can_{clocks_, queue_};
    Peer peer_{};
    host::NodeIndex peer_node_{bus_.Attach(peer_, host::NodeSetup{CanPortId::kFirst, 64U})};
    RamParameterMemory parameters_;
    AbsentMemoryProtection protection_{};
    Events sink_{*this};
    std::deque<PortEvent> events_{};
    std::uint32_t readings_{0U};
    CanFrame last_taken_{};
    InstantPair handed_over_{};
    bool was_late_{false}; ///< Interrupts were held since the last restart.
    bool pin_held_{false};
    bool was_cut_off_{false};
    bool was_driven_{false};
    std::string text_{};
};

} // namespace counterpoint::hal::contract

#endif
