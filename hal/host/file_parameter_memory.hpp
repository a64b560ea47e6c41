// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef HAL_HOST_FILE_PARAMETER_MEMORY_HPP
#define HAL_HOST_FILE_PARAMETER_MEMORY_HPP

#include "hal/api/parameter_memory.hpp"

#include <cstdint>
#include <string>

namespace counterpoint::host
{

/// A file of two banks as persistent memory: what was programmed is on the disk before the operation ends, in the file
/// that has this name then; an operation on a file that is no longer there fails. [SRS_STO_013, SRS_STO_018]
class FileParameterMemory final : public hal::ParameterMemory
{
  public:
    /// @brief Opens the file, or creates an erased one, whole or not at all, if there is none; no other file is
    /// changed. Throws
    /// std::runtime_error, one line with the path, if that fails, if the file has another size than two banks, 0 among
    /// them, or if `bank_bytes` is no multiple of the unit.
    FileParameterMemory(const std::string& path, std::uint32_t bank_bytes);
    ~FileParameterMemory();

    [[nodiscard]] std::uint32_t BankBytes() const noexcept override;
    [[nodiscard]] hal::MemoryStatus Status() noexcept override;
    void Erase(hal::MemoryBank bank) noexcept override;
    void Program(const hal::MemorySection& section, const std::uint8_t* from) noexcept override;
    [[nodiscard]] bool Read(const hal::MemorySection& section, std::uint8_t* to) noexcept override;

  private:
    FileParameterMemory(std::string path, int file, std::uint32_t bank_bytes) noexcept;

    [[nodiscard]] bool IsInside(const hal::MemorySection& section) const noexcept;
    [[nodiscard]] std::int64_t PlaceOf(const hal::MemorySection& section) const noexcept;
    [[nodiscard]] bool WriteAll(std::int64_t place, const std::uint8_t* from, std::uint32_t count) const noexcept;

    void Open();
    void Create() const;
    [[nodiscard]] bool IsInPlace() const noexcept;

    std::string path_;
    int file_;
    std::uint32_t bank_bytes_;
    hal::MemoryStatus status_;
};

} // namespace counterpoint::host

#endif
