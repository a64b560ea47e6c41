// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_START_UP_EL6751_PDOS_HPP
#define CANOPEN_START_UP_EL6751_PDOS_HPP

#include "canopen/cia301/nmt/frame_sink.hpp"
#include "canopen/start_up/el6751/setup.hpp"

#include <cstdint>

namespace counterpoint::cia302
{

/// What is known of one configured PDO. Zero-filled at first.
struct El6751PdoRecord
{
    bool has_come;     ///< TxPDO: since the start, even too short; it is supervised from then on.
    bool has_passed;   ///< TxPDO: received since the start. RxPDO: sent.
    bool is_in_cycle;  ///< TxPDO: received in the window of this SYNC cycle.
    bool is_due;       ///< RxPDO: to be sent.
    bool is_awaited;   ///< RxPDO: its transmission ends the window, see kLastRxPdo.
    bool is_inhibited; ///< RxPDO: within the inhibit time.
    std::uint8_t age;  ///< SYNC cycles since it was received, expected or sent.
    std::uint8_t missed;
    std::uint8_t sent[8];
    std::int16_t fault; ///< TxPDO: NodeState 20, 22 or 40 until it is received again, in time; 0: none.
    Instant last;       ///< Received, or sent.
};

/// Room for El6751PdoCount records, kept by reference.
struct El6751PdoRoom
{
    El6751PdoRecord* records;
    std::uint16_t count;
};

/// What the PDOs work with; all kept by reference.
struct El6751PdoParts
{
    const NetworkSetup& setup;
    cia301::FrameSink& sink;
    El6751PdoRoom room;
    El6751Times times;
};

/// Sends SYNC and the RxPDOs to the slaves, and supervises the TxPDOs that come from them. Times are exact to the
/// distance of two calls. Not reentrant.
class El6751Pdos
{
  public:
    /// @brief Sends nothing before Begin.
    explicit El6751Pdos(const El6751PdoParts& parts) noexcept;

    /// @brief Forgets everything; SYNC is sent from the next cycle on, if it is needed. False: there is not enough
    /// room.
    [[nodiscard]] bool Begin() noexcept;
    /// @brief No SYNC, no RxPDOs, no supervision.
    void End() noexcept;
    /// @brief Whether SYNC is sent.
    [[nodiscard]] bool IsSyncSent() const noexcept;

    /// @brief The slave is being started: its TxPDOs are expected from now on. [SRS_ELM_028]
    void Await(NodeId node) noexcept;
    /// @brief RxPDOs are sent to the slave from now on, each of them at once for the first time. [SRS_ELM_030]
    void Feed(NodeId node) noexcept;
    /// @brief Nothing is sent to the slave, and nothing is expected of it.
    void Rest(NodeId node) noexcept;

    /// @brief A frame from the bus. O(PDOs) [SRS_ELM_033, SRS_ELM_034, SRS_ELM_035, SRS_ELM_036, SRS_ELM_037,
    /// SRS_ELM_038]
    void OnFrame(const CanFrame& frame, Instant now) noexcept;
    /// @brief A frame of this device was on the bus; only kLastRxPdo needs it. O(PDOs) [SRS_ELM_033]
    void OnSent(const CanFrame& frame) noexcept;
    /// @brief SYNC, RxPDOs, windows and times. O(PDOs) [SRS_ELM_031, SRS_ELM_032, SRS_ELM_033, SRS_ELM_034,
    /// SRS_ELM_035, SRS_ELM_036, SRS_ELM_037]
    void OnCycle(Instant now) noexcept;

    /// @brief SYNC and RxPDOs that the sink did not take in the last cycle; nothing else happens. O(PDOs) [SRS_ELM_230]
    void SendAgain(Instant now) noexcept;

    /// @brief NodeState of the slave's first TxPDO that is missing or too short; 0: none is.
    [[nodiscard]] std::int16_t Fault(NodeId node) const noexcept;
    /// @brief Whether every configured TxPDO was received since Await; true without one.
    [[nodiscard]] bool HasAll(NodeId node) const noexcept;
    /// @brief Whether any configured TxPDO was received since Await; true without one. [SRS_ELM_029]
    [[nodiscard]] bool HasAny(NodeId node) const noexcept;

  private:
    enum class Duty : std::uint8_t
    {
        kRest = 0U,
        kAwait = 1U,
        kFeed = 2U, ///< RxPDOs are sent to it, and its TxPDOs are expected.
    };

    [[nodiscard]] El6751PdoRecord& Record(NodeId node, std::uint8_t position) const noexcept;
    [[nodiscard]] std::uint8_t CountTx(NodeId node, bool has_passed) const noexcept;
    void Take(NodeId node, std::uint8_t position, const CanFrame& frame, Instant now) noexcept;
    void SendSync(Instant now) noexcept;
    void OnSync(Instant now) noexcept;
    void OpenFor(NodeId node) noexcept;
    void EndWindow() noexcept;
    void EndWindowIfOver(Instant now) noexcept;
    void CheckTimes(NodeId node, Instant now) noexcept;
    void SendTo(NodeId node, Instant now) noexcept;

    El6751PdoParts parts_;
    std::uint16_t first_[kNodeRoom]; ///< First record of each node.
    Duty duty_[kNodeRoom];
    std::uint32_t window_us_;
    std::uint16_t awaited_; ///< RxPDOs of this cycle that were not on the bus yet.
    bool is_sync_sent_;
    bool is_running_; ///< SYNC was sent; `sync_due_` was its time.
    bool is_window_open_;
    bool is_waiting_; ///< The sink did not take SYNC or an RxPDO.
    Instant sync_due_;
    Instant sync_at_; ///< When it was sent.
};

} // namespace counterpoint::cia302

#endif
