// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_CAMPAIGN_WORD_LIST_HPP
#define VERIFICATION_CAMPAIGN_WORD_LIST_HPP

#include "runtime/yaml/map.hpp"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <optional>
#include <string>
#include <vector>

// Words of a plan: one for a meaning, and the lists of them that choose what is tried.
namespace counterpoint::campaign
{

/// The title of a plan, which is the first line of its report.
[[nodiscard]] inline std::string TitleOf(const runtime::YamlMap& map)
{
    const runtime::YamlValue title = map.Require("title");
    const std::string text = title.Text("a title");
    if (text.find_first_not_of(' ') == std::string::npos)
    {
        title.Refuse("an empty title", "what the report is called");
    }
    return text;
}

/// @brief The word of a meaning; "?" where the table has none.
template <typename Meaning, std::size_t kCount>
[[nodiscard]] const char* TextOf(const runtime::Word<Meaning> (&words)[kCount], const Meaning meaning)
{
    const auto* const found =
        std::find_if(std::begin(words), std::end(words),
                     [meaning](const runtime::Word<Meaning>& word) { return word.meaning == meaning; });
    return (found == std::end(words)) ? "?" : found->text;
}

/// @brief The words of a list, in its order; all of the table where the key is missing, and then no sources.
/// @param sources Where each word stands, if it is asked for. An empty list, and a word twice, are refused at their
///        place.
template <typename Meaning, std::size_t kCount>
[[nodiscard]] std::vector<Meaning> Chosen(const runtime::YamlMap& map, const char* const key,
                                          const runtime::Word<Meaning> (&words)[kCount],
                                          std::vector<runtime::Source>* const sources = nullptr)
{
    std::vector<Meaning> chosen;
    const std::optional<runtime::YamlValue> list = map.Find(key);
    if (!list)
    {
        for (const runtime::Word<Meaning>& word : words)
        {
            chosen.push_back(word.meaning);
        }
        return chosen;
    }
    for (const runtime::YamlValue& item : list->Items("a list of words"))
    {
        const Meaning meaning = item.Choice(words);
        if (std::find(chosen.begin(), chosen.end(), meaning) != chosen.end())
        {
            item.Refuse("the same word twice", "each once");
        }
        chosen.push_back(meaning);
        if (sources != nullptr)
        {
            sources->push_back(item.Where());
        }
    }
    if (chosen.empty())
    {
        list->Refuse("an empty list", "at least one word");
    }
    return chosen;
}

} // namespace counterpoint::campaign

#endif
