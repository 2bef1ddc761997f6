// The sections of web/docs/deformers.md: each deformer with its formula and its options, as TypeDoc reads them from the source.
import { Application, ReflectionKind } from 'typedoc'
import { path } from '../lib/files.mjs'
import { code, markdownTable } from './parts.mjs'

/** Returns the comment of a declaration as one line. */
const textOf = ({ comment }) =>
  comment?.summary
    .map(({ text }) => text)
    .join('')
    .replaceAll('\n', ' ')

export async function deformerParts() {
  const app = await Application.bootstrap({
    entryPoints: [path('js-bindings/deformers.ts')],
    tsconfig: path('.scripts/tsconfig.types.json'),
    sort: ['source-order'],
    logLevel: 'Error',
    skipErrorChecking: true,
  })
  const { children } = await app.convert()
  const options = children.filter(({ name }) => name.endsWith('Options'))
  const sections = children
    .filter(({ kind }) => kind === ReflectionKind.Function)
    .map(({ name, signatures }) => [
      name,
      textOf(signatures[0]).replace(/ Throws a `WarpError`[^.]*\.$/, ''),
      options.find((each) => each.name.toLowerCase() === `${name}options`.toLowerCase()),
    ])
    .filter(([, , deformerOptions]) => deformerOptions)
    .sort(([a], [b]) => a.localeCompare(b))
  return { deformers: sections.map(writeSection).join('\n') }
}

/** Returns the section of a deformer. An option without a comment shares the comment of the option before it. */
function writeSection([name, text, { children }]) {
  const rows = []
  for (const option of children)
    if (option.comment) rows.push([[option.name], textOf(option)])
    else rows.at(-1)[0].push(option.name)
  const cells = rows.map(([names, meaning]) => [names.map(code).join(', '), meaning])
  return `## ${name}\n\n${text}\n\n${markdownTable(['option', 'what it is'], cells)}\n`
}
