// Splits the body of a GLSL function into statements, and finds the variables that each statement reads and writes.

export interface Statement {
  text: string
  /** `true` for a statement with braces, such as a loop. */
  isBlock: boolean
  /** `true` for a line of the preprocessor. */
  isDirective: boolean
  reads: ReadonlySet<string>
  writes: ReadonlySet<string>
  /** Functions of the source that the statement calls, also indirectly. */
  calls: ReadonlySet<string>
}

/** Attributes, which no function can change. */
const attributes = new Set(['position', 'normal', 'uv', 'color', 'tangent'])

/** The globals that a function of the source, or a function that it calls, reads and writes. */
export interface Effects {
  reads: Set<string>
  writes: Set<string>
  calls: Set<string>
  /** True if the function writes to variables that are passed to it. */
  hasOutputs: boolean
}

const words = (text: string) => text.match(/(?<![.\w])[A-Za-z_]\w*/g) ?? []

const assigned = /(?<![.\w])([A-Za-z_]\w*)\s*(?:\.\w+\s*|\[[^\]]*\]\s*)*(?:[-+*/]?=(?!=)|\+\+|--)/g

/** Matches a declaration with or without a value. */
const declaration =
  /^\s*(?:const\s+)?(?:(?:high|medium|low)p\s+)?(?:float|int|uint|bool|[biu]?vec[234]|mat[234](?:x[234])?)\s+(\w+)/

export function writtenIn(text: string): Set<string> {
  const written = new Set([...text.matchAll(assigned)].map(([, name]) => name!))
  const [, declared] = declaration.exec(text) ?? []
  if (declared) written.add(declared)
  return written
}

/** Maps a variable that the statements declare → its type. */
export const localTypes = (statements: readonly Statement[]) =>
  new Map(
    statements.flatMap(({ text }) => {
      const name = declaredBy(text)
      const [, type] = /(\w+)\s+\w+$/.exec(declaration.exec(text)?.[0] ?? '') ?? []
      return name && type ? [[name, type] as const] : []
    }),
  )

/** Returns the first name that a statement declares; `undefined` if it declares none. */
export const declaredBy = (text: string) => declaration.exec(text)?.[1]

/** Splits a body into statements. `body` has no comments. */
export function statementsOf(body: string, effects: ReadonlyMap<string, Effects>): Statement[] {
  return splitBody(body)
    .flatMap(splitDeclarators)
    .map((text) => {
      const isDirective = /^\s*#/.test(text)
      if (isDirective)
        return { text, isBlock: false, isDirective, reads: none, writes: none, calls: none }
      const reads = new Set<string>(words(text))
      const writes = writtenIn(text)
      const calls = new Set<string>()
      for (const name of [...reads]) {
        const effect = effects.get(name)
        if (!effect) continue
        calls.add(name)
        for (const each of effect.calls) calls.add(each)
        for (const each of effect.reads) reads.add(each)
        for (const each of effect.writes) writes.add(each)
        if (effect.hasOutputs)
          for (const word of words(text))
            if (!effects.has(word) && !attributes.has(word)) writes.add(word)
      }
      // An assignment without an operator does not read the variable.
      const [, target] = /^\s*(\w+)\s*=(?!=)/.exec(text) ?? []
      if (target && words(text).filter((word) => word === target).length === 1) reads.delete(target)
      return { text, isBlock: /[{}]/.test(text), isDirective, reads, writes, calls }
    })
}

const none: ReadonlySet<string> = new Set()

/** Splits `vec3 a = …, b = …;` into a statement for each variable. */
function splitDeclarators(text: string): string[] {
  const [head] = declaration.exec(text) ?? []
  if (!head || /[{}]/.test(text)) return [text]
  const parts: string[] = []
  let depth = 0
  let start = 0
  for (let i = 0; i < text.length; i++) {
    if ('(['.includes(text[i]!)) depth++
    if (')]'.includes(text[i]!)) depth--
    if (text[i] !== ',' || depth > 0) continue
    parts.push(text.slice(start, i))
    start = i + 1
  }
  parts.push(text.slice(start))
  const type = head.replace(/\w+$/, '')
  return parts.map((part, i) => (i === 0 ? part : type + part) + (i < parts.length - 1 ? ';' : ''))
}

function splitBody(body: string): string[] {
  const parts: string[] = []
  let start = 0
  let depth = 0
  const endStatement = (i: number) => {
    const text = body.slice(start, i)
    if (text.trim()) parts.push(text)
    start = i
  }
  for (let i = 0; i < body.length; i++) {
    const character = body[i]!
    if (character === '#' && depth === 0 && body.slice(start, i).trim() === '') {
      const line = body.indexOf('\n', i)
      i = line < 0 ? body.length - 1 : line
      endStatement(i + 1)
    } else if ('({['.includes(character)) depth++
    else if (')}]'.includes(character)) {
      depth--
      if (
        depth === 0 &&
        character === '}' &&
        !/^\s*(?:else\b|while\b|[;,.])/.test(body.slice(i + 1))
      )
        endStatement(i + 1)
    } else if (character === ';' && depth === 0 && !/^\s*else\b/.test(body.slice(i + 1)))
      endStatement(i + 1)
  }
  endStatement(body.length)
  return parts
}

/** Returns the effects of each function above `main` on the variables outside of functions. */
export function effectsOf(top: string, globals: ReadonlySet<string>): Map<string, Effects> {
  const effects = new Map<string, Effects>()
  const head = /\b\w+\s+(\w+)\s*\(([^(){}]*)\)\s*\{/g
  for (let match = head.exec(top); match; match = head.exec(top)) {
    const end = findClosing(top, head.lastIndex - 1)
    const text = top.slice(head.lastIndex, end)
    const parameters = new Set(words(match[2]!))
    const isGlobal = (name: string) => globals.has(name) && !parameters.has(name)
    const effect: Effects = {
      reads: new Set(words(text).filter(isGlobal)),
      writes: new Set([...writtenIn(text)].filter(isGlobal)),
      calls: new Set(),
      hasOutputs: /\b(?:in)?out\b/.test(match[2]!),
    }
    for (const word of words(text)) {
      const called = effects.get(word)
      if (!called) continue
      effect.calls.add(word)
      for (const each of called.calls) effect.calls.add(each)
      for (const each of called.reads) effect.reads.add(each)
      for (const each of called.writes) effect.writes.add(each)
    }
    effects.set(match[1]!, effect)
    head.lastIndex = end
  }
  return effects
}

function findClosing(text: string, open: number): number {
  let depth = 0
  for (let i = open; i < text.length; i++) {
    if (text[i] === '{') depth++
    if (text[i] === '}' && --depth === 0) return i
  }
  return text.length
}
