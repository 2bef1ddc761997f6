// `npx warpjet derive`: prints a function of GLSL or WGSL with its derivatives.
import { writeFile } from 'node:fs/promises'
import { targetKind } from '../core/module/serialized-module.js'
import { differentiate } from '../glsl-source/differentiate.js'
import { optional } from '../options/kinds.js'
import { areOneFile, withWriteErrors } from './files.js'
import { readArguments } from './usage.js'
import { choiceOf, glslFlags, isWgsl, readText, removeUndefined } from './warp-file.js'

export async function derive(args: string[]): Promise<void> {
  const { values, files, wrong } = readArguments('derive', args, ['a file of GLSL or WGSL'], {
    function: glslFlags.function,
    by: { type: 'string' },
    name: { type: 'string' },
    'max-iterations': glslFlags['max-iterations'],
    target: { type: 'string', kind: optional(targetKind) },
    output: { type: 'string', short: 'o' },
  })
  const [file] = files as [string]
  const { output } = values
  if (output !== undefined && (await areOneFile(output, file)))
    throw wrong('derive does not overwrite its source.')
  const source = await readText(file)
  const text = differentiate(source, {
    ...removeUndefined({
      target: values.target,
      language: isWgsl(file) ? 'wgsl' : undefined,
      ...choiceOf({ ...values, returns: undefined }),
      by: values.by,
      name: values.name,
    }),
  })
  if (output === undefined) process.stdout.write(text)
  else await withWriteErrors(output, () => writeFile(output, text))
}
