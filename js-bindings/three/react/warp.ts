// `<Warp>` for @react-three/fiber: warps the object around it, or the objects in it.
import { useFrame } from '@react-three/fiber'
import {
  createElement,
  forwardRef,
  useImperativeHandle,
  useLayoutEffect,
  useRef,
  type ForwardedRef,
  type PropsWithChildren,
  type ReactElement,
  type Ref,
} from 'react'
import type { Group } from 'three'
import type { ThreeOffset, WarpOptions } from '../settings.js'
import type { ThreeUniforms, ValuesOf } from '../uniforms.js'
import { warp, type WarpedObject } from '../warp.js'

export interface WarpProps<Uniforms extends ThreeUniforms = {}> extends WarpOptions<Uniforms> {
  /** Maps a vertex to the offset that moves it. Another function is another warp: define it outside of the component, or
   * with `useCallback`, so that it stays the same from one rendering to the next. */
  offset: ThreeOffset<ValuesOf<Uniforms>>
}

/**
 * Without children, warps the mesh, points or line around it: `<mesh>…<Warp offset={wave} /></mesh>`. With children, warps everything in
 * it: `<Warp offset={wave}><mesh>…</mesh></Warp>`. New values of `uniforms` are set without a compilation, and `millis` is the time of the
 * clock. Another offset is compiled, and replaces the previous one. `ref` is the result of `warp`. A WebGPURenderer needs
 * `import 'warpjet/three/webgpu'`. Throws a `WarpError` where `warp` does.
 */
export const Warp = forwardRef(WarpOf) as <const Uniforms extends ThreeUniforms = {}>(
  props: PropsWithChildren<WarpProps<Uniforms>> & { ref?: Ref<WarpedObject<ValuesOf<Uniforms>>> },
) => ReactElement

function WarpOf(
  { children, ...props }: PropsWithChildren<WarpProps<ThreeUniforms>>,
  ref: ForwardedRef<WarpedObject>,
) {
  const { offset, uniforms, space, normals, fadeNoise, detail, share, surfaceVariation } = props
  const group = useRef<Group>(null)
  const warped = useRef<WarpedObject>(null)
  const hasChildren = children !== undefined && children !== null && children !== false
  const kinds = JSON.stringify(Object.entries(uniforms ?? {}).map(kindOf))
  // The warp is made again if one of these changes. The second effect sets new values of uniforms.
  const dependencies = [
    offset,
    space,
    normals,
    fadeNoise,
    detail,
    share,
    surfaceVariation,
    hasChildren,
    kinds,
  ]
  useLayoutEffect(() => {
    const object = hasChildren ? group.current : group.current?.parent
    if (!object) return
    const options = { uniforms, space, normals, fadeNoise, detail, share, surfaceVariation }
    const result = warp(object, offset as never, withoutUndefined(options) as never) as WarpedObject
    warped.current = result
    return () => {
      warped.current = null
      result.dispose()
    }
  }, dependencies)
  useLayoutEffect(() => {
    const handles = warped.current?.uniforms as Record<string, { value: unknown }> | undefined
    for (const [name, value] of Object.entries(uniforms ?? {}))
      if (handles && handles[name]!.value !== value) handles[name]!.value = value
  })
  useImperativeHandle(ref, () => warped.current!, dependencies)
  useFrame(({ clock }) => warped.current?.update(1000 * clock.elapsedTime))
  return createElement('group', { ref: group }, children)
}

/** Returns the properties of a uniform that determine its type. */
const kindOf = ([name, value]: [string, unknown]) => [
  name,
  typeof value,
  (value as { constructor?: { name: string } } | null)?.constructor?.name,
  (value as { length?: number } | null)?.length,
]

const withoutUndefined = (options: object) =>
  Object.fromEntries(Object.entries(options).filter(([, value]) => value !== undefined))
