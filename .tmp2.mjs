import * as TSL from 'three/tsl'
import { tslOffset } from './dist/three.webgpu.js'
import { compileWarp } from './dist/warpjet.js'
const { vec3, mx_noise_float, time, Fn, Loop, float, positionLocal, sin, vec2, uniform } = TSL
const f = (p) => {
  const n = uniform(3)
  return Fn(() => {
    const e = float(0).toVar()
    Loop({ type: 'float', start: float(1), end: n, condition: '<=' }, ({ i }) => {
      e.addAssign(sin(p.x.mul(i)).div(i))
    })
    return vec3(0, e, 0)
  })()
}
const o = tslOffset(f)
const w = compileWarp(o, { target: 'wgsl', surfaceVariation: false, uniforms: o.uniforms })
console.log(w.declarations, w.code)
