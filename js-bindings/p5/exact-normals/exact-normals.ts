/**
 * `exactNormals` adds exact normals to a shader that a sketch made by p5's `modify`, from hooks in GLSL or by p5.strands. The
 * sketch's hook still moves the vertex. We parse the same source a second time, differentiate the position it computes, and
 * transform the normal by that exact derivative.
 */
import { WarpError } from '../../errors/errors.js'
import { loopKinds, type LoopOptions } from '../../options/iterations.js'
import { object } from '../../options/schema.js'
import { normalMatrices } from '../hooks/struct-hooks.js'
import type { Shader } from '../host.js'
import type { WarpSpace } from '../settings.js'
import { forgetLastShape, prepareWhereBound } from '../variation/variation-buffers.js'
import {
  readsVariation,
  variationDeclarations,
  variationInGlsl,
} from '../variation/variation-text.js'
import {
  addAttributes,
  attributesOf,
  declarePrivates,
  variationInWgsl,
} from '../variation/variation-wgsl.js'
import { makeExactHooks, type ExactHooks, type Hooks } from './exact-hooks.js'
import { isWgsl, type ModifiedShader } from './modified-shader.js'
import { place } from './place.js'
import { describeShader } from './unreadable-hooks.js'

/** Each of these hooks moves positions in its own space; its normals are transformed in the same space. */
const structHooks = ['Vertex getObjectInputs', 'Vertex getWorldInputs', 'Vertex getCameraInputs']
/** The hooks of p5 1.11, whose "world" hook is in view space despite its name. */
const valueHooks = ['vec3 getLocalPosition', 'vec3 getWorldPosition']
const normalHooks = ['vec3 getLocalNormal', 'vec3 getWorldNormal']

export type ExactNormalsOptions = LoopOptions

const optionsKind = object(loopKinds)

/**
 * Returns the shader with exact normals, if its hooks move positions. If a hook is unsupported, for example because its position depends
 * on an attribute that the sketch defines, warns on the console and returns the shader unchanged. Throws a `WarpError` for anything but
 * a shader of surfaces.
 *
 * A loop whose end only the shader knows runs until it ends. If it cannot stay a loop in the shader, its normals are those of 256
 * iterations, and a console warning says which loop that is. The option `maxIterations` limits every such loop and silences the warning.
 */
export function exactNormals<Given extends object>(
  shader: Given,
  options?: ExactNormalsOptions,
): Given {
  const { maxIterations } = optionsKind.read(options, place)
  const modified = shader as unknown as ModifiedShader
  const hooks = modified?.hooks?.modified?.vertex && modified.hooks.vertex
  const has = (names: readonly string[]) => names.every((name) => name in (hooks ?? {}))
  const makeHooks = has(structHooks)
    ? makeStructHooks
    : has([...valueHooks, ...normalHooks])
      ? makeValueHooks
      : undefined
  if (!makeHooks)
    throw new WarpError(
      `exactNormals: expected a shader of surfaces, such as baseMaterialShader().modify(…), got ${describeShader(shader)}.`,
    )
  try {
    const newHooks = (isWgsl(modified) ? makeWgslHooks : makeHooks)(modified, maxIterations)
    return newHooks
      ? (newHooks.finish(modified.modify(newHooks.hooks)) as unknown as Given)
      : shader
  } catch (error) {
    if (!(error instanceof WarpError)) throw error
    console.warn(
      `${place.method}: the shader stays as it is. ${place.withoutMethod(error.message)}`,
    )
    return shader
  }
}

/** New hooks for a shader, and a function that finishes the shader that p5 makes with them. */
interface NewHooks {
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

/** Makes p5 pass the gradients of normal and uv to the shader, if a hook depends on them. */
function withVariation({ varying }: ExactHooks, hooks: Hooks): NewHooks {
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

/** Names of the offset's inputs in a hook that takes a Vertex struct, and the call that moves a vertex. */
const structTemplate = {
  names: {
    position: 'warpjetInputs.position',
    normal: 'warpjetInputs.normal',
    uv: 'warpjetInputs.texCoord',
    color: 'warpjetInputs.color',
  },
  moveCode: (original: string) => `Vertex inputs;
  inputs.position = position;
  inputs.normal = normal;
  inputs.texCoord = uv;
  inputs.color = color;
  return ${original}(inputs).position;`,
}

/** Makes hooks for p5 2 on WebGL, where a hook takes and returns a Vertex struct. */
function makeStructHooks(shader: ModifiedShader, maxIterations: number): NewHooks | undefined {
  // With a hook in world space, p5 has these two matrices instead of uNormalMatrix.
  const matrices = shader.hooks.modified.vertex['Vertex getWorldInputs']
    ? { ...normalMatrices, camera: 'uCameraNormalMatrix * uModelNormalMatrix' }
    : normalMatrices
  const exact = makeExactHooks(shader, structHooks, maxIterations, (name) => ({
    ...structTemplate,
    // The sketch's hook must be below the helpers that it may call.
    hook: ({ code, original, text, normal, warp }) => ({
      [name]: `(Vertex warpjetInputs);
${text}
Vertex HOOK_${name.split(' ')[1]}(Vertex warpjetInputs) {
${readsVariation(warp) ? variationInGlsl(matrices[spaceOf(name)]) : ''}${code}
  Vertex warpjetResult = ${original}(warpjetInputs);
  warpjetResult.normal = ${normal};
  warpjetNormalIsZero = ${normal} == vec3(0.0);
  return warpjetResult;
}`,
    }),
  }))
  if (!exact) return undefined
  const hasAfterVertex = shader.hooks.modified.vertex['void afterVertex']
  return withVariation(exact, {
    ...(!hasAfterVertex && normalizingHook(shader)),
    ...exact.hooks,
    // p5's `modify` replaces earlier declarations, so we repeat them.
    vertexDeclarations: [
      shader.hooks.vertex.declarations ?? '',
      'bool warpjetNormalIsZero;',
      exact.varying.length ? variationDeclarations : '',
      ...exact.declarations,
    ].join('\n'),
  })
}

/**
 * Makes hooks for p5 2 on WEBGPU, where functions may be in any order and hooks take the instance as a parameter. We cannot change
 * p5's varyings on WEBGPU, so a collapsed surface keeps the normal that the sketch's own hook returns.
 */
function makeWgslHooks(shader: ModifiedShader, maxIterations: number): NewHooks | undefined {
  const normalMatrix = shader.hooks.modified.vertex['Vertex getWorldInputs']
    ? 'camera.uCameraNormalMatrix * model.uModelNormalMatrix'
    : 'model.uNormalMatrix'
  const exact = makeExactHooks(shader, structHooks, maxIterations, (name) => ({
    ...structTemplate,
    hook: ({ code, original, normal, warp }) => ({
      [name]: `(warpjetInputs: Vertex) {
${variationInWgsl({ text: warp, space: spaceOf(name) }, normalMatrix)}${code}
  var warpjetResult = ${original}(warpjetInputs, instanceID, _p5VertexId);
  if (any(${normal} != vec3<f32>())) { warpjetResult.normal = ${normal}; }
  return warpjetResult;
}`,
    }),
  }))
  if (!exact) return undefined
  const names = exact.varying.flatMap(({ name, warp }) =>
    attributesOf({ text: warp, space: spaceOf(name) }),
  )
  const newHooks = withVariation(exact, {
    ...exact.hooks,
    vertexDeclarations: [
      shader.hooks.vertex.declarations ?? '',
      ...declarePrivates(names),
      ...exact.declarations,
      ...exact.texts.map((text) =>
        text.replace(/\)\s*\{/, ', instanceID: u32, _p5VertexId: u32) -> Vertex {'),
      ),
    ].join('\n'),
  })
  return {
    ...newHooks,
    finish(shader) {
      addAttributes(
        shader as Pick<Shader, '_vertSrc'>,
        names,
        'On WEBGPU a position that depends on both normal and texCoord needs more attributes than a shader may have; write it with one of them.',
      )
      return newHooks.finish(shader)
    },
  }
}

/**
 * Makes hooks for p5 1.11, where a hook takes and returns one value. A global passes the normal, in view space, from the position hooks
 * to the last normal hook, since p5 calls the position hooks first.
 */
function makeValueHooks(shader: ModifiedShader, maxIterations: number): NewHooks | undefined {
  let isNormalSet = false
  const exact = makeExactHooks(shader, valueHooks, maxIterations, (name) => {
    const isLocal = name === valueHooks[0]
    return {
      names: {
        position: 'warpjetRestPosition',
        normal: isLocal ? 'aNormal' : 'warpjetNormal',
        uv: 'aTexCoord',
        color: '(uUseVertexColor ? aVertexColor : uMaterialColor)',
      },
      moveCode: (original) => `return ${original}(position);`,
      hook({ code, original, normal, warp }) {
        const gradients = readsVariation(warp)
          ? variationInGlsl(isLocal ? '' : 'uNormalMatrix')
          : ''
        const setNormal =
          isLocal || isNormalSet ? '' : '  warpjetNormal = uNormalMatrix * aNormal;\n'
        isNormalSet = true
        return {
          [name]: `(vec3 warpjetRestPosition) {
${setNormal}${gradients}${code}
  warpjetNormal = ${isLocal ? `uNormalMatrix * ${normal}` : normal};
  return ${original}(warpjetRestPosition);
}`,
        }
      },
    }
  })
  if (!exact) return undefined
  const normalHook = normalHooks.find((name) => shader.hooks.modified.vertex[name])
  if (normalHook)
    throw new WarpError(
      `The sketch has a hook ${normalHook.split(' ')[1]} of its own, which on p5 1.11 replaces the normal; leave it out.`,
    )
  return withVariation(exact, {
    ...exact.hooks,
    'vec3 getWorldNormal':
      '(vec3 normal) { return warpjetNormal == vec3(0.0) ? warpjetNormal : normalize(warpjetNormal); }',
    // p5's normal shader has medium precision, too little for our computation.
    vertexDeclarations: [
      'precision highp float;',
      shader.hooks.vertex.declarations ?? '',
      'vec3 warpjetNormal;',
      exact.varying.length ? variationDeclarations : '',
      ...exact.declarations,
      ...exact.texts,
    ].join('\n'),
  })
}

/**
 * Returns a hook that normalizes the normals at the end of `main`, before they are interpolated, except where the surface is
 * collapsed. A warp by createWarp does the same.
 */
function normalizingHook({ _vertSrc }: ModifiedShader): Record<string, string> {
  const name = ['vNormal', 'vVertexNormal'].find((each) =>
    new RegExp(`\\b(?:OUT|out) vec3 ${each};`).test(_vertSrc),
  )
  if (!name) return {}
  const unit = `${name} = warpjetNormalIsZero ? vec3(0.0) : normalize(${name});`
  return { 'void afterVertex': `() { ${unit} }` }
}
