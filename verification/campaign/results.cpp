// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/campaign/results.hpp"

#include "runtime/yaml/document.hpp"

#include <array>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <fstream>
#include <ostream>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

namespace counterpoint::campaign
{
namespace
{
/// In front of the outcomes.
struct Header
{
    std::array<char, 7U> mark{'C', 'P', 'C', 'A', 'M', 'P', '3'};
    std::uint8_t check{0U};
    std::uint64_t digest{0U};
    std::uint64_t total{0U};
    std::uint32_t number{0U};
    std::uint32_t count{0U};
};
static_assert(sizeof(Header) == 32U, "the format of a file of results");

/// One outcome; one that is not tried yet is 0.
struct Stored
{
    std::uint8_t result_and_detector{0U}; ///< Three bits and five.
    std::uint8_t detail{0U};
    std::uint8_t marks{0U};
    std::uint8_t check{0U};
    std::uint32_t us{0U};
};
static_assert(sizeof(Stored) == sizeof(std::uint64_t), "the format of a file of results");
static_assert(kClassCount <= 8U && kDetectorCount <= 32U, "three bits and five");

/// CRC of polynomial 07h, without its own place; 0 of what is 0.
template <typename T> std::uint8_t CheckOf(T record)
{
    record.check = 0U;
    std::array<std::uint8_t, sizeof(T)> bytes{};
    std::memcpy(bytes.data(), &record, sizeof(T));
    std::uint32_t crc = 0U;
    for (const std::uint8_t byte : bytes)
    {
        crc ^= byte;
        for (int bit = 0; bit < 8; ++bit)
        {
            crc = ((crc & 0x80U) != 0U) ? ((crc << 1U) ^ 0x107U) : (crc << 1U);
        }
    }
    return static_cast<std::uint8_t>(crc);
}

Header HeaderOf(const ResultsOf& of)
{
    Header header;
    header.digest = of.digest;
    header.total = of.total;
    header.number = of.shard.number;
    header.count = of.shard.count;
    header.check = CheckOf(header);
    return header;
}

bool IsEqual(const Header& left, const Header& right)
{
    return std::memcmp(&left, &right, sizeof(Header)) == 0;
}

constexpr const char* kOfThis = "a file of results of this plan, scenario and program";

[[noreturn]] void Refuse(const std::string& file, const std::string& wrong, const std::string& expected = kOfThis)
{
    throw runtime::YamlError(file, {}, wrong, expected);
}

int Open(const std::string& file, const Access access)
{
    const bool reads = access == Access::kRead;
    const int descriptor = open(file.c_str(), (reads ? O_RDONLY : (O_RDWR | O_CREAT)) | O_CLOEXEC, 0644);
    if (descriptor < 0)
    {
        Refuse(file, reads ? "a file that cannot be read" : "a file that cannot be written");
    }
    return descriptor;
}
} // namespace

Results::Results(const std::string& file, const ResultsOf& of, const Access access)
    : of_(of), size_((of.total + of.shard.count - of.shard.number) / of.shard.count),
      length_(sizeof(Header) + (size_ * sizeof(Stored)))
{
    if (file.empty())
    {
        Map(-1, "memory", access);
        return;
    }
    Take(file, access);
    RequireWhole(file);
}

void Results::Take(const std::string& file, const Access access)
{
    struct stat before = {};
    const bool was_there = stat(file.c_str(), &before) == 0;
    const int descriptor = Open(file, access);
    struct stat known = {};
    const bool is_known = fstat(descriptor, &known) == 0 && S_ISREG(known.st_mode);
    const bool is_new = is_known && known.st_size == 0 && access == Access::kWrite;
    if (!is_known || (!is_new && static_cast<std::uint64_t>(known.st_size) != length_))
    {
        close(descriptor);
        Refuse(file, "a file of another size");
    }
    if (access == Access::kWrite)
    {
        TakeRoom(descriptor, file, is_new);
    }
    Map(descriptor, file, access);
    close(descriptor);
    Header header;
    std::memcpy(&header, bytes_, sizeof(header));
    // Without a header the process ended right behind the beginning.
    const bool has_none = IsEqual(header, Header{{}, 0U, 0U, 0U, 0U, 0U});
    if (has_none && access == Access::kWrite)
    {
        RequireNothing(file);
        was_empty_ = was_there;
        header = HeaderOf(of_);
        std::memcpy(bytes_, &header, sizeof(header));
    }
    if (!IsEqual(header, HeaderOf(of_)))
    {
        munmap(bytes_, length_);
        Refuse(file, "results of another campaign, scenario, shard or program");
    }
}

/// All of it before anything is tried: a process that puts an outcome where the file system finds no room is ended, and
/// nobody could tell that from an end by the fault. [SRS_CMG_172]
void Results::TakeRoom(const int descriptor, const std::string& file, const bool is_new) const
{
    const auto length = static_cast<off_t>(length_);
    const int error = (ftruncate(descriptor, length) == 0) ? posix_fallocate(descriptor, 0, length) : errno;
    if (error == 0)
    {
        return;
    }
    if (is_new)
    {
        static_cast<void>(ftruncate(descriptor, 0)); // What was taken of it is given back.
    }
    close(descriptor);
    Refuse(file, "no room for its " + std::to_string(length_) + " bytes (" + std::strerror(error) + ")",
           "a file system with room for them");
}

Results::~Results()
{
    munmap(bytes_, length_);
}

void Results::Map(const int descriptor, const std::string& file, const Access access)
{
    const int flags = (descriptor < 0) ? (MAP_SHARED | MAP_ANONYMOUS) : MAP_SHARED;
    const int rights = (access == Access::kRead) ? PROT_READ : (PROT_READ | PROT_WRITE);
    void* const place = mmap(nullptr, length_, rights, flags, descriptor, 0);
    if (place == MAP_FAILED)
    {
        Refuse(file, "no room");
    }
    bytes_ = static_cast<std::uint8_t*>(place);
}

/// Throws where an outcome is not as it was put there.
void Results::RequireWhole(const std::string& file)
{
    for (std::uint64_t index = 0U; index < size_; ++index)
    {
        Stored stored;
        std::memcpy(&stored, bytes_ + sizeof(Header) + (index * sizeof(Stored)), sizeof(stored));
        if (stored.check != CheckOf(stored))
        {
            munmap(bytes_, length_);
            Refuse(file, "a damaged outcome of experiment " + std::to_string(NumberAt(index)));
        }
    }
}

/// Outcomes without a header may be those of any plan.
void Results::RequireNothing(const std::string& file)
{
    for (std::size_t place = sizeof(Header); place < length_; ++place)
    {
        if (bytes_[place] != 0U)
        {
            munmap(bytes_, length_);
            Refuse(file, "outcomes without what they belong to");
        }
    }
}

Outcome Results::At(const std::uint64_t index) const noexcept
{
    constexpr std::uint8_t three = 0x07U;
    Stored stored;
    std::memcpy(&stored, bytes_ + sizeof(Header) + (index * sizeof(Stored)), sizeof(stored));
    return {static_cast<Class>(stored.result_and_detector & three),
            static_cast<Detector>(stored.result_and_detector >> 3U), stored.detail, stored.marks, stored.us};
}

void Results::Put(const std::uint64_t index, const Outcome& outcome) noexcept
{
    Stored stored;
    stored.result_and_detector = static_cast<std::uint8_t>(static_cast<std::uint32_t>(outcome.result) |
                                                           (static_cast<std::uint32_t>(outcome.detector) << 3U));
    stored.detail = outcome.detail;
    stored.marks = outcome.marks;
    stored.us = outcome.us;
    stored.check = CheckOf(stored);
    std::uint64_t word = 0U;
    std::memcpy(&word, &stored, sizeof(word));
    auto* const place = reinterpret_cast<std::uint64_t*>(bytes_ + sizeof(Header) + (index * sizeof(Stored)));
    __atomic_store_n(place, word, __ATOMIC_RELEASE);
}

std::uint64_t Results::OpenCount() const noexcept
{
    std::uint64_t open = 0U;
    for (std::uint64_t index = 0U; index < size_; ++index)
    {
        open += (At(index).result == Class::kOpen) ? 1U : 0U;
    }
    return open;
}

ResultsOf Results::Read(const std::string& file)
{
    Header header{{}, 0U, 0U, 0U, 0U, 0U};
    std::ifstream in(file, std::ios::binary);
    in.read(reinterpret_cast<char*>(&header), sizeof(header));
    if (!in || header.mark != Header{}.mark || header.check != CheckOf(header) || header.count == 0U ||
        header.number == 0U || header.number > header.count)
    {
        Refuse(file, "no file of results, or a damaged one");
    }
    return {header.digest, header.total, {header.number, header.count}};
}

std::uint64_t OfProgram(const std::uint64_t digest, const char* const program) noexcept
{
    std::uint64_t hash = digest;
    for (const char* character = program; *character != '\0'; ++character)
    {
        hash = (hash ^ static_cast<std::uint8_t>(*character)) * 0x100000001B3U;
    }
    return hash;
}

void Results::Merge(const std::string& file)
{
    const ResultsOf other_of = Read(file);
    if (other_of.digest != of_.digest || other_of.total != of_.total)
    {
        Refuse(file, "results of another campaign, scenario or program");
    }
    const Results other(file, other_of, Access::kRead);
    for (std::uint64_t index = 0U; index < other.Size(); ++index)
    {
        const Outcome outcome = other.At(index);
        if (outcome.result != Class::kOpen)
        {
            Put(other.NumberAt(index), outcome); // This one holds all of them.
        }
    }
}

void TellEmpty(const Results& results, const std::string& file, std::ostream& err)
{
    if (results.WasEmpty())
    {
        err << file << ": warning: there is nothing in it, expected results to go on with; all experiments are tried\n";
    }
}
} // namespace counterpoint::campaign
