#include "module/label.hpp"

#include <algorithm>
#include <numeric>
#include <span>
#include <utility>

#include "module/syntax.hpp"

namespace warpjet {

namespace {

using Tokens = std::vector<std::string_view>;

bool endsOperand(std::string_view token) {
  return isWordPart(token.back()) || token == ")" || token == "]";
}

// Removes parentheses around a single operand, as in (p).x.
Tokens removeRedundantParentheses(std::string_view text) {
  struct Level {
    std::size_t open;
    bool isGroup;  // neither a call nor an index
    bool isOperand = true;
  };
  Tokens result;
  std::vector<Level> levels;
  for (const std::string_view token : tokensOf(text)) {
    if (token == "(" || token == "[") {
      levels.push_back({result.size(), result.empty() || !endsOperand(result.back())});
      result.push_back(token);
      continue;
    }
    if (token != ")" && token != "]") {
      result.push_back(token);
      if (!endsOperand(token) && token != "." && !levels.empty()) levels.back().isOperand = false;
      continue;
    }
    const Level level = levels.back();
    levels.pop_back();
    if (level.isGroup && level.isOperand)
      result.erase(result.begin() + static_cast<std::ptrdiff_t>(level.open));
    else
      result.push_back(token);
  }
  return result;
}

// Removes parentheses around the whole expression.
std::span<const std::string_view> unwrap(std::span<const std::string_view> tokens) {
  if (tokens.size() < 3 || tokens.front() != "(" || tokens.back() != ")") return tokens;
  int depth = 0;
  for (const std::string_view token : tokens.first(tokens.size() - 1)) {
    if (token == "(") ++depth;
    if (token == ")" && --depth == 0) return tokens;
  }
  return tokens.subspan(1, tokens.size() - 2);
}

// Parses `xz` as 0 and 2, in one of three alphabets; other names are members.
Selector selectorOf(std::string_view name) {
  for (const std::string_view letters : {"xyzw", "rgba", "stpq"}) {
    std::vector<int> indices;
    for (const char letter : name) {
      const std::size_t at = letters.find(letter);
      if (at != letters.npos) indices.push_back(static_cast<int>(at));
    }
    if (indices.size() == name.size() && name.size() <= 4) return {{}, indices, false};
  }
  return {std::string(name), {}, false};
}

// The last selector, and the index of its first token.
struct LastSelector {
  Selector selector;
  std::size_t begin;
};

std::optional<LastSelector> lastSelector(std::span<const std::string_view> tokens) {
  const std::size_t n = tokens.size();
  if (n >= 3 && tokens[n - 2] == "." && isWordStart(tokens[n - 1][0]))
    return LastSelector{selectorOf(tokens[n - 1]), n - 2};
  if (n >= 4 && tokens[n - 1] == "]" && tokens[n - 3] == "[" && tokens[n - 2].size() == 1 &&
      isDigit(tokens[n - 2][0]))
    return LastSelector{{{}, {tokens[n - 2][0] - '0'}, true}, n - 3};
  return {};
}

std::string join(std::span<const std::string_view> tokens, std::string_view between) {
  std::string text;
  for (const std::string_view token : tokens) {
    if (!text.empty()) text += between;
    text += token;
  }
  return text;
}

// Returns true if there is no operator outside of brackets, so that a selector at the end applies
// to the whole expression.
bool isOneOperand(std::span<const std::string_view> tokens) {
  int depth = 0;
  for (const std::string_view token : tokens) {
    if (token == ")" || token == "]") --depth;
    if (depth == 0 && !endsOperand(token) && token != "." && token != "(" && token != "[")
      return false;
    if (token == "(" || token == "[") ++depth;
  }
  return true;
}

bool isReference(std::span<const std::string_view> root) {
  return root.size() == 1 && isWordStart(root[0][0]);
}

}  // namespace

Label readLabel(std::string_view text) {
  const Tokens tokens = removeRedundantParentheses(text);
  std::span<const std::string_view> root = unwrap(tokens);
  Label label;
  while (isOneOperand(root)) {
    auto last = lastSelector(root);
    if (!last) break;
    label.selectors.insert(label.selectors.begin(), std::move(last->selector));
    root = root.first(last->begin);
  }
  label.text = isReference(root) ? join(unwrap(tokens), "") : std::string(text);
  label.root = join(unwrap(root), " ");
  return label;
}

bool isWithin(const Label& part, const Label& whole) {
  return part.root == whole.root && part.selectors.size() >= whole.selectors.size() &&
         std::equal(whole.selectors.begin(), whole.selectors.end(), part.selectors.begin());
}

// Returns the position of components in a selection: of p.zx, p.x is the second.
static std::optional<std::vector<int>> partOfSelection(const Label& whole, const Label& part) {
  const std::size_t last = whole.selectors.size() - 1;
  const bool differsOnlyInLast =
      part.root == whole.root && part.selectors.size() == last + 1 &&
      std::equal(part.selectors.begin(), part.selectors.begin() + last, whole.selectors.begin()) &&
      part.selectors[last].name.empty();
  if (!differsOnlyInLast) return {};
  const std::vector<int>& selected = whole.selectors[last].indices;
  std::vector<int> positions;
  for (const int index : part.selectors[last].indices) {
    const auto found = std::find(selected.begin(), selected.end(), index);
    if (found == selected.end()) return {};
    positions.push_back(static_cast<int>(found - selected.begin()));
  }
  return positions;
}

std::optional<std::vector<int>> partOf(const Label& whole, Shape shape, const Label& part) {
  if (shape == imageShape) return {};
  const bool isSelection = shape.isVector() && !whole.selectors.empty() &&
                           static_cast<int>(whole.selectors.back().indices.size()) == shape.rows;
  if (!isWithin(part, whole)) return isSelection ? partOfSelection(whole, part) : std::nullopt;
  std::vector<int> components(static_cast<std::size_t>(shape.size()));
  std::iota(components.begin(), components.end(), 0);
  for (std::size_t i = whole.selectors.size(); i < part.selectors.size(); ++i) {
    const Selector& selector = part.selectors[i];
    const int count = shape.isMatrix() ? shape.columns : shape.rows;
    const bool isMissing = !selector.name.empty() || shape.isNumber() ||
                           std::any_of(selector.indices.begin(), selector.indices.end(),
                                       [&](int index) { return index >= count; });
    if (isMissing || (shape.isMatrix() && !selector.isIndex)) return {};
    const int size = shape.isMatrix() ? shape.rows : 1;
    std::vector<int> selected;
    for (const int index : selector.indices) {
      const auto first = components.begin() + index * size;
      selected.insert(selected.end(), first, first + size);
    }
    components = std::move(selected);
    shape = vectorOf(static_cast<int>(components.size()));
  }
  return components;
}

bool mayOverlap(const Label& a, const Label& b) {
  if (a.root != b.root) return false;
  for (std::size_t i = 0; i < std::min(a.selectors.size(), b.selectors.size()); ++i) {
    const Selector &x = a.selectors[i], &y = b.selectors[i];
    if (x.name != y.name) return false;
    const bool isDisjoint =
        std::find_first_of(x.indices.begin(), x.indices.end(), y.indices.begin(),
                           y.indices.end()) == x.indices.end();
    if (x.name.empty() && isDisjoint) return false;
  }
  return true;
}

}  // namespace warpjet
