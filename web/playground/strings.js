/** Finds the strings in a sketch and the files that they name, and writes string literals. */
import { javascriptLanguage } from '@codemirror/lang-javascript'

const escapes = { n: '\n', t: '\t', r: '\r', b: '\b', f: '\f', v: '\v', 0: '\0' }

const unescape = (text) =>
  text.replaceAll(
    /\\(?:u\{([\da-f]{1,6})\}|u([\da-f]{4})|x([\da-f]{2})|(\r\n|[^]))/gi,
    (_, long, four, two, sign) => {
      if (sign !== undefined) return /^[\r\n\u2028\u2029]/.test(sign) ? '' : (escapes[sign] ?? sign)
      const code = parseInt(long ?? four ?? two, 16)
      return code <= 0x10ffff ? String.fromCodePoint(code) : ''
    },
  )

/** Finds string literals and templates without substitutions. Returns [{ from, to, value }]; `from` and `to` include the quotes. */
export function stringsIn(text) {
  const strings = []
  javascriptLanguage.parser.parse(text).iterate({
    enter({ name, from, to, node }) {
      const isLiteral =
        name === 'String' || (name === 'TemplateString' && !node.getChild('Interpolation'))
      if (isLiteral) strings.push({ from, to, value: unescape(text.slice(from + 1, to - 1)) })
    },
  })
  return strings
}

const isFileName = (name) =>
  /^[^\n]+\.(?:obj|stl|glb|gltf|bin|woff2?|[to]tf|png|jpe?g|gif|webp|svg|glsl|vert|frag|json|csv|txt)$/i.test(
    name,
  )

/** Returns the file names in a sketch, including those of files that it may only write. */
export const namesOfFiles = (text) => [
  ...new Set(
    stringsIn(text)
      .map(({ value }) => value)
      .filter(isFileName),
  ),
]

/** Replaces each file name in the text by `change(name)`. */
export function replaceFileNames(text, change) {
  let result = text
  for (const { from, to, value } of stringsIn(text).reverse()) {
    if (!isFileName(value) || change(value) === value) continue
    result = result.slice(0, from) + quote(change(value)) + result.slice(to)
  }
  return result
}

const toEscape = (sign) => `\\u${sign.charCodeAt(0).toString(16).padStart(4, '0')}`

/** Writes a text as a string literal. */
export const quote = (text) =>
  `'${text.replaceAll(/[\\']/g, '\\$&').replaceAll(/[\0-\x1f\u2028\u2029]/g, toEscape)}'`
