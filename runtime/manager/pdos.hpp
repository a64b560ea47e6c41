// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef RUNTIME_MANAGER_PDOS_HPP
#define RUNTIME_MANAGER_PDOS_HPP

#include "canopen/network_plan/loaded_network.hpp"
#include "safety_core/contract/can_frame.hpp"

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace counterpoint::runtime
{
/// The present value of a PDO between manager and slave. Directions are seen from the slave: the manager sends RxPDOs.
struct PdoValue
{
    std::uint8_t node{0U};
    bool is_output{false}; ///< RxPDO.
    std::uint16_t number{0U};
    std::vector<std::uint8_t> bytes;
    bool was_seen{false};    ///< For an input: it was received once. For an output: always.
    std::uint64_t at_us{0U}; ///< When it was received last.
};

/// Process data of a network under the EL6751 profile: what the RxPDOs carry, and what the TxPDOs brought.
/// [SRS_MGR_022, SRS_MGR_158, SRS_MGR_159]
class ManagerPdos
{
  public:
    /// @brief `net` outlives it.
    explicit ManagerPdos(network_plan::LoadedNetwork& net);

    /// @brief Sets the bytes of an RxPDO from now on. Answers "taken", or what is wrong and what was expected.
    [[nodiscard]] std::string Set(std::uint8_t node, std::uint16_t number, const std::vector<std::uint8_t>& bytes);
    /// @brief A frame from the bus: the values of a TxPDO are kept, unless it is too short.
    void OnFrame(const CanFrame& frame, std::uint64_t now_us);
    /// @brief Inputs that have changed and are to be told now, each at most once in 100 ms.
    [[nodiscard]] std::vector<const PdoValue*> TakeNews(std::uint64_t now_us);
    /// @brief All values by node-ID, RxPDOs first.
    [[nodiscard]] std::vector<PdoValue> Values() const;

  private:
    struct Input
    {
        PdoValue value;
        bool is_news{false};
        bool was_told{false};
        std::uint64_t told_us{0U};
    };

    network_plan::LoadedNetwork& net_;
    std::vector<Input> inputs_;
    std::multimap<std::uint32_t, std::size_t> by_identifier_;
    std::vector<std::size_t> news_; ///< Inputs to be told.
};

/// @brief Reads 1 to 8 bytes, two hexadecimal digits each, with or without spaces between them; nothing for any other
/// text.
[[nodiscard]] std::optional<std::vector<std::uint8_t>> BytesFrom(const std::string& text);
/// @brief Bytes as text: "01 FF".
[[nodiscard]] std::string BytesText(const std::vector<std::uint8_t>& bytes);
/// @brief Its name: "TxPDO 1".
[[nodiscard]] std::string NameOf(const PdoValue& value);
} // namespace counterpoint::runtime

#endif // RUNTIME_MANAGER_PDOS_HPP
