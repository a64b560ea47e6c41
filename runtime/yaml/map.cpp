// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "runtime/yaml/map.hpp"

#include "canopen/cia306/text/nearest_word.hpp"

#include <algorithm>

namespace counterpoint::runtime
{

YamlMap::YamlMap(const std::string& file, const YamlNode& node, const std::initializer_list<const char*> known)
    : file_(file), value_(file, node)
{
    std::string names;
    for (const char* const name : known)
    {
        names += (names.empty() ? "" : ", ") + std::string(name);
    }
    if (node.kind != YamlKind::kMap)
    {
        value_.Refuse(WhatIs(node), "a map with " + names);
    }
    for (std::size_t place = 0U; place + 1U < node.items.size(); place += 2U)
    {
        const YamlNode& key = node.items[place];
        const bool is_known =
            std::any_of(known.begin(), known.end(), [&key](const char* const name) { return key.scalar == name; });
        if (!is_known)
        {
            YamlValue(file_, key)
                .Refuse("unknown key " + Shown(key.scalar) +
                            cia306::DidYouMean(key.scalar, {known.begin(), known.end()}),
                        names);
        }
        for (std::size_t before = 0U; before < place; before += 2U)
        {
            if (node.items[before].scalar == key.scalar)
            {
                YamlValue(file_, key).Refuse("key " + Shown(key.scalar) + " twice", "each key once");
            }
        }
    }
}

std::optional<YamlValue> YamlMap::Find(const std::string& name) const
{
    const std::vector<YamlNode>& items = value_.Node().items;
    for (std::size_t place = 0U; place + 1U < items.size(); place += 2U)
    {
        if (items[place].scalar == name)
        {
            return YamlValue(file_, items[place + 1U]);
        }
    }
    return std::nullopt;
}

std::map<std::string, Place> YamlMap::Places() const
{
    std::map<std::string, Place> places;
    const std::vector<YamlNode>& items = value_.Node().items;
    for (std::size_t place = 0U; place + 1U < items.size(); place += 2U)
    {
        const bool is_one = items[place + 1U].kind == YamlKind::kScalar;
        places[items[place].scalar] = items[is_one ? place + 1U : place].place;
    }
    return places;
}

YamlValue YamlMap::Require(const std::string& name) const
{
    const std::optional<YamlValue> found = Find(name);
    if (!found)
    {
        value_.Refuse("no key '" + name + "'", "it here");
    }
    return *found;
}
} // namespace counterpoint::runtime
