// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_CIA301_PDO_RPDO_HPP
#define CANOPEN_CIA301_PDO_RPDO_HPP

#include "canopen/cia301/nmt/frame_sink.hpp"
#include "canopen/cia301/pdo/mapping.hpp"
#include "canopen/cia301/time/sync.hpp"

namespace counterpoint::cia301
{

/// 1400h.. of one PDO.
struct RpdoSettings
{
    std::uint32_t cob_id{0x80000000U}; ///< Off.
    std::uint8_t type{0xFEU};
    std::uint16_t inhibit_100us{0U}; ///< Kept, without effect.
    std::uint16_t event_ms{0U};      ///< Deadline; 0: none.
};

/// What one PDO is doing.
struct RpdoRun
{
    PdoData data{};          ///< Waits for SYNC.
    Instant received_at{0U}; ///< Begin of the deadline.
    bool is_waiting{false};  ///< `data` holds.
    bool is_supervised{false};
};

/// One receive PDO. The owner gives number and room; the rest is zero-filled at first.
struct Rpdo
{
    std::uint16_t number; ///< 1 to 512: 1400h + number - 1.
    PdoMap map;
    RpdoSettings settings{};
    RpdoRun run{};
};

/// The PDOs of a device, by ascending number.
struct RpdoTable
{
    Rpdo* pdos;
    std::uint16_t count;
};

/// Is told that the values of an RPDO were written to the dictionary.
class RpdoListener
{
  public:
    /// @brief `number` is 1 to 512. Called within OnFrame or OnSync of the RPDOs.
    virtual void OnRpdo(std::uint16_t number, Instant now) noexcept = 0;

  protected:
    RpdoListener() noexcept = default;
    ~RpdoListener() noexcept = default;
    RpdoListener(const RpdoListener&) = default;
    RpdoListener& operator=(const RpdoListener&) = default;
};

/// What the RPDOs work with; all kept by reference.
struct RpdoParts
{
    CommunicationErrors& errors;
    Dictionary& dictionary;
    RpdoTable table;
    RpdoListener* listener; ///< Optional.
};

/// Receives the RPDOs of a device: transmission types 0 to 240 take effect with the next SYNC, 254 and 255 at once.
/// Works in OPERATIONAL only. Call OnCycle at least once in 2^30 us. Not reentrant. Each call takes O(count + fields).
class Rpdos
{
  public:
    /// @brief As after Reset.
    explicit Rpdos(const RpdoParts& parts) noexcept;

    /// @brief Reset communication: all off, nothing mapped.
    void Reset() noexcept;
    /// @brief From here to EndConfiguration values may be written in any order and are not checked: defaults and stored
    /// values. [SRS_PDO_007]
    void BeginConfiguration() noexcept;
    /// @brief Checks everything: an RPDO whose mapping does not hold is turned off.
    void EndConfiguration() noexcept;
    /// @brief After EndConfiguration: turns off each PDO whose COB-ID the rule does not allow. O(count * rule)
    /// [SRS_PDO_009]
    void TurnOffShared(const WriteRule& rule) noexcept;
    /// @brief Whether a valid PDO has this identifier, but for the one of the number `except`; 0: for none. O(count)
    [[nodiscard]] bool Uses(std::uint32_t identifier, std::uint16_t except) const noexcept;

    /// @brief A frame from the bus. [SRS_PDO_020, SRS_PDO_021, SRS_PDO_022]
    void OnFrame(const CanFrame& frame, const Moment& moment) noexcept;
    /// @brief A SYNC: what waits for it is written to the dictionary. [SRS_PDO_021]
    void OnSync(const SyncEvent& event) noexcept;
    /// @brief Watches the deadlines (event timers). [SRS_PDO_023]
    void OnCycle(const Moment& moment) noexcept;

    /// @brief 1400h.. and 1600h.. by the number of the RPDO, for their hook; so are the three functions below.
    /// A new COB-ID ends what is told of this PDO, an event time of 0 its deadline. [SRS_PDO_001, SRS_PDO_002,
    /// SRS_PDO_003, SRS_PDO_004, SRS_PDO_005, SRS_PDO_024]
    [[nodiscard]] ObjectValue FetchSetting(std::uint16_t number, std::uint8_t sub) const noexcept;
    [[nodiscard]] ObjectValue FetchMapping(std::uint16_t number, std::uint8_t sub) const noexcept;
    [[nodiscard]] SdoAbort StoreSetting(std::uint16_t number, std::uint8_t sub, std::uint32_t value) noexcept;
    [[nodiscard]] SdoAbort StoreMapping(std::uint16_t number, std::uint8_t sub, std::uint32_t value) noexcept;

  private:
    [[nodiscard]] Rpdo* Find(std::uint16_t number) const noexcept;
    [[nodiscard]] SdoAbort Change(Rpdo& pdo, std::uint8_t sub, std::uint32_t value) noexcept;
    [[nodiscard]] bool WriteCobId(Rpdo& pdo, std::uint32_t value) noexcept;
    void WriteDeadline(Rpdo& pdo, std::uint16_t event_ms) noexcept;
    void ForgetErrors(const Rpdo& pdo) noexcept;
    void FollowState(const Moment& moment) noexcept;
    void Take(Rpdo& pdo, const CanFrame& frame, Instant now) noexcept;
    void Apply(Rpdo& pdo, Instant now) noexcept;
    [[nodiscard]] bool IsInWindow(Instant now) const noexcept;

    RpdoParts parts_;
    Instant sync_at_;
    std::uint32_t window_us_; ///< Of the last SYNC; 0: no limit.
    bool has_sync_;           ///< One came since OPERATIONAL was entered.
    bool is_operational_;
    bool is_configuring_;
};

} // namespace counterpoint::cia301

#endif
