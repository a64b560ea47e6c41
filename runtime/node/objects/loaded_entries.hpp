// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef RUNTIME_NODE_OBJECTS_LOADED_ENTRIES_HPP
#define RUNTIME_NODE_OBJECTS_LOADED_ENTRIES_HPP

#include "canopen/cia301/store/stored_parts.hpp"

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace counterpoint::runtime
{
/// The stored entries of a node, which remember what was loaded, so that what the device has not can be named.
/// [SRS_NODE_030]
class LoadedEntries final : public cia301::StoredPart
{
  public:
    /// @brief All outlive it.
    LoadedEntries(cia301::StoredEntries& entries, const cia301::Dictionary& dictionary) noexcept;

    [[nodiscard]] std::uint32_t ItemCount() noexcept override;
    [[nodiscard]] cia301::StoredItem Item(std::uint32_t number, const cia301::Room& room) noexcept override;
    void BeginLoad(std::uint8_t groups) noexcept override;
    bool LoadItem(const cia301::Bytes& item) noexcept override;
    bool EndLoad(std::uint8_t groups) noexcept override;
    void Lose(std::uint8_t groups) noexcept override;

    /// @brief Objects whose value was refused since the last call of this, such as " (0x1019:00, 0x1400:02)"; empty:
    /// none.
    [[nodiscard]] std::string TakeRefused();
    /// @brief Objects that have not what was loaded last; call it after the configuration.
    [[nodiscard]] std::vector<std::string> NotTaken() const;
    /// @brief Whether a value of this object was loaded.
    [[nodiscard]] bool Has(const ObjectAddress& object) const;

  private:
    cia301::StoredEntries& entries_;
    const cia301::Dictionary& dictionary_;
    std::map<std::uint32_t, std::vector<std::uint8_t>> loaded_; ///< By cia301::KeyOf.
    std::vector<std::string> refused_;
};
} // namespace counterpoint::runtime

#endif // RUNTIME_NODE_OBJECTS_LOADED_ENTRIES_HPP
