// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef RUNTIME_NODE_OBJECTS_STORE_HPP
#define RUNTIME_NODE_OBJECTS_STORE_HPP

#include "runtime/node/objects/loaded_entries.hpp"

#include "canopen/cia301/store/stored_parts.hpp"
#include "canopen/cia305/stored_lss.hpp"
#include "canopen/device/services.hpp"
#include "hal/host/file_parameter_memory.hpp"

#include <array>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace counterpoint::runtime
{
/// A file as the parameter memory of a device that must not wait for a disk: a thread of its own erases and programs.
class NodeMemory final : public hal::ParameterMemory
{
  public:
    /// Throws std::runtime_error.
    explicit NodeMemory(const std::string& path);
    ~NodeMemory();

    [[nodiscard]] std::uint32_t BankBytes() const noexcept override
    {
        return file_.BankBytes();
    }
    [[nodiscard]] hal::MemoryStatus Status() noexcept override;
    void Erase(hal::MemoryBank bank) noexcept override;
    void Program(const hal::MemorySection& section, const std::uint8_t* from) noexcept override;
    [[nodiscard]] bool Read(const hal::MemorySection& section, std::uint8_t* to) noexcept override;

  private:
    void Order(std::function<void()> work);
    void Work();

    host::FileParameterMemory file_;
    std::mutex mutex_;
    std::condition_variable wake_;
    std::function<void()> work_; ///< Empty: nothing to do.
    bool is_busy_{false};
    bool is_finished_{false};
    std::thread worker_;
};

/// What a store keeps of a live node; all outlive it.
struct NodeStoreParts
{
    Kernel& kernel;
    const cia301::EntryTable& table;
    const cia301::NodeDefaults& defaults; ///< Of the same table.
    cia301::Dictionary& dictionary;
    device::Services& services;
};

/// The store of a live node in a file: 1010h, 1011h and the settings of its LSS. [SRS_NODE_011, SRS_NODE_152,
/// SRS_STO_015]
class NodeStore
{
  public:
    /// Throws std::runtime_error.
    NodeStore(const std::string& path, const NodeStoreParts& parts);

    /// @brief Loads what was saved of these groups; call it at a reset, after the values of the DCF. Answers what is
    /// wrong with the file; empty if all of it was used, or if nothing was ever saved.
    std::string Load(std::uint8_t groups) noexcept;
    /// @brief What was loaded last, after the values of the DCF.
    [[nodiscard]] const LoadedEntries& Loaded() const noexcept
    {
        return loaded_;
    }
    /// @brief What the device has not of that, as lines; call it after the configuration.
    [[nodiscard]] std::vector<std::string> NotTaken() const;
    /// @brief Goes on with a save. Once a cycle.
    void OnCycle() noexcept;
    /// @brief Whether a save is under way.
    [[nodiscard]] bool IsBusy() const noexcept
    {
        return store_.IsBusy();
    }
    /// @brief The settings that LSS saved; `otherwise` if it saved none.
    [[nodiscard]] cia305::LssSettings LoadLss(const cia305::LssSettings& otherwise) noexcept;
    /// @brief Saves settings of LSS, as LssDevice::Store.
    [[nodiscard]] cia305::LssStored Keep(const cia305::LssSettings& settings) noexcept;
    /// @brief The hook of 1010h and 1011h.
    [[nodiscard]] cia301::NumberHook& Hook() noexcept
    {
        return objects_;
    }

  private:
    std::string path_;
    NodeMemory memory_;
    cia301::StoredEntries entries_;
    LoadedEntries loaded_;
    cia301::StoredSafety safety_;
    cia305::StoredLss lss_;
    std::array<cia301::StoredPart*, 3U> list_;
    std::vector<std::uint8_t> scratch_;
    cia301::ParameterStore store_;
    cia301::StoreObjects objects_;
};
} // namespace counterpoint::runtime

#endif // RUNTIME_NODE_OBJECTS_STORE_HPP
