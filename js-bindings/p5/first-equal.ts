/**
 * For each row of a table, the first whose `columns` hold the same numbers: by a hash table of row numbers, where keys of texts take ten
 * times as long.
 */
export function firstEqual(table: Float64Array, width: number, columns: number): Int32Array {
  // Two words for each number; there are two zeros, of which adding 0 makes one.
  const words = new Int32Array(table.map((x) => x + 0).buffer)
  const first = new Int32Array(table.length / width)
  const mask = 2 ** Math.ceil(Math.log2(2 * first.length + 2)) - 1
  const slots = new Int32Array(mask + 1).fill(-1)
  const areSame = (a: number, b: number) => {
    for (let i = 0; i < 2 * columns; i++)
      if (words[2 * width * a + i] !== words[2 * width * b + i]) return false
    return true
  }
  for (let row = 0; row < first.length; row++) {
    let slot = 0
    for (let i = 0; i < 2 * columns; i++) {
      slot = Math.imul(slot ^ words[2 * width * row + i]!, 0x5bd1e995)
      slot ^= slot >>> 15
    }
    while (slots[(slot &= mask)]! >= 0 && !areSame(slots[slot]!, row)) slot++
    if (slots[slot]! < 0) slots[slot] = row
    first[row] = slots[slot]!
  }
  return first
}
