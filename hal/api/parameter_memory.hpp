// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef HAL_API_PARAMETER_MEMORY_HPP
#define HAL_API_PARAMETER_MEMORY_HPP

#include <cstdint>

namespace counterpoint::hal
{

/// The two banks, which are erased independently of each other.
enum class MemoryBank : std::uint8_t
{
    kInvalid = 0U,
    kFirst = 1U,
    kSecond = 2U,
};

/// What the last operation is doing, or how it ended.
enum class MemoryStatus : std::uint8_t
{
    kInvalid = 0U,
    kReady = 0x69U, ///< The last operation has ended well; the next may start.
    kBusy = 1U,
    kFailed = 2U, ///< The last operation has ended badly. The next may start.
};

/// Bytes of a bank are programmed in units, aligned to it: flash with error correction cannot do less.
constexpr std::uint32_t kProgramUnitBytes = 8U;

/// A place in persistent memory and how many bytes from there.
struct MemorySection
{
    MemoryBank bank;
    std::uint32_t offset;
    std::uint32_t count;
};

/// Memory that keeps parameters without power. An operation is started and then asked for by Status, so that nobody
/// waits for a flash. Power may fail at any moment: bytes of the section that was being worked on, and no others, then
/// have any value. [SRS_STO_010]
class ParameterMemory
{
  public:
    /// @brief Bytes of one bank, a multiple of kProgramUnitBytes.
    [[nodiscard]] virtual std::uint32_t BankBytes() const noexcept = 0;
    /// @brief Goes on with the running operation as far as that needs no waiting, and tells how far it is.
    [[nodiscard]] virtual MemoryStatus Status() noexcept = 0;
    /// @brief Every byte of the bank becomes FFh. Only when not kBusy.
    virtual void Erase(MemoryBank bank) noexcept = 0;
    /// @brief Writes bytes that are erased; the section is of whole units. `from` is kept until the end. Only when not
    /// kBusy.
    virtual void Program(const MemorySection& section, const std::uint8_t* from) noexcept = 0;
    /// @brief Reads bytes. False: they could not be read. Only when not kBusy.
    [[nodiscard]] virtual bool Read(const MemorySection& section, std::uint8_t* to) noexcept = 0;

    ParameterMemory(const ParameterMemory&) = delete;
    ParameterMemory(ParameterMemory&&) = delete;
    ParameterMemory& operator=(const ParameterMemory&) = delete;
    ParameterMemory& operator=(ParameterMemory&&) = delete;

  protected:
    ParameterMemory() noexcept = default;
    ~ParameterMemory() noexcept = default;
};

} // namespace counterpoint::hal

#endif
