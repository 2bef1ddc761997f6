// Materials that React components create.
import { createRoot, extend } from '@react-three/fiber'
import { act, createElement as e } from 'react'
import * as THREE from 'three'

globalThis.IS_REACT_ACT_ENVIRONMENT = true
extend(THREE)

/** Returns the material that a React component creates. */
export async function materialOf(component, props) {
  const canvas = document.createElement('canvas')
  const root = createRoot(canvas)
  await root.configure({
    size: { width: 8, height: 8, top: 0, left: 0 },
    frameloop: 'never',
    gl: { antialias: false },
  })
  let material
  const ref = (given) => (material = given ?? material)
  await act(async () =>
    root.render(e('mesh', {}, e('boxGeometry'), e(component, { ...props, ref }))),
  )
  return material
}
