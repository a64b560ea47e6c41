// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "hal/host/file_parameter_memory.hpp"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <stdexcept>
#include <utility>

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
constexpr std::uint32_t kMostParts = 100U; ///< Names that are tried for a file that is being made.

[[noreturn]] void Refuse(const std::string& path, const std::string& why)
{
    throw std::runtime_error(path + ": " + why);
}

/// A file that was not there before; -1: it was, or there can be none.
int CreateAlone(const std::string& path)
{
    return ::open(path.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0644);
}

/// For file systems without links: the name is taken by a file of ours first, so that no other one is replaced.
bool RenameAlone(const std::string& from, const std::string& to)
{
    const int claim = CreateAlone(to);
    if (claim < 0)
    {
        return false;
    }
    const bool is_renamed = (::close(claim) == 0) && (::rename(from.c_str(), to.c_str()) == 0);
    if (!is_renamed)
    {
        static_cast<void>(::unlink(to.c_str())); // What stands under the name is whole, or nothing does.
    }
    return is_renamed;
}

} // namespace

FileParameterMemory::FileParameterMemory(const std::string& path, const std::uint32_t bank_bytes)
    : path_(path), file_(-1), bank_bytes_(bank_bytes), status_(hal::MemoryStatus::kReady)
{
    if ((bank_bytes == 0U) || ((bank_bytes % hal::kProgramUnitBytes) != 0U))
    {
        Refuse(path, "a bank of " + std::to_string(bank_bytes) + " bytes, expected a multiple of 8 above 0");
    }
    if ((::access(path.c_str(), F_OK) != 0) && (errno == ENOENT))
    {
        Create();
    }
    try
    {
        Open();
    }
    catch (const std::runtime_error&)
    {
        if (file_ >= 0)
        {
            ::close(file_);
        }
        throw;
    }
}

void FileParameterMemory::Open()
{
    file_ = ::open(path_.c_str(), O_RDWR | O_CLOEXEC);
    struct stat status = {};
    if ((file_ < 0) || (::fstat(file_, &status) != 0))
    {
        Refuse(path_, "cannot be opened for reading and writing: " + std::string(std::strerror(errno)) +
                          ", expected a file for parameters");
    }
    // Two writers would break each other's sets. Where a file system knows no locks, nothing is known of another one.
    if ((::flock(file_, LOCK_EX | LOCK_NB) != 0) && (errno == EWOULDBLOCK))
    {
        Refuse(path_, "is in use by another device, expected a file of its own");
    }
    if (!S_ISREG(status.st_mode))
    {
        Refuse(path_, "cannot be written, expected a regular file with room");
    }
    if (status.st_size != (2 * static_cast<std::int64_t>(bank_bytes_)))
    {
        Refuse(path_, "has " + std::to_string(status.st_size) + " bytes, expected two banks of " +
                          std::to_string(bank_bytes_));
    }
}

/// It gets its name when it is complete: a creation that broke off leaves no file that looks like a damaged one. A file
/// that has the name of the part already is not ours, or the rest of such a creation: it stays as it is.
void FileParameterMemory::Create() const
{
    std::string part = path_ + ".new";
    int file = CreateAlone(part);
    for (std::uint32_t number = 2U; (file < 0) && (errno == EEXIST) && (number <= kMostParts); ++number)
    {
        part = path_ + ".new" + std::to_string(number);
        file = CreateAlone(part);
    }
    FileParameterMemory made{part, file, bank_bytes_};
    if (made.file_ < 0)
    {
        Refuse(path_, "cannot be opened for reading and writing: " + std::string(std::strerror(errno)) +
                          ", expected a file for parameters");
    }
    const std::int64_t size_bytes = 2 * static_cast<std::int64_t>(bank_bytes_);
    const bool has_size = ::ftruncate(made.file_, size_bytes) == 0;
    made.Erase(hal::MemoryBank::kFirst);
    const bool is_first_done = has_size && (made.Status() == hal::MemoryStatus::kReady);
    made.Erase(hal::MemoryBank::kSecond);
    const bool is_done = is_first_done && (made.Status() == hal::MemoryStatus::kReady);
    // Another device may have been faster: its file stays.
    const bool is_named = is_done && ((::link(part.c_str(), path_.c_str()) == 0) || (errno == EEXIST) ||
                                      RenameAlone(part, path_) || (errno == EEXIST));
    static_cast<void>(::unlink(part.c_str()));
    if (!is_named)
    {
        Refuse(path_, "cannot be written, expected a regular file with room");
    }
}

FileParameterMemory::FileParameterMemory(std::string path, const int file, const std::uint32_t bank_bytes) noexcept
    : path_(std::move(path)), file_(file), bank_bytes_(bank_bytes), status_(hal::MemoryStatus::kReady)
{
}

FileParameterMemory::~FileParameterMemory()
{
    if (file_ >= 0)
    {
        ::close(file_);
    }
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
    bool is_done = IsInside({bank, 0U, bank_bytes_}) && IsInPlace();
    for (std::uint32_t at = 0U; is_done && (at < bank_bytes_); at += kChunk)
    {
        const std::uint32_t left = bank_bytes_ - at;
        is_done = WriteAll(PlaceOf({bank, at, 0U}), erased, (left < kChunk) ? left : kChunk);
    }
    is_done = is_done && (::fdatasync(file_) == 0) && IsInPlace();
    status_ = is_done ? hal::MemoryStatus::kReady : hal::MemoryStatus::kFailed;
}

void FileParameterMemory::Program(const hal::MemorySection& section, const std::uint8_t* const from) noexcept
{
    const bool is_aligned = ((section.offset | section.count) % hal::kProgramUnitBytes) == 0U;
    const bool may_write = is_aligned && IsInside(section) && IsInPlace();
    const bool is_done =
        may_write && WriteAll(PlaceOf(section), from, section.count) && (::fdatasync(file_) == 0) && IsInPlace();
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

/// Whether the open file is what the next start will find under its name.
bool FileParameterMemory::IsInPlace() const noexcept
{
    struct stat open = {};
    struct stat named = {};
    const bool are_there = (::fstat(file_, &open) == 0) && (::stat(path_.c_str(), &named) == 0);
    const bool is_same = are_there && (open.st_dev == named.st_dev) && (open.st_ino == named.st_ino);
    return is_same && (open.st_size == (2 * static_cast<std::int64_t>(bank_bytes_)));
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
