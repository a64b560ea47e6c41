// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef HAL_API_EXCEPTION_RECORD_HPP
#define HAL_API_EXCEPTION_RECORD_HPP

#include <cstdint>

namespace counterpoint::hal
{

/// Kinds of exceptions of a processor.
enum class ExceptionCause : std::uint32_t
{
    kInvalid = 0U,
    kDataAccess = 1U,  ///< Access to protected or absent memory.
    kBus = 2U,         ///< Unaligned access, or the bus answered with an error.
    kInstruction = 3U, ///< Undefined instruction.
    kArithmetic = 4U,  ///< Division by zero and the like.
    kProgram = 5U,     ///< The program gave up by itself.
    kNone = 0x5A5A5A5AU,
};

/// What is known of the last exception. `count`: exceptions since the record was cleared; stays at 2^32 - 1.
struct ExceptionRecord
{
    ExceptionCause cause;
    std::uint32_t address_low; ///< Where it happened or what was accessed, as the processor tells.
    std::uint32_t address_high;
    std::uint32_t count;
};

/// Storage of a record. The device places it in memory that no start-up code clears.
struct ExceptionStorage
{
    ExceptionRecord record;
    std::uint32_t seal; ///< CRC-32 over the four words of the record.
};

/// Keeps the cause of an exception over a restart. Storage whose seal does not fit is no record: nothing is read from
/// memory that was without power. [SRS_STS_050]
class ExceptionMemory
{
  public:
    /// @brief `storage` outlives this and is not touched here.
    explicit ExceptionMemory(ExceptionStorage& storage) noexcept;

    /// @brief Writes the record. Called by the handler of an exception: takes no lock and calls nothing outside of this
    /// class.
    void Record(ExceptionCause cause, std::uint64_t address) noexcept;
    /// @brief The record; cause kNone and everything else 0 if there is none.
    [[nodiscard]] ExceptionRecord Read() const noexcept;
    /// @brief Deletes the record, for example after it was reported.
    void Clear() noexcept;

  private:
    ExceptionStorage& storage_;
};

} // namespace counterpoint::hal

#endif
