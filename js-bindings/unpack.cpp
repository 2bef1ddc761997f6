// Unpacks LZMA: the other wasm modules are inlined packed, which takes a tenth less than deflate,
// and a decoder in wasm is smaller and starts faster than one in JavaScript. After Igor Pavlov's
// LZMA specification (https://www.7-zip.org/sdk.html, lzma-specification.txt), and only what our
// build packs: whole, with lc = 3, lp = 0, pb = 2, and never damaged. It imports nothing and
// allocates nothing: js-bindings/wasm.ts lays out its memory.
#include <emscripten.h>

#include <cstdint>

namespace {

using Byte = std::uint8_t;

// The probability of a zero, of 2048.
using Model = std::uint16_t;

constexpr int states = 12;
constexpr int places = 4;

struct LengthModels {
  Model isLong, isLongest;
  Model low[places][8], mid[places][8], high[256];
};

struct Models {
  Model isMatch[states][places];
  Model isRepeat[states], isNotFirst[states], isNotSecond[states], isNotThird[states];
  Model isFirstLong[states][places];
  Model slots[4][64], distances[128], align[16];
  LengthModels matchLength, repeatLength;
  Model literals[8][0x300];
};

// Static, since the stack of this module is small.
union {
  Models models;
  Model all[sizeof(Models) / sizeof(Model)];
};

const Byte* input;
std::uint32_t range;
std::uint32_t code;

void normalize() {
  if (range >= 1u << 24) return;
  range <<= 8;
  code = code << 8 | *input++;
}

std::uint32_t bit(Model& model) {
  const std::uint32_t bound = (range >> 11) * model;
  const bool isOne = code >= bound;
  if (isOne) {
    code -= bound;
    range -= bound;
    model = static_cast<Model>(model - (model >> 5));
  } else {
    range = bound;
    model = static_cast<Model>(model + ((2048 - model) >> 5));
  }
  normalize();
  return isOne;
}

std::uint32_t tree(Model* of, int bits) {
  std::uint32_t node = 1;
  for (int i = 0; i < bits; ++i) node = node << 1 | bit(of[node]);
  return node - (1u << bits);
}

std::uint32_t reverseTree(Model* of, int bits) {
  std::uint32_t node = 1;
  std::uint32_t result = 0;
  for (int i = 0; i < bits; ++i) {
    const std::uint32_t one = bit(of[node]);
    node = node << 1 | one;
    result |= one << i;
  }
  return result;
}

std::uint32_t directBits(int bits) {
  std::uint32_t result = 0;
  for (int i = 0; i < bits; ++i) {
    range >>= 1;
    const bool isOne = code >= range;
    if (isOne) code -= range;
    result = result << 1 | isOne;
    normalize();
  }
  return result;
}

std::uint32_t length(LengthModels& of, std::uint32_t place) {
  if (!bit(of.isLong)) return 2 + tree(of.low[place], 3);
  return bit(of.isLongest) ? 18 + tree(of.high, 8) : 10 + tree(of.mid[place], 3);
}

// Less 1.
std::uint32_t distance(std::uint32_t length) {
  const std::uint32_t slot = tree(models.slots[length < 5 ? length - 2 : 3], 6);
  if (slot < 4) return slot;
  const int bits = static_cast<int>(slot >> 1) - 1;
  const std::uint32_t base = (2 | (slot & 1)) << bits;
  if (bits < 6) return base + reverseTree(models.distances + base - slot, bits);
  const std::uint32_t high = directBits(bits - 4) << 4;
  return base + high + reverseTree(models.align, 4);
}

// After a match, the byte that would have continued it predicts this one.
Byte literal(Model* of, bool followsMatch, std::uint32_t match) {
  std::uint32_t symbol = 1;
  while (followsMatch && symbol < 256) {
    match <<= 1;
    const std::uint32_t expected = match >> 8 & 1;
    const std::uint32_t came = bit(of[((1 + expected) << 8) + symbol]);
    symbol = symbol << 1 | came;
    followsMatch = came == expected;
  }
  while (symbol < 256) symbol = symbol << 1 | bit(of[symbol]);
  return static_cast<Byte>(symbol);
}

// In the place of the entry `last`; those before it move up.
void putFirst(std::uint32_t* entries, std::uint32_t last, std::uint32_t value) {
  for (; last > 0; --last) entries[last] = entries[last - 1];
  entries[0] = value;
}

}  // namespace

// `packed` is what follows the header, `size` how long the output is.
extern "C" EMSCRIPTEN_KEEPALIVE void unpack(const Byte* packed, Byte* output, std::uint32_t size) {
  for (Model& model : all) model = 1024;
  range = 0xffffffff;
  code = 0;
  // The first byte is always 0.
  input = packed + 1;
  for (int i = 0; i < 4; ++i) code = code << 8 | *input++;

  // Less 1, latest first.
  std::uint32_t recent[4] = {};
  int state = 0;
  for (std::uint32_t at = 0; at < size;) {
    const std::uint32_t place = at % places;
    const bool followsMatch = state >= 7;
    const Byte* match = output + at - recent[0] - 1;
    if (!bit(models.isMatch[state][place])) {
      output[at] = literal(models.literals[at ? output[at - 1] >> 5 : 0], followsMatch,
                           followsMatch ? *match : 0);
      ++at;
      state = state < 4 ? 0 : state - (state < 10 ? 3 : 6);
      continue;
    }
    std::uint32_t count = 0;
    if (!bit(models.isRepeat[state])) {
      count = length(models.matchLength, place);
      putFirst(recent, 3, distance(count));
      state = followsMatch ? 10 : 7;
    } else {
      bool isShort = false;
      if (bit(models.isNotFirst[state])) {
        const std::uint32_t which =
            bit(models.isNotSecond[state]) ? 2 + bit(models.isNotThird[state]) : 1;
        putFirst(recent, which, recent[which]);
      } else {
        isShort = !bit(models.isFirstLong[state][place]);
      }
      count = isShort ? 1 : length(models.repeatLength, place);
      state = followsMatch ? 11 : isShort ? 9 : 8;
    }
    match = output + at - recent[0] - 1;
    for (; count > 0; --count) output[at++] = *match++;
  }
}
