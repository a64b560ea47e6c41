// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_THIRD_VOICE_DEVICE_HPP
#define VERIFICATION_THIRD_VOICE_DEVICE_HPP

#include "verification/third_voice/configuration.hpp"
#include "verification/third_voice/consumer_srdo.hpp"
#include "verification/third_voice/drift.hpp"
#include "verification/third_voice/level_2.hpp"
#include "verification/third_voice/own_gfc.hpp"
#include "verification/third_voice/producer_srdo.hpp"
#include "verification/third_voice/variables.hpp"

#include <cstdint>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace counterpoint::third_voice
{
/// What somebody in front of the device sees behind a call.
struct Seen
{
    std::vector<std::pair<std::uint8_t, SrdoCause>> signals; ///< Number of the SRDO and cause.
    std::vector<std::uint8_t> events;                        ///< Numbers of SRDOs that were released or sent.
    std::vector<std::uint8_t> refreshes;                     ///< Numbers of SRDOs whose provider was called.
    std::vector<Sent> frames;                                ///< What left.
    int gfcs{0};
    int unfollowed{0}; ///< Own GFCs that no SRDO followed.
    int faults{0};     ///< Of the device.
    bool is_configuration_invalid{false};
};

/// A whole device as docs/semantics.md describes it: NMT and GFC, and in which order its SRDOs have their turns. Every
/// time is counter A's; consumers have one time for both counters.
class Device
{
  public:
    /// @brief `config` outlives it. `drift` is counter B's.
    explicit Device(const DeviceConfig& config, Flaw flaw = Flaw::kNone, const Drift& drift = Drift{});
    Device(const Device&) = delete;
    Device& operator=(const Device&) = delete;

    /// @brief What the objects hold at power-on is the device's own affair: `objects` by slot, and 1300h.
    void Start(const std::vector<SrdoObjects>& objects, std::uint32_t gfc_parameter);

    [[nodiscard]] AbortCode Write(Address address, std::uint64_t value, std::size_t size);
    void SetNmt(NmtState state);
    void OnFrame(const CanFrame& frame, Time stamp);
    /// @brief The application writes an object of a producer.
    void Put(Address address, std::uint64_t value);
    void Send(std::uint8_t number);
    /// @brief Whether it leaves.
    [[nodiscard]] bool SendGfc();
    /// @brief Level 2, for ever. The next cycle closes everything and tells it.
    void DemandSafeState();
    /// @brief Of the next frame that leaves: what the controller says.
    void RefuseNext(std::optional<SrdoCause> cause);
    void OnConfirm(const Sent& frame, Time stamp);
    void Cycle(Time now, SrdoMask acknowledge_a, SrdoMask acknowledge_b);

    [[nodiscard]] std::uint64_t Variable(Address address) const;
    [[nodiscard]] const Configuration& Configured() const;
    [[nodiscard]] SrdoState StateOf(std::uint8_t number) const;
    [[nodiscard]] bool IsInLevel2() const;
    [[nodiscard]] SrdoMask Open() const;
    /// @brief When the next refresh of a producer falls due in channel A.
    [[nodiscard]] Time NextRefresh(std::uint8_t number) const;
    /// @brief When an application that sends gets too late, if it is from `first` to `last`.
    [[nodiscard]] std::optional<Time> SilenceEndsBetween(Time first, Time last) const;
    [[nodiscard]] Seen TakeSeen();
    /// @brief Whether what the last cycle did is an open question. [Consumer::IsOpen]
    [[nodiscard]] bool IsOpen() const;

  private:
    struct Srdo
    {
        std::uint8_t number;
        const SrdoObjects& objects;
        ConsumerSrdo consumer;
        ProducerSrdo producer;
        std::map<SrdoCause, Time> told_at;
    };

    void Enter(Time now);
    void Leave();
    void Consume(Srdo& srdo, Time now, bool is_gfc);
    void Produce(Srdo& srdo, Time now);
    [[nodiscard]] bool HandOver(Srdo& srdo, const Sent& frame);
    void TellCauses(Srdo& srdo, Time now);
    [[nodiscard]] Time ShortestRefresh() const;

    Flaw flaw_;
    Configuration configuration_;
    Variables variables_;
    std::vector<Srdo> srdos_; ///< By slot.
    Level2 level_2_{};
    OwnGfc own_gfc_;
    NmtState nmt_{NmtState::kInitialising};
    bool has_gfc_{false};              ///< Since the last cycle, in OPERATIONAL, and
    bool has_gfc_fault_{false};        ///< while consumers were on.
    bool has_left_{false};             ///< Since the last cycle: that one shows it, whatever came behind.
    bool has_entered_{false};          ///< OPERATIONAL, and a cycle saw it.
    bool is_running_{false};           ///< OPERATIONAL with a valid configuration.
    std::optional<SrdoCause> refused_; ///< What becomes of the next frame that leaves.
    Seen seen_{};
};
} // namespace counterpoint::third_voice

#endif
