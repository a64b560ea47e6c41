// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/campaign/results.hpp"

#include "canopen/cia306/text/text_file.hpp"
#include "runtime/yaml/document.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <ostream>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

namespace counterpoint::campaign
{
namespace
{
constexpr std::size_t kMarkLength = 6U;
constexpr char kFormat = '4';

/// In front of the outcomes.
struct Header
{
    std::array<char, 7U> mark{'C', 'P', 'C', 'A', 'M', 'P', kFormat};
    std::uint8_t check{0U};
    std::uint64_t plan{0U};
    std::uint64_t total{0U};
    std::uint32_t number{0U};
    std::uint32_t count{0U};
    std::uint64_t setting{0U};
    std::uint64_t program{0U};
};
static_assert(sizeof(Header) == 48U, "the format of a file of results");

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
    header.plan = of.plan;
    header.total = of.total;
    header.number = of.shard.number;
    header.count = of.shard.count;
    header.setting = of.setting;
    header.program = of.program;
    header.check = CheckOf(header);
    return header;
}

bool IsEqual(const Header& left, const Header& right)
{
    return std::memcmp(&left, &right, sizeof(Header)) == 0;
}

bool IsNone(const Header& header)
{
    return IsEqual(header, Header{{}, 0U, 0U, 0U, 0U, 0U, 0U, 0U});
}

constexpr const char* kOfThis = "a file of results of this plan, its scenario and DCFs, and this program";

[[noreturn]] void Refuse(const std::string& file, const std::string& wrong, const std::string& expected = kOfThis)
{
    throw runtime::YamlError(file, {}, wrong, expected);
}

std::string ShardText(const std::uint32_t number, const std::uint32_t count)
{
    return std::to_string(number) + "/" + std::to_string(count);
}

/// Reads up to so many bytes from the begin of a file, and says how many there were.
std::size_t ReadFrom(const int descriptor, std::uint8_t* const to, const std::size_t length)
{
    std::size_t done = 0U;
    ssize_t count = 1;
    while (done < length && count != 0)
    {
        count = pread(descriptor, to + done, length - done, static_cast<off_t>(done));
        if (count < 0 && errno != EINTR)
        {
            return done;
        }
        done += (count > 0) ? static_cast<std::size_t>(count) : 0U;
    }
    return done;
}

/// Throws for what is no head of a file of results.
Header HeaderIn(const std::string& file, const int descriptor)
{
    std::array<std::uint8_t, sizeof(Header)> bytes{};
    const bool is_whole = ReadFrom(descriptor, bytes.data(), bytes.size()) == bytes.size();
    Header header;
    std::memcpy(&header, bytes.data(), bytes.size());
    const bool is_marked = std::equal(header.mark.begin(), header.mark.begin() + kMarkLength, Header{}.mark.begin());
    const char format = header.mark[kMarkLength];
    if (is_marked && format >= '1' && format < kFormat)
    {
        Refuse(file, std::string("results of format ") + format + ", of an earlier program",
               std::string("results of format ") + kFormat + ": they are to be made anew, in another file");
    }
    const bool is_head = is_marked && format == kFormat && header.check == CheckOf(header) && header.count != 0U &&
                         header.number != 0U && header.number <= header.count;
    if (!is_whole || (!is_head && !IsNone(header)))
    {
        Refuse(file, "no file of results, or a damaged one");
    }
    return header;
}

/// Throws where results belong to something else, and says to what. [SRS_CMG_801]
void RequireSame(const std::string& file, const Header& header, const ResultsOf& of)
{
    if (header.program != of.program)
    {
        Refuse(file, "results of another program", "results of this program, by its version, commit and objects");
    }
    if (header.plan != of.plan)
    {
        Refuse(file, "results of another plan", "results of the text of this plan");
    }
    if (header.setting != of.setting)
    {
        Refuse(file, "results of another device: its scenario, a DCF or its limits are others",
               "results of the scenario and the DCFs of this plan as they are now");
    }
    if (header.total != of.total)
    {
        Refuse(file, "results of a campaign of " + std::to_string(header.total) + " experiments",
               "one of " + std::to_string(of.total));
    }
}

int OpenResults(const std::string& file, const Access access)
{
    const bool reads = access == Access::kRead;
    const int descriptor = open(file.c_str(), (reads ? O_RDONLY : (O_RDWR | O_CREAT)) | O_CLOEXEC, 0644);
    if (descriptor < 0)
    {
        Refuse(file, reads ? "a file that cannot be read" : "a file that cannot be written");
    }
    return descriptor;
}

/// Whether all of it was written there.
bool IsWritten(const int descriptor, const void* const from, const std::size_t length, const std::size_t place) noexcept
{
    ssize_t count = -1;
    do
    {
        count = pwrite(descriptor, from, length, static_cast<off_t>(place));
    } while (count < 0 && errno == EINTR);
    return count == static_cast<ssize_t>(length);
}

constexpr std::size_t PlaceOf(const std::uint64_t index)
{
    return sizeof(Header) + (index * sizeof(Stored));
}
} // namespace

SharedBytes::SharedBytes(const std::size_t length) noexcept : length_(length), begin_(nullptr)
{
    void* const place = mmap(nullptr, length, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    begin_ = (place == MAP_FAILED) ? nullptr : static_cast<std::uint8_t*>(place);
}

SharedBytes::~SharedBytes()
{
    if (begin_ != nullptr)
    {
        munmap(begin_, length_);
    }
}

OpenFile::~OpenFile()
{
    if (descriptor_ >= 0)
    {
        close(descriptor_);
    }
}

Results::Results(const std::string& file, const ResultsOf& of, const Access access)
    : file_(file), of_(of), size_((of.total + of.shard.count - of.shard.number) / of.shard.count),
      length_(PlaceOf(size_)), memory_(length_ + sizeof(std::uint64_t))
{
    if (memory_.Begin() == nullptr)
    {
        Refuse(file.empty() ? "memory" : file, "no room for " + std::to_string(size_) + " outcomes",
               "memory for 8 bytes each");
    }
    if (!file.empty())
    {
        Open(access);
        RequireWhole();
    }
}

void Results::Open(const Access access)
{
    struct stat before = {};
    const bool was_there = stat(file_.c_str(), &before) == 0;
    open_.Take(OpenResults(file_, access));
    struct stat known = {};
    const bool is_known = fstat(open_.Number(), &known) == 0 && S_ISREG(known.st_mode);
    const bool can_begin = access == Access::kWrite;
    const bool is_new = is_known && known.st_size == 0 && can_begin;
    if (!is_known)
    {
        Refuse(file_, "no regular file");
    }
    if (!is_new)
    {
        RequireOf(can_begin);
    }
    if (!is_new && static_cast<std::uint64_t>(known.st_size) != length_)
    {
        Refuse(file_, "a file of another size, " + std::to_string(known.st_size) + " bytes",
               std::to_string(length_) + " bytes of results of this plan");
    }
    if (can_begin)
    {
        TakeRoom(is_new);
    }
    ReadAll();
    Header header;
    std::memcpy(&header, memory_.Begin(), sizeof(header));
    // Without a header the process ended right behind the beginning.
    if (IsNone(header))
    {
        RequireNothing();
        was_empty_ = was_there;
        Begin();
    }
}

/// Throws where it is one of something else; one without a head only where it is to be begun.
void Results::RequireOf(const bool can_begin) const
{
    const Header header = HeaderIn(file_, open_.Number());
    if (IsNone(header) && can_begin)
    {
        return;
    }
    if (IsNone(header))
    {
        Refuse(file_, "no file of results, or a damaged one");
    }
    RequireSame(file_, header, of_);
    if (header.number != of_.shard.number || header.count != of_.shard.count)
    {
        Refuse(file_, "results of shard " + ShardText(header.number, header.count),
               "those of shard " + ShardText(of_.shard.number, of_.shard.count));
    }
}

void Results::ReadAll()
{
    if (ReadFrom(open_.Number(), memory_.Begin(), length_) != length_)
    {
        Refuse(file_, "a file that ended while it was read", "all of its " + std::to_string(length_) + " bytes");
    }
}

void Results::Begin()
{
    const Header header = HeaderOf(of_);
    std::memcpy(memory_.Begin(), &header, sizeof(header));
    if (!IsWritten(open_.Number(), &header, sizeof(header), 0U))
    {
        Refuse(file_, std::string("a file that cannot be written (") + std::strerror(errno) + ")");
    }
}

/// All of it before anything is tried, so that a full file system is told at once. [SRS_CMG_172]
void Results::TakeRoom(const bool is_new) const
{
    const auto length = static_cast<off_t>(length_);
    const int descriptor = open_.Number();
    const int error = (ftruncate(descriptor, length) == 0) ? posix_fallocate(descriptor, 0, length) : errno;
    if (error == 0)
    {
        return;
    }
    if (is_new)
    {
        static_cast<void>(ftruncate(descriptor, 0)); // What was taken of it is given back.
    }
    Refuse(file_, "no room for its " + std::to_string(length_) + " bytes (" + std::strerror(error) + ")",
           "a file system with room for them");
}

/// Throws where an outcome is not as it was put there, or is one that this program does not have.
void Results::RequireWhole() const
{
    for (std::uint64_t index = 0U; index < size_; ++index)
    {
        Stored stored;
        std::memcpy(&stored, memory_.Begin() + PlaceOf(index), sizeof(stored));
        if (stored.check != CheckOf(stored))
        {
            Refuse(file_, "a damaged outcome of experiment " + std::to_string(NumberAt(index)));
        }
        const Strange strange = (of_.strange_in == nullptr) ? Strange{} : of_.strange_in(At(index));
        if (!strange.wrong.empty())
        {
            Refuse(file_,
                   "row " + std::to_string(index + 1U) + ", experiment " + std::to_string(NumberAt(index)) + ": " +
                       strange.wrong,
                   strange.expected);
        }
    }
}

/// Outcomes without a header may be those of any plan.
void Results::RequireNothing() const
{
    const std::uint8_t* const begin = memory_.Begin();
    if (std::any_of(begin + sizeof(Header), begin + length_, [](const std::uint8_t byte) { return byte != 0U; }))
    {
        Refuse(file_, "outcomes without what they belong to");
    }
}

std::uint32_t* Results::Error() const noexcept
{
    return reinterpret_cast<std::uint32_t*>(memory_.Begin() + length_);
}

void Results::RequireThere() const
{
    if (file_.empty())
    {
        return;
    }
    const std::uint32_t error = __atomic_load_n(Error(), __ATOMIC_ACQUIRE);
    if (error != 0U)
    {
        Refuse(file_, std::string("an outcome that cannot be written (") + std::strerror(static_cast<int>(error)) + ")",
               "a file system with room for it");
    }
    struct stat known = {};
    std::array<std::uint8_t, sizeof(Header)> head{};
    const bool is_there = fstat(open_.Number(), &known) == 0 && static_cast<std::uint64_t>(known.st_size) == length_ &&
                          ReadFrom(open_.Number(), head.data(), head.size()) == head.size() &&
                          std::equal(head.begin(), head.end(), memory_.Begin());
    if (!is_there)
    {
        Refuse(file_, "it was cut or overwritten by somebody else while outcomes were written",
               "a file that this campaign alone writes; what was in it is lost");
    }
}

void Results::RequireKept() const
{
    RequireThere();
    constexpr std::uint64_t kAtOnce = 8192U;
    std::array<Stored, kAtOnce> stored{};
    for (std::uint64_t begin = 0U; begin < size_ && !file_.empty(); begin += kAtOnce)
    {
        const std::uint64_t count = std::min(kAtOnce, size_ - begin);
        const std::size_t bytes = count * sizeof(Stored);
        bool is_kept = pread(open_.Number(), stored.data(), bytes, static_cast<off_t>(PlaceOf(begin))) ==
                       static_cast<ssize_t>(bytes);
        for (std::uint64_t index = begin; index < begin + count && is_kept; ++index)
        {
            // One that is open here may have been put by another process of the same campaign.
            is_kept = At(index).result == Class::kOpen ||
                      std::memcmp(&stored.at(index - begin), memory_.Begin() + PlaceOf(index), sizeof(Stored)) == 0;
        }
        if (!is_kept)
        {
            Refuse(file_, "it was cut or overwritten by somebody else while outcomes were written",
                   "a file that this campaign alone writes; some of its outcomes are lost");
        }
    }
}

Outcome Results::At(const std::uint64_t index) const noexcept
{
    constexpr std::uint8_t three = 0x07U;
    Stored stored;
    std::memcpy(&stored, memory_.Begin() + PlaceOf(index), sizeof(stored));
    return {static_cast<Class>(stored.result_and_detector & three),
            static_cast<Detector>(stored.result_and_detector >> 3U), stored.detail, stored.marks, stored.us};
}

/// First in the file: who is ended in between leaves it open for the others.
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
    if (open_.Number() >= 0 && !IsWritten(open_.Number(), &word, sizeof(word), PlaceOf(index)))
    {
        __atomic_store_n(Error(), static_cast<std::uint32_t>(errno), __ATOMIC_RELEASE);
    }
    auto* const place = reinterpret_cast<std::uint64_t*>(memory_.Begin() + PlaceOf(index));
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
    OpenFile open;
    open.Take(OpenResults(file, Access::kRead));
    const Header header = HeaderIn(file, open.Number());
    if (IsNone(header))
    {
        Refuse(file, "no file of results, or a damaged one");
    }
    return {header.plan, header.total, {header.number, header.count}, header.setting, header.program, nullptr};
}

std::uint64_t OfProgram(const std::uint64_t digest, const char* const program) noexcept
{
    std::uint64_t hash = digest;
    for (const char* character = program; *character != '\0'; ++character)
    {
        hash = With(hash, static_cast<std::uint8_t>(*character));
    }
    return hash;
}

std::uint64_t WithFiles(std::uint64_t digest, const std::vector<std::string>& files)
{
    for (const std::string& file : files)
    {
        const std::string text = cia306::ReadTextFile(file);
        digest = With(digest, text.size());
        for (const char character : text)
        {
            digest = With(digest, static_cast<std::uint8_t>(character));
        }
    }
    return digest;
}

void Results::Merge(const std::string& file)
{
    ResultsOf other_of = Read(file);
    RequireSame(file, HeaderOf(other_of), of_);
    other_of.strange_in = of_.strange_in;
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
