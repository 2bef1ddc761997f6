/** The page of a sketch as a file of its own. */
import { javascriptLanguage } from '@codemirror/lang-javascript'
import { hosts, isThree, tagsOf } from './hosts.js'

/** JSON inside a script tag. */
export const jsonInside = (value) => JSON.stringify(value).replaceAll('<', '\\u003C')

/** An HTML parser takes this for the end of a script or, after a comment has begun, for another script in it. */
const dangerous = /<(?=\/script|!--|script)/gi

/**
 * JavaScript inside a script tag: nothing in it may end the tag, and it means the same. Outside of strings `<script` stays, as in
 * `a<scripts.length`: it is dangerous after `<!--` alone, which does not stay.
 */
export function insideScript(text, { isModule = false } = {}) {
  const found = [...text.matchAll(dangerous)]
  if (!found.length) return text
  const tree = javascriptLanguage.parser.parse(text)
  let result = text
  for (const { index } of found.reverse()) {
    const rest = text.slice(index, index + 4)
    const kind = kindAt(tree, index)
    let sign = '<'
    if (kind === 'String' || kind === 'RegExp') sign = isEscaped(text, index) ? 'u003C' : '\\u003C'
    else if (kind === 'TemplateString') sign = "<${''}"
    else if (rest.startsWith('</')) sign = '< '
    // In a classic script it begins a comment of one line.
    else if (rest === '<!--') sign = isModule || kind ? '< ' : '//'
    result = result.slice(0, index) + sign + result.slice(index + 1)
  }
  return result
}

const kinds = ['String', 'TemplateString', 'RegExp', 'LineComment', 'BlockComment']

/** Returns the kind of text around a place, `undefined` in code. */
function kindAt(tree, at) {
  for (let node = tree.resolveInner(at, 1); node; node = node.parent) {
    if (node.name === 'Interpolation') return undefined
    if (kinds.includes(node.name)) return node.name
  }
  return undefined
}

const isEscaped = (text, at) => /(?<!\\)(?:\\\\)*\\$/.test(text.slice(Math.max(0, at - 20), at))

export const tag = (path) => `<script src="${path}"></script>`

/**
 * `before` stands in front of the libraries, `after` behind them; `sketch` is the sketch's own tag. `tags` and `modules` have
 * the libraries in other words than by their paths in the examples, and `style` another look than the host's.
 */
export function pageOf(
  setting,
  { title, base = '', before = '', after = '', sketch, tags, modules, style },
) {
  const host = hosts[setting.host]
  const map = modules ?? host.modules
  return `<!doctype html>
<html lang="en">
  <head>
    <meta charset="utf-8" />
    <meta name="viewport" content="width=device-width" />
    <title>${title}</title>
    <link rel="icon" href="data:," />
    <style>
      ${style ?? host.style}
    </style>
    ${[
      base,
      before,
      isThree(setting.host) ? importMap(map) : (tags ?? tagsOf(setting).map(tag)).join('\n    '),
      after,
    ]
      .filter(Boolean)
      .join('\n    ')}
  </head>
  <body>
    ${sketch}
  </body>
</html>
`
}

const importMap = (imports) =>
  Object.keys(imports).length > 0 && `<script type="importmap">${jsonInside({ imports })}</script>`
