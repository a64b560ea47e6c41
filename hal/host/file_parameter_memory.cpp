// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "hal/host/file_parameter_memory.hpp"

#include <cerrno>
#include <cstring>
#include <stdexcept>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace counterpoint::host
{
namespace
{

constexpr std::uint8_t kErased = 0xFFU;
constexpr std::uint32_t kChunk = 4096U;

[[noreturn]] void Refuse(const std::string& path, const std::string& why)
{
    throw std::runtime_error(path + ": " + why);
}

} // namespace

FileParameterMemory::FileParameterMemory(const std::string& path, const std::uint32_t bank_bytes)
    : file_(-1), bank_bytes_(bank_bytes), status_(hal::MemoryStatus::kReady)
{
    if ((bank_bytes == 0U) || ((bank_bytes % hal::kProgramUnitBytes) != 0U))
    {
        Refuse(path, "a bank of " + std::to_string(bank_bytes) + " bytes, expected a multiple of 8 above 0");
    }
    file_ = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644);
    struct stat status = {};
    if ((file_ < 0) || (::fstat(file_, &status) != 0))
    {
        const std::string why = std::strerror(errno);
        if (file_ >= 0)
        {
            ::close(file_);
        }
        Refuse(path, "cannot be opened for reading and writing: " + why + ", expected a file for parameters");
    }
    // Two writers would break each other's sets. Where a file system knows no locks, nothing is known of another one.
    if ((::flock(file_, LOCK_EX | LOCK_NB) != 0) && (errno == EWOULDBLOCK))
    {
        ::close(file_);
        Refuse(path, "is in use by another device, expected a file of its own");
    }
    const std::int64_t expected = 2 * static_cast<std::int64_t>(bank_bytes);
    if (status.st_size == 0)
    {
        // First the size: a file whose creation broke off holds no valid set, but is a file of two banks.
        status_ = (::ftruncate(file_, expected) == 0) ? status_ : hal::MemoryStatus::kFailed;
        Erase(hal::MemoryBank::kFirst);
        if (status_ == hal::MemoryStatus::kReady)
        {
            Erase(hal::MemoryBank::kSecond);
        }
    }
    const bool is_other = (status.st_size != 0) && (status.st_size != expected);
    if (is_other || (status_ != hal::MemoryStatus::kReady))
    {
        ::close(file_);
        Refuse(path, is_other ? ("has " + std::to_string(status.st_size) + " bytes, expected two banks of " +
                                 std::to_string(bank_bytes))
                              : "cannot be written, expected a regular file with room");
    }
}

FileParameterMemory::~FileParameterMemory()
{
    ::close(file_);
}

std::uint32_t FileParameterMemory::BankBytes() const noexcept
{
    return bank_bytes_;
}

hal::MemoryStatus FileParameterMemory::Status() noexcept
{
    return status_;
}

void FileParameterMemory::Erase(const hal::MemoryBank bank) noexcept
{
    std::uint8_t erased[kChunk];
    std::memset(erased, kErased, kChunk);
    bool is_done = IsInside({bank, 0U, bank_bytes_});
    for (std::uint32_t at = 0U; is_done && (at < bank_bytes_); at += kChunk)
    {
        const std::uint32_t left = bank_bytes_ - at;
        is_done = WriteAll(PlaceOf({bank, at, 0U}), erased, (left < kChunk) ? left : kChunk);
    }
    is_done = is_done && (::fdatasync(file_) == 0);
    status_ = is_done ? hal::MemoryStatus::kReady : hal::MemoryStatus::kFailed;
}

void FileParameterMemory::Program(const hal::MemorySection& section, const std::uint8_t* const from) noexcept
{
    const bool is_aligned = ((section.offset | section.count) % hal::kProgramUnitBytes) == 0U;
    const bool is_done =
        is_aligned && IsInside(section) && WriteAll(PlaceOf(section), from, section.count) && (::fdatasync(file_) == 0);
    status_ = is_done ? hal::MemoryStatus::kReady : hal::MemoryStatus::kFailed;
}

bool FileParameterMemory::Read(const hal::MemorySection& section, std::uint8_t* const to) noexcept
{
    std::uint32_t done = 0U;
    bool is_going = IsInside(section);
    while (is_going && (done < section.count))
    {
        const ssize_t count = ::pread(file_, &to[done], section.count - done, PlaceOf(section) + done);
        is_going = (count > 0);
        done += is_going ? static_cast<std::uint32_t>(count) : 0U;
    }
    return is_going;
}

bool FileParameterMemory::IsInside(const hal::MemorySection& section) const noexcept
{
    const bool is_bank = (section.bank == hal::MemoryBank::kFirst) || (section.bank == hal::MemoryBank::kSecond);
    return is_bank && (section.offset <= bank_bytes_) && (section.count <= (bank_bytes_ - section.offset));
}

std::int64_t FileParameterMemory::PlaceOf(const hal::MemorySection& section) const noexcept
{
    const std::int64_t base = (section.bank == hal::MemoryBank::kSecond) ? std::int64_t{bank_bytes_} : 0;
    return base + section.offset;
}

bool FileParameterMemory::WriteAll(const std::int64_t place, const std::uint8_t* const from,
                                   const std::uint32_t count) const noexcept
{
    std::uint32_t done = 0U;
    bool is_going = true;
    while (is_going && (done < count))
    {
        const ssize_t written = ::pwrite(file_, &from[done], count - done, place + done);
        is_going = (written > 0);
        done += is_going ? static_cast<std::uint32_t>(written) : 0U;
    }
    return is_going;
}

} // namespace counterpoint::host
