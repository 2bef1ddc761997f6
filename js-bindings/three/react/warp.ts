// `<Warp>`: a warp of what is around it or in it, for @react-three/fiber.
import { useFrame } from '@react-three/fiber'
import {
  type ForwardedRef,
  type PropsWithChildren,
  type ReactElement,
  type Ref,
  createElement,
  forwardRef,
  useImperativeHandle,
  useLayoutEffect,
  useRef,
} from 'react'
import type { Group, Material, Mesh, Object3D } from 'three'
import type { ThreeOffset, WarpOptions } from '../settings.js'
import type { ThreeUniforms, ValuesOf } from '../uniforms.js'
import { type WarpedObject, warp } from '../warp.js'

export interface WarpProps<Uniforms extends ThreeUniforms = {}> extends WarpOptions<Uniforms> {
  /** From a vertex to the offset that moves it. Another function is another warp: define it outside of the component, or
   * with `useCallback`, so that it stays the same from one rendering to the next. */
  offset: ThreeOffset<ValuesOf<Uniforms>>
}

/**
 * Warps the mesh, points or line that it is in, `<mesh>…<Warp offset={wave} /></mesh>`, or all that is in it,
 * `<Warp offset={wave}><mesh>…</mesh></Warp>`. New values of `uniforms` are set, and `millis` is the clock's, without
 * another compilation; another offset is compiled, and what was there before is disposed of, as it is when the component
 * leaves. Materials that are elements are warped themselves, so that their props go on to count; others are cloned. `ref` is
 * what `warp` gives. For a WebGPURenderer, `import 'warpjet/three/webgpu'` stands somewhere. Throws a `WarpError` where `warp` does.
 */
export const Warp = forwardRef(WarpOf) as <const Uniforms extends ThreeUniforms = {}>(
  props: PropsWithChildren<WarpProps<Uniforms>> & { ref?: Ref<WarpedObject<ValuesOf<Uniforms>>> },
) => ReactElement

function WarpOf(
  { children, ...props }: PropsWithChildren<WarpProps<ThreeUniforms>>,
  ref: ForwardedRef<WarpedObject>,
) {
  const { offset, uniforms, space, share, surfaceVariation } = props
  const group = useRef<Group>(null)
  const warped = useRef<WarpedObject>(null)
  const isAround = children !== undefined && children !== null && children !== false
  const kinds = JSON.stringify(Object.entries(uniforms ?? {}).map(kindOf))
  // New values are set below.
  const causes = [offset, space, share, surfaceVariation, isAround, kinds]
  useLayoutEffect(() => {
    const object = isAround ? group.current : group.current?.parent
    if (!object) return
    const options = { uniforms, space, share: share ?? isElement(object), surfaceVariation }
    const made = warp(object, offset as never, withoutGaps(options) as never) as WarpedObject
    warped.current = made
    return () => {
      warped.current = null
      made.dispose()
    }
  }, causes)
  useLayoutEffect(() => {
    const handles = warped.current?.uniforms as Record<string, { value: unknown }> | undefined
    for (const [name, value] of Object.entries(uniforms ?? {}))
      if (handles && handles[name]!.value !== value) handles[name]!.value = value
  })
  useImperativeHandle(ref, () => warped.current!, causes)
  useFrame(({ clock }) => warped.current?.update(1000 * clock.elapsedTime))
  return createElement('group', { ref: group }, children)
}

/** What decides a uniform's type. */
const kindOf = ([name, value]: [string, unknown]) => [
  name,
  typeof value,
  (value as { constructor?: { name: string } } | null)?.constructor?.name,
  (value as { length?: number } | null)?.length,
]

/** Whether each material is an element inside of the mesh, by what fiber leaves there. */
function isElement(object: Object3D) {
  let is = true
  object.traverse((part) => {
    for (const material of [(part as Mesh).material ?? []].flat() as (Material & {
      __r3f?: { parent?: { object?: unknown } | null }
    })[])
      is &&= material.__r3f?.parent?.object === part
  })
  return is
}

const withoutGaps = (options: object) =>
  Object.fromEntries(Object.entries(options).filter(([, value]) => value !== undefined))
