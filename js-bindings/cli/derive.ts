// `npx warpjet derive`: prints a function that returns the derivatives of a function in a GLSL or WGSL file.
import { writeFile } from 'node:fs/promises'
import { targetKind } from '../core/module/serialized-module.js'
import { differentiate } from '../glsl-source/differentiate.js'
import { optional } from '../options/kinds.js'
import { areSameFile, withWriteErrors } from './files.js'
import { readArguments } from './usage.js'
import { isWgsl, readText, removeUndefined, sourceFlags, sourceOptionsOf } from './warp-file.js'

export async function derive(args: string[]): Promise<void> {
  const { values, files, usageError } = readArguments('derive', args, ['a file of GLSL or WGSL'], {
    function: sourceFlags.function,
    by: { type: 'string' },
    name: { type: 'string' },
    'max-iterations': sourceFlags['max-iterations'],
    target: { type: 'string', kind: optional(targetKind) },
    output: { type: 'string', short: 'o' },
  })
  const [file] = files as [string]
  const { output } = values
  if (output !== undefined && (await areSameFile(output, file)))
    throw usageError('derive does not overwrite the source file.')
  const source = await readText(file)
  const text = differentiate(source, {
    ...removeUndefined({
      target: values.target,
      language: isWgsl(file) ? 'wgsl' : undefined,
      ...sourceOptionsOf({ ...values, returns: undefined }),
      by: values.by,
      name: values.name,
    }),
  })
  if (output === undefined) process.stdout.write(text)
  else await withWriteErrors(output, () => writeFile(output, text))
}
