// An offset function with operators. The bundler's plugin translates it in place, so that it can read the variable `far`.
import { compileWarp } from 'warpjet'

const far = 0.5

const warp = compileWarp(({ position }) => [far * position.y + 1, -position.x, 0])
const { positions } = warp.evaluate({ positions: [1, 2, 3], normals: [0, 0, 1] })
console.log(`moved ${positions}`)
