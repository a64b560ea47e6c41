// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// Any bytes, cut at any place: every element is either malformed with a reason or a message that is written as text
// that is read as the same message.
#include "hal/host/live/socketcand/message.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count);

namespace
{

using counterpoint::host::SocketcandMessage;
using counterpoint::host::SocketcandStream;
using counterpoint::host::SocketcandWord;

void Check(const bool holds)
{
    if (!holds)
    {
        std::abort();
    }
}

void CheckMessage(const SocketcandMessage& message)
{
    Check(message.problem.empty() == (message.word != SocketcandWord::kInvalid));
    Check(message.problem.find_first_of("<>") == std::string::npos);
    Check(message.problem.size() < 240U);
    if (message.problem.empty())
    {
        const std::string text = counterpoint::host::WriteSocketcand(message);
        Check(text.size() <= counterpoint::host::kSocketcandElementBytes);
        Check(counterpoint::host::WriteSocketcand(counterpoint::host::ReadSocketcand(text)) == text);
        Check(message.frame.length_bytes <= counterpoint::host::kClassicalDataBytes);
        Check(message.frame.error || counterpoint::host::IsSendable(message.frame));
    }
}

void Drain(SocketcandStream& stream, std::size_t limit)
{
    while (const std::optional<SocketcandMessage> message = stream.Next())
    {
        CheckMessage(*message);
        Check(limit != 0U); // Each message takes at least one byte away.
        --limit;
    }
}

} // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* const bytes, const std::size_t count)
{
    if (count == 0U)
    {
        return 0;
    }
    const char* const text = reinterpret_cast<const char*>(bytes + 1U);
    const std::size_t length = count - 1U;
    const std::size_t cut = std::min<std::size_t>(bytes[0], length);
    SocketcandStream stream;
    stream.Feed(text, cut);
    Drain(stream, length);
    stream.Feed(text + cut, length - cut);
    Drain(stream, length + 1U);
    return 0;
}
