/**
 * `exactNormals`: a shader that a sketch made by p5's `modify`, from hooks in GLSL or by p5.strands, with normals that are
 * turned as it moves positions. The hook stays as it is and moves the vertex; beside it, the front end reads the same text,
 * and the exact derivative of what it does to the position turns the normal.
 */
import { WarpError } from '../../errors/errors.js'
import type { Shader } from '../host.js'
import { normalMatrices } from '../hooks/struct-hooks.js'
import { type ModifiedShader, isWgsl } from './modified-shader.js'
import { type Hooks, type MovingHooks, movingHooks } from './turned-hooks.js'
import { describeShader } from './unreadable-hooks.js'
import { forgetLastShape, prepareWhereBound } from '../variation/variation-buffers.js'
import {
  readsVariation,
  turnedVariation,
  variationDeclarations,
} from '../variation/variation-text.js'
import { addAttributes, attributesOf, privatesFor, variation } from '../hooks/wgsl-hooks.js'
import type { WarpSpace } from '../settings.js'

/** Each moves positions of a space of its own, and its normals are turned there. */
const structHooks = ['Vertex getObjectInputs', 'Vertex getWorldInputs', 'Vertex getCameraInputs']
/** Those of p5 1.11, of which it calls the second one "world", though it is in view space. */
const valueHooks = ['vec3 getLocalPosition', 'vec3 getWorldPosition']
const normalHooks = ['vec3 getLocalNormal', 'vec3 getWorldNormal']

/**
 * The same shader with exact normals, where its hooks move positions. What cannot be, such as a position that reads an
 * attribute of the sketch's own, is told in a sentence on the console, and the shader comes back as it was. Throws a
 * `WarpError` for what is no such shader.
 */
export function exactNormals<Given extends object>(shader: Given): Given {
  const given = shader as unknown as ModifiedShader
  const hooks = given?.hooks?.modified?.vertex && given.hooks.vertex
  const has = (names: readonly string[]) => names.every((name) => name in (hooks ?? {}))
  const weave = has(structHooks)
    ? inStructs
    : has([...valueHooks, ...normalHooks])
      ? inValues
      : undefined
  if (!weave)
    throw new WarpError(
      `exactNormals: expected a shader of surfaces, such as baseMaterialShader().modify(…), got ${describeShader(shader)}.`,
    )
  try {
    const woven = (isWgsl(given) ? inWgsl : weave)(given)
    return woven ? (woven.finish(given.modify(woven.hooks)) as unknown as Given) : shader
  } catch (error) {
    if (!(error instanceof WarpError)) throw error
    console.warn(
      `exactNormals: the shader stays as it is. ${error.message.replace(/^glslOffset: /, '')}`,
    )
    return shader
  }
}

/** New hooks of a shader, and a change to the shader that p5 makes of them. */
interface Woven {
  hooks: Hooks
  finish: (shader: ModifiedShader) => ModifiedShader
}

const spaces: Record<string, WarpSpace> = {
  getObjectInputs: 'local',
  getWorldInputs: 'world',
  getCameraInputs: 'camera',
  getLocalPosition: 'local',
  getWorldPosition: 'camera',
}

const spaceOf = (name: string) => spaces[name.split(' ')[1]!]!

/** Has p5 hand over how normal and uv vary over the surface, where a hook depends on it. */
function withVariation({ varying }: MovingHooks, hooks: Hooks): Woven {
  return {
    hooks,
    finish(shader) {
      if (varying.length === 0) return shader
      const drawn = shader as unknown as Shader
      if (!isWgsl(shader)) forgetLastShape(drawn)
      prepareWhereBound(drawn)
      return shader
    },
  }
}

/** What the inputs of an offset are in a hook that has all that a vertex is, and how it moves one. */
const ofStruct = {
  names: {
    position: 'warpjetInputs.position',
    normal: 'warpjetInputs.normal',
    uv: 'warpjetInputs.texCoord',
    color: 'warpjetInputs.color',
  },
  moved: (own: string) => `Vertex inputs;
  inputs.position = position;
  inputs.normal = normal;
  inputs.texCoord = uv;
  inputs.color = color;
  return ${own}(inputs).position;`,
}

/** p5 2: a hook has all that a vertex is, and gives it back. */
function inStructs(shader: ModifiedShader): Woven | undefined {
  // p5 has no uNormalMatrix beside a hook in world space.
  const matrices = shader.hooks.modified.vertex['Vertex getWorldInputs']
    ? { ...normalMatrices, camera: 'uCameraNormalMatrix * uModelNormalMatrix' }
    : normalMatrices
  const moving = movingHooks(shader, structHooks, (name) => ({
    ...ofStruct,
    // The sketch's own stands below the helpers that it may call.
    hook: ({ code, own, text, turned, warp }) => ({
      [name]: `(Vertex warpjetInputs);
${text}
Vertex HOOK_${name.split(' ')[1]}(Vertex warpjetInputs) {
${readsVariation(warp) ? turnedVariation(matrices[spaceOf(name)]) : ''}${code}
  Vertex warpjetResult = ${own}(warpjetInputs);
  warpjetResult.normal = ${turned};
  warpjetFlat = ${turned} == vec3(0.0);
  return warpjetResult;
}`,
    }),
  }))
  if (!moving) return undefined
  const isFree = !shader.hooks.modified.vertex['void afterVertex']
  return withVariation(moving, {
    ...(isFree && unitNormals(shader)),
    ...moving.hooks,
    // p5 puts declarations in the place of those before.
    vertexDeclarations: [
      shader.hooks.vertex.declarations ?? '',
      'bool warpjetFlat;',
      moving.varying.length ? variationDeclarations : '',
      ...moving.declarations,
    ].join('\n'),
  })
}

/**
 * p5 2 on WEBGPU, where functions stand in any order, and hooks are told the instance. What p5 hands on is out of reach there, so
 * where the surface is collapsed the normal is the one that the sketch's own hook gives.
 */
function inWgsl(shader: ModifiedShader): Woven | undefined {
  const uniforms = Object.keys(shader.hooks.uniforms)
    .filter((uniform) => !uniform.endsWith('sampler2D'))
    .map((uniform) => uniform.split(':')[0]!)
    .map((name) => `  let ${name} = hooks.${name};\n`)
  const ofCamera = shader.hooks.modified.vertex['Vertex getWorldInputs']
    ? 'camera.uCameraNormalMatrix * model.uModelNormalMatrix'
    : 'model.uNormalMatrix'
  const moving = movingHooks(shader, structHooks, (name) => ({
    ...ofStruct,
    hook: ({ code, own, turned, warp }) => ({
      [name]: `(warpjetInputs: Vertex) {
${uniforms.join('')}${variation({ text: warp, space: spaceOf(name) }, ofCamera)}${code}
  var warpjetResult = ${own}(warpjetInputs, instanceID);
  if (any(${turned} != vec3<f32>())) { warpjetResult.normal = ${turned}; }
  return warpjetResult;
}`,
    }),
  }))
  if (!moving) return undefined
  const names = moving.varying.flatMap(({ name, warp }) =>
    attributesOf({ text: warp, space: spaceOf(name) }),
  )
  const woven = withVariation(moving, {
    ...moving.hooks,
    vertexDeclarations: [
      shader.hooks.vertex.declarations ?? '',
      ...privatesFor(names),
      ...moving.declarations,
      ...moving.texts.map((text) => text.replace(/\)\s*\{/, ', instanceID: u32) -> Vertex {')),
    ].join('\n'),
  })
  return {
    ...woven,
    finish(made) {
      addAttributes(
        made as Pick<Shader, '_vertSrc'>,
        names,
        'On WEBGPU a position that depends on both normal and texCoord has more attributes than a shader may; write it with one of them.',
      )
      return woven.finish(made)
    },
  }
}

/**
 * p5 1.11: a hook has the position alone. The normal is carried over, in view space, to the last hook for normals, since p5
 * calls those for positions first.
 */
function inValues(shader: ModifiedShader): Woven | undefined {
  const { modified } = shader.hooks
  let isKnown = false
  const moving = movingHooks(shader, valueHooks, (name) => {
    const isLocal = name === valueHooks[0]
    return {
      names: {
        position: 'warpjetGiven',
        normal: isLocal ? 'aNormal' : 'warpjetNormal',
        uv: 'aTexCoord',
        color: '(uUseVertexColor ? aVertexColor : uMaterialColor)',
      },
      moved: (own) => `return ${own}(position);`,
      hook({ code, own, turned, warp }) {
        const varies = readsVariation(warp) ? turnedVariation(isLocal ? '' : 'uNormalMatrix') : ''
        const start = isLocal || isKnown ? '' : '  warpjetNormal = uNormalMatrix * aNormal;\n'
        isKnown = true
        return {
          [name]: `(vec3 warpjetGiven) {
${start}${varies}${code}
  warpjetNormal = ${isLocal ? `uNormalMatrix * ${turned}` : turned};
  return ${own}(warpjetGiven);
}`,
        }
      },
    }
  })
  if (!moving) return undefined
  const own = normalHooks.find((name) => modified.vertex[name])
  if (own)
    throw new WarpError(
      `The sketch has a hook ${own.split(' ')[1]} of its own, which on p5 1.11 says the normal by itself; leave it out.`,
    )
  return withVariation(moving, {
    ...moving.hooks,
    'vec3 getWorldNormal':
      '(vec3 normal) { return warpjetNormal == vec3(0.0) ? warpjetNormal : normalize(warpjetNormal); }',
    // p5 gives its normal shader medium precision, too little for what is computed here.
    vertexDeclarations: [
      'precision highp float;',
      shader.hooks.vertex.declarations ?? '',
      'vec3 warpjetNormal;',
      moving.varying.length ? variationDeclarations : '',
      ...moving.declarations,
      ...moving.texts,
    ].join('\n'),
  })
}

/**
 * The last word on normals, as a warp of createWarp has it: of length 1 before they are interpolated, but where the surface
 * is collapsed.
 */
function unitNormals({ _vertSrc }: ModifiedShader): Record<string, string> {
  const name = ['vNormal', 'vVertexNormal'].find((each) =>
    new RegExp(`\\b(?:OUT|out) vec3 ${each};`).test(_vertSrc),
  )
  if (!name) return {}
  const unit = `${name} = warpjetFlat ? vec3(0.0) : normalize(${name});`
  return { 'void afterVertex': `() { ${unit} }` }
}
