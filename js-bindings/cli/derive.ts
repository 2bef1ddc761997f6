// `npx warpjet derive`: a function of shader text with its derivatives.
import { writeFile } from 'node:fs/promises'
import { differentiate } from '../glsl-source/differentiate.js'
import { targetKind } from '../core/module/serialized-module.js'
import { areOneFile, writing } from './files.js'
import { readArguments } from './usage.js'
import { choiceOf, given, glslFlags, readText } from './warp-file.js'

export async function derive(args: string[]): Promise<void> {
  const { values, files, wrong } = readArguments('derive', args, ['a file of GLSL'], {
    function: glslFlags.function,
    by: { type: 'string' },
    name: { type: 'string' },
    'max-iterations': glslFlags['max-iterations'],
    target: { type: 'string', kind: targetKind },
    output: { type: 'string', short: 'o' },
  })
  const [file] = files as [string]
  const { output } = values
  if (output !== undefined && (await areOneFile(output, file)))
    throw wrong('derive does not write over the text itself.')
  const source = await readText(file)
  const text = differentiate(source, {
    target: values.target,
    ...given({ ...choiceOf({ ...values, returns: undefined }), by: values.by, name: values.name }),
  })
  if (output === undefined) process.stdout.write(text)
  else await writing(output, () => writeFile(output, text))
}
