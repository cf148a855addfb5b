#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <vector>

namespace ex03 {

/// Copies as many items as there is room for; returns how many there are.
template <typename Item, typename Out>
uint64_t copyOut(const std::vector<Item>& items, Out* out, uint64_t capacity) {
    const uint64_t count = std::min<uint64_t>(items.size(), capacity);
    if (count > 0) {
        std::memcpy(out, items.data(), count * sizeof(Item));
    }
    return items.size();
}

/// Items with room behind the last one, as push_back leaves it, and not clean: who takes
/// `capacity()` for `size()` meets there what does not exist. Without items there is no room, and
/// none where a sanitizer watches: reading one item too far must leave the memory that is ours.
template <typename Item>
std::vector<Item> copyIn(const void* data, uint64_t count, const Item& stray = {}) {
    const size_t spare = count == 0 ? 0 : EX03_SPARE;
    const auto* first = static_cast<const Item*>(data);
    std::vector<Item> items;
    // Throws for any count that `first + count` could not express.
    items.reserve(std::max(count, count + spare));
    items.assign(first, first + count);
    items.resize(count + spare, stray);
    items.resize(count);
    return items;
}

} // namespace ex03
