// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/monitor/recording.hpp"

#include "canopen/monitor/readers.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <system_error>
#include <utility>

namespace counterpoint::monitor
{
namespace
{
constexpr std::size_t kMostBytes = 2U * 1024U * 1024U * 1024U;

[[noreturn]] void Refuse(const std::string& path, const std::string& wrong, const std::string& expected)
{
    throw cia306::InputError(path, {}, {wrong, expected});
}
void RefuseCompressed(const std::string& file, const std::string_view magic)
{
    constexpr std::array<std::pair<std::string_view, const char*>, 3U> kinds{
        {{"\x1F\x8B", "gzip"}, {"\xFD\x37zX", "xz"}, {"\x28\xB5\x2F\xFD", "zstd"}}};
    for (const auto& [begin, name] : kinds)
    {
        if (magic.substr(0U, begin.size()) == begin)
        {
            Refuse(file, std::string("it is compressed (") + name + ")", "the recording itself, unpacked");
        }
    }
}
} // namespace

InterfaceChoice::InterfaceChoice(std::string wanted) : wanted_(std::move(wanted))
{
}

bool InterfaceChoice::Takes(const std::string_view key, const std::initializer_list<std::string_view> names,
                            const Time time)
{
    const bool is_candidate = wanted_.empty() || std::find(names.begin(), names.end(), wanted_) != names.end();
    if (!key_ && is_candidate)
    {
        key_ = std::string(key);
    }
    const bool is_taken = key_ == key;
    other_frames_ += is_taken ? 0U : 1U;
    other_last_ = is_taken ? other_last_ : std::max(other_last_, time);
    return is_taken;
}

Origin InterfaceChoice::Seen() const
{
    return {key_.value_or(""), other_frames_, other_last_, ""};
}

std::string ReadRecording(const std::string& path)
{
    const std::string kinds = "a recording of candump -l, pcap or pcapng";
    std::error_code error;
    const std::filesystem::file_status status = std::filesystem::status(path, error);
    const bool is_regular = std::filesystem::is_regular_file(status);
    const std::uintmax_t size = is_regular ? std::filesystem::file_size(path, error) : 0U;
    // A size that cannot be told is the greatest of all. Looked at before it is opened: opening a pipe without a writer
    // would wait for one.
    if (std::filesystem::exists(status) && (!is_regular || size > kMostBytes))
    {
        Refuse(path, "it is no regular file of up to 2 GB", kinds);
    }
    std::ifstream file(path, std::ios::binary);
    if (!file)
    {
        Refuse(path, std::string("it cannot be opened (") + std::strerror(errno) + ")", "a readable recording");
    }
    if (size == 0U)
    {
        Refuse(path, "it is empty", kinds);
    }
    std::string bytes(static_cast<std::size_t>(size), '\0');
    file.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    bytes.resize(static_cast<std::size_t>(file.gcount())); // It became shorter: what was read is what there is.
    return bytes;
}

std::unique_ptr<FrameSource> OpenRecording(const std::string& file, const std::string_view bytes,
                                           const RecordingOptions& options)
{
    const std::string_view magic = bytes.substr(0U, 4U);
    RefuseCompressed(file, magic);
    if (magic == "\x0A\x0D\x0D\x0A")
    {
        return std::make_unique<PcapngReader>(file, bytes, options);
    }
    const bool is_pcap = magic == "\xA1\xB2\xC3\xD4" || magic == "\xD4\xC3\xB2\xA1" || magic == "\xA1\xB2\x3C\x4D" ||
                         magic == "\x4D\x3C\xB2\xA1";
    if (is_pcap)
    {
        return std::make_unique<PcapReader>(file, bytes, options);
    }
    return std::make_unique<CandumpReader>(file, bytes, options);
}
} // namespace counterpoint::monitor
