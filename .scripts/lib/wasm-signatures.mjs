// Reads the signatures of exported functions from the sections of a wasm module.

const kinds = { 0x7f: 'number', 0x7e: 'bigint', 0x7d: 'number', 0x7c: 'number' }

const [typeSection, importSection, functionSection, exportSection] = [1, 2, 3, 7]

/** Maps the name of each export → { given, result }, TypeScript types. Vectors, which JavaScript cannot hold, are `never`. */
export function wasmSignatures(bytes) {
  let at = 8
  const number = () => {
    let value = 0
    for (let shift = 0; ; shift += 7) {
      const byte = bytes[at++]
      value += (byte & 127) * 2 ** shift
      if (byte < 128) return value
    }
  }
  const list = (read) => Array.from({ length: number() }, read)
  const text = () => {
    const size = number()
    return new TextDecoder().decode(bytes.subarray(at, (at += size)))
  }
  const valueType = () => kinds[bytes[at++]] ?? 'never'
  const limits = () => {
    if (number() & 1) number()
    number()
  }
  const skipImport = [number, () => (at++, limits()), limits, () => (at += 2)]

  let types = []
  const functions = []
  const exported = new Map()
  const read = {
    [typeSection]: () => {
      types = list(() => {
        at++ // 0x60, a function
        const given = list(valueType)
        const [result = 'void'] = list(valueType)
        return { given, result }
      })
    },
    [importSection]: () =>
      list(() => {
        text()
        text()
        const kind = bytes[at++]
        const type = skipImport[kind]()
        if (kind === 0) functions.push(types[type])
      }),
    [functionSection]: () => functions.push(...list(() => types[number()])),
    [exportSection]: () =>
      list(() => {
        const name = text()
        const kind = bytes[at++]
        const index = number()
        if (kind === 0) exported.set(name, functions[index])
      }),
  }
  while (at < bytes.length) {
    const section = bytes[at++]
    const end = number() + at
    read[section]?.()
    at = end
  }
  return exported
}
