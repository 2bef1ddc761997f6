import * as TSL from 'three/tsl'
import { tslOffset } from './dist/three.webgpu.js'
import { compileWarp } from './dist/warpjet.js'
const { sin, vec3, uniform, time, mx_noise_float, Fn, Loop, float, uniformArray } = TSL
const amp = uniform(0.3).setName('amp')
const o = tslOffset((p) => vec3(0, sin(p.x.mul(3).add(time)).mul(amp), 0))
console.log(o.uniforms, o.uniforms.amp())
const w = compileWarp(o, { uniforms: o.uniforms })
console.log(w.code ?? Object.keys(w))
console.log(
  w.evaluate({ positions: [1, 0, 0], normals: [0, 1, 0] }, { uniforms: { millis: 500 } }),
  0.3 * Math.sin(3.5),
)
const t0 = performance.now()
const n = tslOffset((p) => vec3(0, mx_noise_float(p.mul(2)), 0))
const w2 = compileWarp(n)
console.log(performance.now() - t0, w2.evaluate({ positions: [0.3, 0.2, 0.1], normals: [0, 1, 0] }))
for (const f of [
  () => TSL.cameraPosition,
  () => TSL.modelWorldMatrix.mul(TSL.positionLocal).xyz,
  () => vec3(TSL.instanceIndex),
  () => vec3(TSL.vertexIndex),
  () => 3,
  () => TSL.attribute('foo', 'vec3'),
  () => vec3(TSL.deltaTime),
  () => vec3(TSL.positionView.z),
  () => TSL.normalView,
  () => vec3(TSL.instancedArray(4, 'float').element(2)),
  () => vec3(uniformArray([1, 2]).element(1)),
  () =>
    Fn(() => {
      const list = uniformArray([1, 2, 5])
      const s = float(0).toVar()
      Loop(3, ({ i }) => {
        s.addAssign(list.element(i))
      })
      return vec3(s)
    })(),
  () => vec3(TSL.screenUV, 0),
  () => vec3(TSL.dFdx(TSL.positionLocal.x)),
])
  try {
    const o = tslOffset(f)
    console.log(Object.keys(o.uniforms))
    console.log([
      ...compileWarp(o, { uniforms: o.uniforms }).evaluate({ positions: [1, 2, 3] }).positions,
    ])
  } catch (e) {
    console.log(e.name, e.message?.slice(0, 300))
  }
try {
  compileWarp(o)
} catch (e) {
  console.log(e.message)
}
