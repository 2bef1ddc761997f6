// The sections of web/docs/deformers.md: each deformer with its formula and its options, as its source documents them.
import { readFileSync } from 'node:fs'
import { Stop } from '../lib/terminal.mjs'
import { path, walk } from '../lib/files.mjs'

export function deformerParts() {
  const deformers = walk('js-bindings/deformers', /\.ts$/)
    .map((file) => readDeformer(readFileSync(path(file), 'utf8')))
    .filter(Boolean)
    .sort((a, b) => a.name.localeCompare(b.name))
  return { deformers: deformers.map(section).join('\n') }
}

/** Reads the documentation of a deformer; `undefined` if the file has no options. */
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
