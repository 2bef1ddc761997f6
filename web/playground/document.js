/** The page that a sketch runs in, in the playground as in a file of its own. */
import { hosts, isThree, tagsOf } from './hosts.js'

/** Text inside a script tag: nothing in it may end the tag. */
export const insideScript = (text) => text.replaceAll(/<(?=\/script|!--|script)/gi, '\\u003C')

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
  Object.keys(imports).length > 0 &&
  `<script type="importmap">${insideScript(JSON.stringify({ imports }))}</script>`
