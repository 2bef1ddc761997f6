// `npx warpjet derive`: a function of shader text with its derivatives.
import { writeFile } from 'node:fs/promises'
import { differentiate } from '../glsl-source/differentiate.js'
import { type Target, targets } from '../core/module/kept-module.js'
import { areOneFile, writing } from './files.js'
import { readArguments } from './usage.js'
import { given, readChoice, readText } from './warp-file.js'

export async function derive(args: string[]): Promise<void> {
  const { values, files, wrong } = readArguments('derive', args, ['a file of GLSL'], {
    function: { type: 'string' },
    by: { type: 'string' },
    name: { type: 'string' },
    'max-iterations': { type: 'string' },
    target: { type: 'string', default: 'glsl300' },
    output: { type: 'string', short: 'o' },
  })
  const target = values.target as Target
  if (!targets.includes(target))
    throw wrong(`--target must be one of ${targets.join(', ')}, but is "${target}".`)
  const [file] = files as [string]
  const { output } = values
  if (output !== undefined && (await areOneFile(output, file)))
    throw wrong('derive does not write over the text itself.')
  const source = await readText(file)
  const text = differentiate(source, {
    target,
    ...given({ ...readChoice(values, wrong), by: values.by, name: values.name }),
  })
  if (output === undefined) process.stdout.write(text)
  else await writing(output, () => writeFile(output, text))
}
