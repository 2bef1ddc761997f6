// Reads the signatures of exported functions from the sections of a wasm module.

const kinds = { 0x7f: 'number', 0x7e: 'bigint', 0x7d: 'number', 0x7c: 'number' }

const [typeSection, importSection, functionSection, exportSection] = [1, 2, 3, 7]

/**
 * Maps the name of each export → { parameters, result }, TypeScript types. Wasm's vector types, for which JavaScript has none, are `never`.
 */
export function wasmSignatures(bytes) {
  // Skips the magic number and the version.
  let offset = 8
  const readNumber = () => {
    let value = 0
    for (let shift = 0; ; shift += 7) {
      const byte = bytes[offset++]
      value += (byte & 127) * 2 ** shift
      if (byte < 128) return value
    }
  }
  const readList = (readItem) => Array.from({ length: readNumber() }, readItem)
  const readText = () => {
    const size = readNumber()
    return new TextDecoder().decode(bytes.subarray(offset, (offset += size)))
  }
  const readValueType = () => kinds[bytes[offset++]] ?? 'never'
  const skipLimits = () => {
    if (readNumber() & 1) readNumber()
    readNumber()
  }
  const skipImport = [readNumber, () => (offset++, skipLimits()), skipLimits, () => (offset += 2)]

  let types = []
  const functions = []
  const exported = new Map()
  const readSection = {
    [typeSection]: () => {
      types = readList(() => {
        offset++ // 0x60, a function
        const parameters = readList(readValueType)
        const [result = 'void'] = readList(readValueType)
        return { parameters, result }
      })
    },
    [importSection]: () =>
      readList(() => {
        readText()
        readText()
        const kind = bytes[offset++]
        const type = skipImport[kind]()
        if (kind === 0) functions.push(types[type])
      }),
    [functionSection]: () => functions.push(...readList(() => types[readNumber()])),
    [exportSection]: () =>
      readList(() => {
        const name = readText()
        const kind = bytes[offset++]
        const index = readNumber()
        if (kind === 0) exported.set(name, functions[index])
      }),
  }
  while (offset < bytes.length) {
    const section = bytes[offset++]
    const end = readNumber() + offset
    readSection[section]?.()
    offset = end
  }
  return exported
}
