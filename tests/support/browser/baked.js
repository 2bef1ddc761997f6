// Checks that a baked mesh equals what the GPU draws: compares `evaluate` with a vertex shader.
//
// With an accurate sine in GLSL instead of the built-in one, positions agree to 1e-5 of `reach`, the largest number in the formula,
// and normals to `degrees` of the warp. At `millis` 98,765, where angles reach 1,000 and float32 is no finer than 6e-5,
// positions agree to 2e-5, as they do with the oracle in double. SwiftShader's built-in sine is 2e-4 off, and with it positions
// agree to 1e-3. We skip vertices where the oracle finds a kink nearby, since two roundings may be on different sides, and
// those where the surface is almost collapsed.
import assert from 'node:assert/strict'
import { maxSensitivity, positionAndNormal } from './compare.js'
import { stride, vertexAt } from './dense-mesh.js'
import { angleBetween, distanceBetween, warpVertex } from './oracle.js'

const positionBound = { exact: 1e-5, late: 2e-5, builtIn: 1e-3 }

/**
 * Returns the max differences of `baked` from the shader's results with the built-in sine (`builtIn`) and with an accurate one (`exact`,
 * the same list if there is none). Each list has six numbers per vertex, for each of `draws`. Differences of positions are relative to the
 * bound, except with the built-in sine. `expected`, if present, has the results of the oracle.
 */
export function compareCpuWithGpu(warp, mesh, draws, baked, { builtIn, exact }, expected) {
  const { offset, reach, step, degrees, mirrors } = warp
  const worst = { position: 0, angle: 0, builtIn: 0, leftOut: 0 }
  const vertexCount = mesh.length / stride
  draws.forEach((uniforms, k) => {
    const exactBound = uniforms.millis > 1e4 ? positionBound.late : positionBound.exact
    const bound = exact === builtIn ? positionBound.builtIn : exactBound
    for (let i = 0; i < vertexCount; i++) {
      const [position, normal] = positionAndNormal(baked[k], i)
      const scale = Math.max(reach, Math.hypot(...position))
      const [shownPosition, shownNormal] = positionAndNormal(exact[k], i)
      const areZero = ![...normal, ...shownNormal].some(Boolean)
      const angle = areZero ? 0 : angleBetween(normal, shownNormal)
      const distance = distanceBetween(position, shownPosition) / scale
      if (angle > degrees || distance > bound) {
        const truth =
          expected?.[k][i] ?? warpVertex(offset, vertexAt(mesh, i), uniforms, step, mirrors)
        const isSmooth = truth.normal?.some(Boolean) && truth.sensitivity <= maxSensitivity
        if (!isSmooth) {
          worst.leftOut++
          continue
        }
      }
      worst.position = Math.max(worst.position, distance / bound)
      worst.angle = Math.max(worst.angle, angle)
      const [roughPosition] = positionAndNormal(builtIn[k], i)
      worst.builtIn = Math.max(worst.builtIn, distanceBetween(position, roughPosition) / scale)
    }
  })
  return { ...worst, count: draws.length * vertexCount }
}

export function assertCpuEqualsGpu({ position, angle, builtIn, leftOut, count }, degrees) {
  assert.ok(position <= 1, `bake and screen: positions are ${position} times as far off as allowed`)
  assert.ok(angle <= degrees, `bake and screen: normals are ${angle}° off`)
  assert.ok(
    builtIn <= positionBound.builtIn,
    `bake and screen: positions are ${builtIn} off with the built-in sine`,
  )
  assert.ok(leftOut <= 0.1 * count, `bake and screen: ${leftOut} of ${count} vertices are left out`)
}
