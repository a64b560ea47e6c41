// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_CIA301_STORE_STORED_PARTS_HPP
#define CANOPEN_CIA301_STORE_STORED_PARTS_HPP

#include "canopen/cia301/dictionary/number_hook.hpp"
#include "canopen/cia301/nmt/slave.hpp"
#include "canopen/cia301/pdo/objects.hpp"
#include "canopen/cia301/store/node_defaults.hpp"
#include "canopen/cia301/store/parameter_store.hpp"

#include "safety_core/kernel/kernel.hpp"

namespace counterpoint::cia301
{

/// Stores the entries of a table that have kStored; `dictionary` works on the same table. An item is index, sub-index
/// and value. While a set is loaded, PDOs may be configured in any order. All kept by reference. [SRS_STO_011]
class StoredEntries final : public StoredPart
{
  public:
    /// @brief Each value is stored as it is: for a device whose node-ID never changes, or without values of it.
    StoredEntries(const EntryTable& table, const Dictionary& dictionary, Tpdos& tpdos, Rpdos& rpdos) noexcept;
    /// @brief A value that is the default of the node-ID is not stored, so that it follows the node-ID. [SRS_STO_240]
    StoredEntries(const EntryTable& table, const Dictionary& dictionary, Tpdos& tpdos, Rpdos& rpdos,
                  const NodeDefaults& defaults) noexcept;

    [[nodiscard]] std::uint32_t ItemCount() noexcept override;
    [[nodiscard]] StoredItem Item(std::uint32_t number, const Room& room) noexcept override;
    void BeginLoad(std::uint8_t groups) noexcept override;
    bool LoadItem(const Bytes& item) noexcept override;
    bool EndLoad(std::uint8_t groups) noexcept override;
    void Lose(std::uint8_t groups) noexcept override;

  private:
    EntryTable table_;
    const Dictionary& dictionary_;
    Tpdos& tpdos_;
    Rpdos& rpdos_;
    const NodeDefaults* defaults_; ///< Null: none is known.
};

/// The configuration that the kernel owns (1300h to 13FFh), as a part of the communication group. Where the saved one
/// is lost, or the kernel refuses it or an item of it, its power-on configuration holds, without A5h in 13FEh. The
/// kernel is kept by reference. [SRS_STO_012, SRS_STO_014, SRS_STO_017, SRS_STO_019, SRS_STO_021, SRS_STO_210,
/// SRS_STO_241, SRS_STO_450]
class StoredSafety final : public StoredPart
{
  public:
    /// @brief The kernel outlives it. For a device whose node-ID never changes.
    explicit StoredSafety(Kernel& kernel) noexcept;
    /// @brief What was saved with another node-ID is refused. `node` is the one that the kernel was started with, and
    /// may change before a load.
    StoredSafety(Kernel& kernel, const NodeId& node) noexcept;

    [[nodiscard]] std::uint32_t ItemCount() noexcept override;
    [[nodiscard]] StoredItem Item(std::uint32_t number, const Room& room) noexcept override;
    [[nodiscard]] SdoAbort EndSave(std::uint8_t groups) noexcept override;
    void BeginLoad(std::uint8_t groups) noexcept override;
    bool LoadItem(const Bytes& item) noexcept override;
    bool EndLoad(std::uint8_t groups) noexcept override;
    void Lose(std::uint8_t groups) noexcept override;

  private:
    [[nodiscard]] bool TakeItem(const Bytes& item) noexcept;

    Kernel& kernel_;
    ImageHeader header_; ///< Of the set that is being saved or loaded.
    bool has_header_;
    bool has_refused_;        ///< An item of the set that is being loaded.
    bool has_image_;          ///< The kernel gave one to be saved.
    std::uint32_t given_crc_; ///< CRC-32 of the values that a save has been given.
    const NodeId* node_;      ///< Null: never another one.
    bool is_of_node_;         ///< The set that is being loaded was saved with this node-ID, or does not tell.
};

/// Hook of 1010h and 1011h: sub-index 1 all, 2 communication, 3 application, 4 manufacturer. The store is kept by
/// reference. [SRS_STO_003, SRS_STO_004, SRS_STO_020]
class StoreObjects final : public NumberHook
{
  public:
    /// @brief `store` outlives the hook.
    explicit StoreObjects(ParameterStore& store) noexcept;

  private:
    [[nodiscard]] ObjectValue Fetch(const ObjectAddress& address) noexcept override;
    [[nodiscard]] SdoAbort Store(const ObjectAddress& address, std::uint32_t value) noexcept override;
    [[nodiscard]] SdoAbort StoreAgain(const ObjectAddress& address, std::uint32_t value) noexcept override;
    [[nodiscard]] SdoAbort Request(const ObjectAddress& address, std::uint32_t value, Attempt attempt) noexcept;

    ParameterStore& store_;
};

} // namespace counterpoint::cia301

#endif
