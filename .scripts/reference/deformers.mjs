// web/docs/deformers.md: each deformer with its formula and its options, as its source documents them.
import { readFileSync } from 'node:fs'
import { Stop } from '../lib/terminal.mjs'
import { path, walk } from '../lib/files.mjs'

/** The text of the page, not yet formatted. */
export function deformersText() {
  const deformers = walk('js-bindings/deformers', /\.ts$/)
    .map((file) => readDeformer(readFileSync(path(file), 'utf8')))
    .filter(Boolean)
    .sort((a, b) => a.name.localeCompare(b.name))
  return page(deformers)
}

/** What a file says; nothing if it has no options. */
function readDeformer(source) {
  const [, options] = /export interface \w+Options \{\n([\s\S]*?)\n\}/.exec(source) ?? []
  if (!options) return undefined
  const [, comment, name] =
    /\/\*\*((?:(?!\*\/)[\s\S])*)\*\/\nexport (?:const|function) (\w+)/.exec(source) ?? []
  if (!name) throw new Stop('A deformer with options has no documentation.')
  const rows = [...options.matchAll(/\/\*\*((?:(?!\*\/)[\s\S])*)\*\/((?:\n  \w+\?: .*)+)/g)]
  return {
    name,
    text: sentences(comment).replace(/ Throws a `WarpError`[^.]*\.$/, ''),
    options: rows.map(([, meaning, members]) => ({
      names: [...members.matchAll(/\n  (\w+)\?/g)].map(([, option]) => `\`${option}\``),
      meaning: sentences(meaning),
    })),
  }
}

const sentences = (comment) => comment.replace(/\n\s*\* ?/g, ' ').trim()

const section = ({ name, text, options }) => `## ${name}

${text}

| option | what it is |
| --- | --- |
${options.map(({ names, meaning }) => `| ${names.join(', ')} | ${meaning.replaceAll('|', '\\|')} |`).join('\n')}
`

const page = (deformers) => `<!-- Written by \`npm run reference\` from js-bindings/deformers. -->

# Deformers

Offset functions that are ready made, for \`createWarp\` and \`compileWarp\`. The gallery shows each of them.

\`\`\`js
import { twist } from 'warpjet/deformers'

distort = createWarp(twist({ axis: 'y', angle: ({ millis }) => millis.div(1000).sin() }), {
  space: 'world',
})
\`\`\`

With script tags, \`dist/warpjet.deformers.min.js\` after \`dist/p5.warpjet.min.js\` adds them to the global \`warpjet\`:
\`warpjet.twist({ angle: 1 })\`.

All options may be left out. A number may be a constant, a function of what an offset function is given, such as
\`({ millis }) => millis.div(1000)\` or \`({ uniforms }) => uniforms.amount\`, or, inside of an offset function, an expression. A
point or a vector is an array of three numbers or expressions, a vec3, or a function that gives one of them; an axis may also be \`'x'\`, \`'y'\` or
\`'z'\`, and needs no length of 1.

Lengths are in the units of the warp's space: pixels with \`{ space: 'world' }\`, and in the default space of p5 those of the shape's
own vertices, where \`sphere()\` reaches from -1 to 1 and a loaded model has the units of its file. The defaults suit shapes of
about 200 units. Angles are in radians.

Unknown options, wrong constants and functions that return something else throw a \`WarpError\` that says what to change.
What is computed and gets out of its range, such as a \`length\` that must be above 0, counts as the least number of that range.
[Several make one warp](composition.md) by \`chain\`, \`add\`, \`blend\`, \`mask\` and \`inSpace\`.

${deformers.map(section).join('\n')}`
