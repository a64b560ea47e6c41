// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_CIA301_PDO_TPDO_HPP
#define CANOPEN_CIA301_PDO_TPDO_HPP

#include "canopen/cia301/nmt/frame_sink.hpp"
#include "canopen/cia301/pdo/mapping.hpp"
#include "canopen/cia301/time/sync.hpp"

namespace counterpoint::cia301
{

/// What makes an event-driven TPDO send, besides its event timer and the application's request.
enum class PdoTrigger : std::uint8_t
{
    kRequest = 0U, ///< Nothing more.
    kChange = 1U,  ///< A mapped value but 1013h differs from what was sent. [SRS_PDO_150]
};

/// 1800h.. of one PDO.
struct TpdoSettings
{
    std::uint32_t cob_id{0xC0000000U}; ///< Off, no RTR.
    std::uint8_t type{0xFEU};
    std::uint16_t inhibit_100us{0U};
    std::uint16_t event_ms{0U};
    std::uint8_t sync_start{0U};
};

/// What one PDO is doing.
struct TpdoRun
{
    PdoData sampled{};    ///< What waits, or what RTR answers.
    PdoData sent{};       ///< Last transmission.
    Instant due_at{0U};   ///< SYNC of what waits.
    Instant sent_at{0U};  ///< For the inhibit time.
    Instant timer_at{0U}; ///< Begin of the event time.
    std::uint32_t window_us{0U};
    std::uint8_t syncs{0U};   ///< SYNCs since the last transmission.
    bool is_requested{false}; ///< An event waits.
    bool is_due{false};       ///< `sampled` waits for room in the sink.
    bool is_inhibited{false};
    bool is_timed{false}; ///< `timer_at` holds.
    bool has_sampled{false};
    bool is_aligned{false}; ///< The SYNC start value was seen.
};

/// One transmit PDO. The owner gives number, trigger and room; the rest is zero-filled at first.
struct Tpdo
{
    std::uint16_t number; ///< 1 to 512: 1800h + number - 1.
    PdoTrigger trigger;
    PdoMap map;
    TpdoSettings settings{};
    TpdoRun run{};
};

/// The PDOs of a device, by ascending number.
struct TpdoTable
{
    Tpdo* pdos;
    std::uint16_t count;
};

/// What the TPDOs work with; all kept by reference.
struct TpdoParts
{
    FrameSink& sink;
    Dictionary& dictionary;
    TpdoTable table;
};

/// Sends the TPDOs of a device: transmission types 0 to 240 after SYNC, 252 and 253 on a remote frame, 254 and 255 on
/// events. Works in OPERATIONAL only. Call OnCycle at least once in 2^30 us. Not reentrant. Each call takes O(count x
/// fields).
class Tpdos
{
  public:
    /// @brief As after Reset.
    explicit Tpdos(const TpdoParts& parts) noexcept;

    /// @brief Reset communication: all off, nothing mapped.
    void Reset() noexcept;
    /// @brief Until EndConfiguration values may be written in any order and are not checked: defaults and stored
    /// values. [SRS_PDO_007]
    void BeginConfiguration() noexcept;
    /// @brief Checks everything: a PDO whose mapping does not hold is off.
    void EndConfiguration() noexcept;
    /// @brief After EndConfiguration: turns off each PDO whose COB-ID the rule does not allow. O(count * rule)
    /// [SRS_PDO_009]
    void TurnOffShared(const WriteRule& rule) noexcept;
    /// @brief Whether a valid PDO has this identifier, but for the one of the number `except`; 0: for none. O(count)
    [[nodiscard]] bool Uses(std::uint32_t identifier, std::uint16_t except) const noexcept;

    /// @brief A remote frame may ask for a PDO. [SRS_PDO_014]
    void OnFrame(const CanFrame& frame, const Moment& moment) noexcept;
    /// @brief A SYNC: samples and sends the TPDOs that are due with it. [SRS_PDO_010, SRS_PDO_011, SRS_PDO_015]
    void OnSync(const SyncEvent& event) noexcept;
    /// @brief Looks at events and event timers, and sends what found no room before. [SRS_PDO_012, SRS_PDO_013]
    void OnCycle(const Moment& moment) noexcept;
    /// @brief The application's event of one TPDO (types 0, 254, 255). False: there is no such TPDO. [SRS_PDO_012]
    bool Request(std::uint16_t number) noexcept;

    /// @brief 1800h.. and 1A00h.. by the number of the TPDO, for their hook; so are the three functions below.
    /// [SRS_PDO_001, SRS_PDO_002, SRS_PDO_003, SRS_PDO_004, SRS_PDO_005]
    [[nodiscard]] ObjectValue FetchSetting(std::uint16_t number, std::uint8_t sub) const noexcept;
    [[nodiscard]] ObjectValue FetchMapping(std::uint16_t number, std::uint8_t sub) const noexcept;
    [[nodiscard]] SdoAbort StoreSetting(std::uint16_t number, std::uint8_t sub, std::uint32_t value) noexcept;
    [[nodiscard]] SdoAbort StoreMapping(std::uint16_t number, std::uint8_t sub, std::uint32_t value) noexcept;

  private:
    [[nodiscard]] Tpdo* Find(std::uint16_t number) const noexcept;
    [[nodiscard]] SdoAbort Change(Tpdo& pdo, std::uint8_t sub, std::uint32_t value) noexcept;
    [[nodiscard]] bool WriteCobId(Tpdo& pdo, std::uint32_t value) noexcept;
    void FollowState(const Moment& moment) noexcept;
    void Start(Tpdo& pdo) noexcept;
    void SendDue(Tpdo& pdo, const Moment& moment) noexcept;
    void RunEvents(Tpdo& pdo, const Moment& moment) noexcept;
    [[nodiscard]] bool IsSyncDue(Tpdo& pdo, const SyncEvent& event, const PdoData& now) const noexcept;
    void Transmit(Tpdo& pdo, Instant now) noexcept;

    TpdoParts parts_;
    bool is_operational_;
    bool is_configuring_;
};

} // namespace counterpoint::cia301

#endif
