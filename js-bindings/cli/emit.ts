// `npx warpjet emit`: prints a warp as shader code.
import { writeFile } from 'node:fs/promises'
import { compileWarp } from '../compile/compile-warp.js'
import type { Declared } from '../core/module/result.js'
import { targetKind } from '../core/module/serialized-module.js'
import { areSameFile, withWriteErrors } from './files.js'
import { readArguments } from './usage.js'
import { readWarp, sourceFlags, sourceOptionsOf, withFileInErrors } from './warp-file.js'

export async function emit(args: string[]): Promise<void> {
  const { values, files, usageError } = readArguments(
    'emit',
    args,
    ['a warp.js or a file of GLSL or WGSL'],
    {
      target: { type: 'string', kind: targetKind },
      tangents: { type: 'boolean', default: false },
      'surface-variation': { type: 'boolean' },
      ...sourceFlags,
      output: { type: 'string', short: 'o' },
    },
  )
  const [file] = files as [string]
  const { output } = values
  if (output !== undefined && (await areSameFile(output, file)))
    throw usageError('emit does not overwrite the warp itself.')
  const { offset, uniforms } = await readWarp(file, sourceOptionsOf(values))
  const { target, tangents, 'surface-variation': surfaceVariation } = values
  const warp = await withFileInErrors(file, () =>
    compileWarp(offset, { uniforms, target, tangents, surfaceVariation }),
  )
  const lines = [
    `// uniforms: ${listDeclared(warp.uniforms)}`,
    `// attributes: ${listDeclared(warp.attributes)}`,
    ...(warp.declarations ? ['// above main:', warp.declarations.trimEnd(), '// in main:'] : []),
    warp.code.trimEnd(),
  ]
  const text = lines.join('\n') + '\n'
  if (output === undefined) process.stdout.write(text)
  else await withWriteErrors(output, () => writeFile(output, text))
}

const listDeclared = (declared: readonly Declared[]) =>
  declared.map(({ name, type }) => `${type} ${name}`).join(', ') || 'none'
