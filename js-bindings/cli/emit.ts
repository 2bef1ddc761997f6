// `npx warpjet emit`: a warp as shader text.
import { writeFile } from 'node:fs/promises'
import { compileWarp } from '../compile/compile-warp.js'
import type { Declared } from '../core/module/result.js'
import { targets, type Target } from '../core/module/kept-module.js'
import { areOneFile, writing } from './files.js'
import { readArguments } from './usage.js'
import { blame, glslArguments, readChoice, readWarp } from './warp-file.js'

export async function emit(args: string[]): Promise<void> {
  const { values, files, wrong } = readArguments('emit', args, ['a warp.js or a file of GLSL'], {
    target: { type: 'string', default: 'glsl300' },
    tangents: { type: 'boolean', default: false },
    'surface-variation': { type: 'boolean' },
    ...glslArguments,
    output: { type: 'string', short: 'o' },
  })
  const target = values.target as Target
  if (!targets.includes(target))
    throw wrong(`--target must be one of ${targets.join(', ')}, but is "${target}".`)

  const [file] = files as [string]
  const { output } = values
  if (output !== undefined && (await areOneFile(output, file)))
    throw wrong('emit does not write over the warp itself.')
  const { offset, uniforms } = await readWarp(file, readChoice(values, wrong))
  const { tangents, 'surface-variation': surfaceVariation } = values
  const warp = await blame(file, () =>
    compileWarp(offset, { uniforms, target, tangents, surfaceVariation }),
  )
  const lines = [
    `// uniforms: ${listed(warp.uniforms)}`,
    `// attributes: ${listed(warp.attributes)}`,
    ...(warp.declarations ? ['// above main:', warp.declarations.trimEnd(), '// in main:'] : []),
    warp.code.trimEnd(),
  ]
  const text = lines.join('\n') + '\n'
  if (output === undefined) process.stdout.write(text)
  else await writing(output, () => writeFile(output, text))
}

const listed = (declared: readonly Declared[]) =>
  declared.map(({ name, type }) => `${type} ${name}`).join(', ') || 'none'
