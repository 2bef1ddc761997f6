// Writes examples/*/index.html: the page of each example, with the scripts that its entry in the catalogue names.
import { readFileSync } from 'node:fs'
import { sections } from '../../web/catalogue.js'
import { pageOf } from '../../web/playground/document.js'
import { hosts, threeStyle } from '../../web/playground/hosts.js'
import { path } from '../lib/files.mjs'

/** Returns the comment that explains the URLs of the page's scripts. `elsewhere` is the end of its second sentence. */
const commentOnCopies = (elsewhere) =>
  `<!-- These are this repository's copies. Elsewhere${elsewhere}. -->`

/** Returns the import map of the modules that a sketch imports, and of three, which all addons import. */
const importsOf = (sketch) =>
  Object.fromEntries(
    Object.entries(hosts.three.modules).filter(
      ([name]) =>
        name === 'three' ||
        (name.endsWith('/') ? sketch.includes(`from '${name}`) : sketch.includes(`from '${name}'`)),
    ),
  )

function writePage({ name, title, scripts = [], background }, host) {
  if (host !== 'three')
    return pageOf(
      { host: 'p5', chosen: scripts },
      {
        title,
        before: commentOnCopies(', such as in the p5 editor, use a CDN'),
        sketch: '<script src="sketch.js"></script>',
      },
    )
  const sketch = readFileSync(path(`examples/${name}/sketch.js`), 'utf8')
  return pageOf(
    { host },
    {
      title,
      before: commentOnCopies(', use a CDN, or let a bundler find the packages'),
      modules: importsOf(sketch),
      style: threeStyle(background),
      sketch: '<script type="module" src="sketch.js"></script>',
    },
  )
}

/** Returns an object that maps the path of each page → its HTML. */
export const examplePages = () =>
  Object.fromEntries(
    sections.flatMap(({ examples, scripts, host }) =>
      examples.map((example) => [
        `examples/${example.name}/index.html`,
        writePage({ scripts, ...example }, host),
      ]),
    ),
  )
