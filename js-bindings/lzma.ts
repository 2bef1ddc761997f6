// Unpacks LZMA, which takes a tenth less than deflate for our wasm and a smaller decoder. After the LZMA
// specification of Igor Pavlov (https://www.7-zip.org/sdk.html, lzma-specification.txt), whose names these are.
// Only what our build packs: whole, with lc = 3, lp = 0, pb = 2 and its length in the header, and never damaged.

/** Probabilities of a zero, of 11 bits. */
type Model = Uint16Array

const model = (size: number): Model => new Uint16Array(size).fill(1024)
const models = (count: number, size: number) => Array.from({ length: count }, () => model(size))

/** Of how long a match is, less 2: eight lengths and eight more by position, or 256 others. */
const lengthModels = () => ({
  choice: model(2),
  low: models(4, 8),
  mid: models(4, 8),
  high: model(256),
})

const headerSize = 13

export function unpack(packed: Uint8Array): Uint8Array {
  const output = new Uint8Array(new DataView(packed.buffer, packed.byteOffset).getUint32(5, true))
  // The first byte of the code is always 0.
  let next = headerSize + 1
  let code = 0
  let range = 0xffffffff
  for (let i = 0; i < 4; i++) code = ((code << 8) | packed[next++]!) >>> 0

  function normalize() {
    if (range >= 2 ** 24) return
    range = (range << 8) >>> 0
    code = ((code << 8) | packed[next++]!) >>> 0
  }

  function bit(of: Model, index: number): 0 | 1 {
    const probability = of[index]!
    const bound = (range >>> 11) * probability
    const isZero = code < bound
    if (isZero) {
      range = bound
      of[index] = probability + ((2048 - probability) >> 5)
    } else {
      code -= bound
      range -= bound
      of[index] = probability - (probability >> 5)
    }
    normalize()
    return isZero ? 0 : 1
  }

  function directBits(count: number): number {
    let result = 0
    while (count-- > 0) {
      range >>>= 1
      const isOne = code >= range
      if (isOne) code -= range
      result = result * 2 + Number(isOne)
      normalize()
    }
    return result
  }

  function tree(of: Model, bits: number): number {
    let node = 1
    for (let i = 0; i < bits; i++) node = node * 2 + bit(of, node)
    return node - 2 ** bits
  }

  function reverseTree(of: Model, bits: number, offset = 0): number {
    let node = 1
    let result = 0
    for (let i = 0; i < bits; i++) {
      const one = bit(of, offset + node)
      node = node * 2 + one
      result |= one << i
    }
    return result
  }

  const matchOrLiteral = models(12, 4)
  const repeats = model(12)
  const notFirst = model(12)
  const notSecond = model(12)
  const notThird = model(12)
  const longFirst = models(12, 4)
  const literals = models(8, 0x300)
  const slots = models(4, 64)
  const distances = model(128)
  const align = model(16)
  const matchLengths = lengthModels()
  const repeatLengths = lengthModels()

  function length({ choice, low, mid, high }: ReturnType<typeof lengthModels>, place: number) {
    if (!bit(choice, 0)) return 2 + tree(low[place]!, 3)
    return bit(choice, 1) ? 18 + tree(high, 8) : 10 + tree(mid[place]!, 3)
  }

  /** Less 1. */
  function distance(length: number): number {
    const slot = tree(slots[Math.min(length - 2, 3)]!, 6)
    if (slot < 4) return slot
    const bits = (slot >> 1) - 1
    const base = (2 | (slot & 1)) << bits
    return bits < 6
      ? base + reverseTree(distances, bits, base - slot)
      : base + directBits(bits - 4) * 16 + reverseTree(align, 4)
  }

  let at = 0
  let state = 0
  // Less 1, latest first.
  let recent = [0, 0, 0, 0]

  function literal(): number {
    const of = literals[at > 0 ? output[at - 1]! >> 5 : 0]!
    let symbol = 1
    if (state >= 7) {
      let match = output[at - recent[0]! - 1]!
      for (let differs = false; symbol < 256 && !differs;) {
        const expected = (match >> 7) & 1
        match <<= 1
        const came = bit(of, ((1 + expected) << 8) + symbol)
        symbol = symbol * 2 + came
        differs = came !== expected
      }
    }
    while (symbol < 256) symbol = symbol * 2 + bit(of, symbol)
    return symbol
  }

  /** Puts the distance of the coming match first; says whether it is that of one of the last four. */
  function repeated(place: number): number {
    if (!bit(notFirst, state)) return bit(longFirst[state]!, place) ? length(repeatLengths, place) : 1
    const which = bit(notSecond, state) ? 2 + bit(notThird, state) : 1
    recent.unshift(...recent.splice(which, 1))
    return length(repeatLengths, place)
  }

  while (at < output.length) {
    const place = at & 3
    if (!bit(matchOrLiteral[state]!, place)) {
      output[at] = literal()
      at++
      state = state < 4 ? 0 : state - (state < 10 ? 3 : 6)
      continue
    }
    const wasLiteral = state < 7
    let size
    if (bit(repeats, state)) {
      size = repeated(place)
      state = wasLiteral ? (size === 1 ? 9 : 8) : 11
    } else {
      size = length(matchLengths, place)
      recent = [distance(size), ...recent.slice(0, 3)]
      state = wasLiteral ? 7 : 10
    }
    for (const from = at - recent[0]! - 1, end = at + size; at < end; at++)
      output[at] = output[from + at - (end - size)]!
  }
  return output
}
