// Creates materials by React components.
import { createRoot, extend } from '@react-three/fiber'
import { act, createElement as e } from 'react'
import * as THREE from 'three'

globalThis.IS_REACT_ACT_ENVIRONMENT = true
extend(THREE)

/** Renders a React component on a mesh, and returns the material that it creates. */
export async function renderMaterial(component, props) {
  const canvas = document.createElement('canvas')
  const root = createRoot(canvas)
  await root.configure({
    size: { width: 8, height: 8, top: 0, left: 0 },
    frameloop: 'never',
    gl: { antialias: false },
  })
  let material
  const ref = (current) => (material = current ?? material)
  await act(async () =>
    root.render(e('mesh', {}, e('boxGeometry'), e(component, { ...props, ref }))),
  )
  return material
}
