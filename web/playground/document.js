/** Writes the page of a sketch as a standalone HTML file. */
import { javascriptLanguage } from '@codemirror/lang-javascript'
import { hosts, isThree, tagsOf } from './hosts.js'

/** Writes JSON for a script tag. */
export const writeJsonForScript = (value) => JSON.stringify(value).replaceAll('<', '\\u003C')

/** Matches text that an HTML parser would take for the end of the script or, after `<!--`, for a nested script. */
const dangerousText = /<(?=\/script|!--|script)/gi

/**
 * Escapes JavaScript for a script tag, so that nothing in it can end the tag, without a change of its meaning. Outside of strings,
 * `<script` is not escaped, as in `a<scripts.length`: it is dangerous only after `<!--`, which is escaped.
 */
export function escapeForScript(text, { isModule = false } = {}) {
  const matches = [...text.matchAll(dangerousText)]
  if (!matches.length) return text
  const tree = javascriptLanguage.parser.parse(text)
  let result = text
  for (const { index } of matches.reverse()) {
    const rest = text.slice(index, index + 4)
    const kind = kindAt(tree, index)
    let replacement = '<'
    if (kind === 'String' || kind === 'RegExp')
      replacement = isEscaped(text, index) ? 'u003C' : '\\u003C'
    else if (kind === 'TemplateString') replacement = "<${''}"
    else if (rest.startsWith('</')) replacement = '< '
    // In a classic script `<!--` begins a single-line comment.
    else if (rest === '<!--') replacement = isModule || kind ? '< ' : '//'
    result = result.slice(0, index) + replacement + result.slice(index + 1)
  }
  return result
}

const kinds = ['String', 'TemplateString', 'RegExp', 'LineComment', 'BlockComment']

/** Returns the kind of string or comment that contains the index `at`; `undefined` in code. */
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
 * `before` and `after` are HTML before and after the libraries, `sketch` is the sketch's own tag. `tags` and `modules` replace the
 * libraries' default tags and import map, `style` replaces the host's style.
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
  Object.keys(imports).length > 0 &&
  `<script type="importmap">${writeJsonForScript({ imports })}</script>`
