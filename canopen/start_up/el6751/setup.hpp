// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_START_UP_EL6751_SETUP_HPP
#define CANOPEN_START_UP_EL6751_SETUP_HPP

#include "canopen/cia302/network/sdo_pool.hpp"
#include "canopen/cia302/network/setup.hpp"

#include <cstdint>

namespace counterpoint::cia302
{

/// Kind of a slave, which the reference calls a box.
enum class El6751Kind : std::uint8_t
{
    kGeneral = 0U,    ///< CANopen slave of any make.
    kBusCoupler = 1U, ///< BK51x0.
};

/// What an error does to the slave that has it, beside its NodeState.
enum class El6751NodeReaction : std::uint8_t
{
    kStop = 0U,
    kNone = 1U,
};

/// What follows the stop of a slave.
enum class El6751Restart : std::uint8_t
{
    kAutomatic = 0U, ///< Reset communication and the whole start-up.
    kByHand = 1U,    ///< The slave is deactivated.
};

/// What an error of a slave does to the other slaves.
enum class El6751NetworkReaction : std::uint8_t
{
    kNone = 0U,
    kStopAll = 1U, ///< All other started slaves are stopped and deactivated.
};

/// A configured PDO. Its direction is seen from the slave: the master sends RxPDOs.
struct El6751Pdo
{
    std::uint16_t number{1U}; ///< 1 to 512: 1400h or 1800h + number - 1.
    std::uint32_t cob_id{0U}; ///< As written to the slave; bits 0 to 10 are the identifier.
    std::uint8_t type{255U};
    std::uint8_t length_bytes{8U};
    std::uint16_t inhibit_100us{0U};         ///< Of a bus coupler not used, see El6751InhibitOf.
    std::uint16_t event_ms{0U};              ///< Of a bus coupler not used, see El6751EventOf.
    const std::uint8_t* data_bytes{nullptr}; ///< RxPDO: `length_bytes` of the application; null: zeros.
};

/// What the EL6751 profile knows of a slave beside SlaveSetup, whose concise DCF holds the further start-up SDOs and
/// whose numbers of 1F84h to 1F88h are compared. Without further words the defaults are those of the text.
struct El6751Slave
{
    El6751Kind kind{El6751Kind::kGeneral};
    bool is_device_type_checked{true};
    bool is_sync_period_written{true};
    bool is_cob_id_written{true};
    bool is_type_written{true};
    bool is_started{true}; ///< Automatic start.
    bool is_restarted_without_pdos{false};
    bool is_consumer_literal{false}; ///< 1016h:01 without the manager's node-ID.
    El6751NodeReaction node_reaction{El6751NodeReaction::kStop};
    El6751Restart restart{El6751Restart::kAutomatic};
    El6751NetworkReaction network_reaction{El6751NetworkReaction::kNone};
    std::uint8_t life_time_factor{0U};
    std::uint16_t guard_time_ms{0U};
    std::uint32_t coupler_pdos{0U};          ///< 5500h of a bus coupler.
    std::uint16_t coupler_inhibit_100us{0U}; ///< For all its PDOs.
    std::uint16_t coupler_event_ms{0U};      ///< For all its PDOs.
    const El6751Pdo* rx_pdos{nullptr};       ///< Ascending by number, as `tx_pdos`.
    const El6751Pdo* tx_pdos{nullptr};
    std::uint8_t rx_count{0U};
    std::uint8_t tx_count{0U};

    /// @brief Whether its rows set up heartbeat or guarding.
    [[nodiscard]] constexpr bool IsWatched() const noexcept
    {
        return (guard_time_ms != 0U) && (life_time_factor != 0U);
    }
    /// @brief Number of its PDOs, of both directions.
    [[nodiscard]] constexpr std::uint8_t PdoCount() const noexcept
    {
        return static_cast<std::uint8_t>(rx_count + tx_count);
    }
};

/// Where the window for synchronous TxPDOs ends. [SRS_ELM_033]
enum class El6751Window : std::uint8_t
{
    kInputShift = 0U, ///< EL6751.
    kLastRxPdo = 1U,  ///< FC51xx, CX1500-M510.
};

/// Settings of the whole network for this profile.
struct El6751Times
{
    El6751Window window{El6751Window::kInputShift};
    std::uint8_t sync_multiplier{1U};   ///< Parts of the SYNC period, 1 to 255.
    std::uint32_t input_shift_us{500U}; ///< In the last part.
};

/// How long this profile waits for an SDO.
constexpr SdoTimes kEl6751SdoTimes{2000000U, 1U};

/// @brief Whether a PDO of this transmission type needs SYNC.
[[nodiscard]] constexpr bool IsSynchronous(const std::uint8_t type) noexcept
{
    constexpr std::uint8_t kLastCyclic = 240U;
    constexpr std::uint8_t kSynchronousRemote = 252U;
    return (type <= kLastCyclic) || (type == kSynchronousRemote);
}
/// @brief Inhibit time of a PDO: its own, or the one that a bus coupler has for all. [SRS_ELM_015]
[[nodiscard]] constexpr std::uint16_t El6751InhibitOf(const El6751Slave& slave, const El6751Pdo& pdo) noexcept
{
    return (slave.kind == El6751Kind::kBusCoupler) ? slave.coupler_inhibit_100us : pdo.inhibit_100us;
}
/// @brief Event time of a PDO, likewise: written to the slave, and what its supervision goes by. [SRS_ELM_017]
[[nodiscard]] constexpr std::uint16_t El6751EventOf(const El6751Slave& slave, const El6751Pdo& pdo) noexcept
{
    return (slave.kind == El6751Kind::kBusCoupler) ? slave.coupler_event_ms : pdo.event_ms;
}
/// @brief The slave's part of the setup; that of a general slave without PDOs if it has none.
[[nodiscard]] const El6751Slave& El6751SlaveOf(const NetworkSetup& setup, NodeId node) noexcept;
/// @brief A PDO by its position: RxPDOs, then TxPDOs. `position` is below PdoCount.
[[nodiscard]] const El6751Pdo& El6751PdoOf(const El6751Slave& slave, std::uint8_t position) noexcept;
/// @brief Whether SYNC is sent: a period, and a synchronous PDO of any listed slave. O(PDOs) [SRS_ELM_032]
[[nodiscard]] bool NeedsSync(const NetworkSetup& setup) noexcept;
/// @brief PDOs of all listed slaves: the records that El6751PdoRoom has to have. O(127)
[[nodiscard]] std::uint16_t El6751PdoCount(const NetworkSetup& setup) noexcept;

} // namespace counterpoint::cia302

#endif
