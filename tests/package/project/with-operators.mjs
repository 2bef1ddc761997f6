// An offset with operators, which a build translates where it stands: it sees the variable around it.
import { compileWarp } from 'warpjet'

const far = 0.5

const warp = compileWarp(({ position }) => [far * position.y + 1, -position.x, 0])
const { positions } = warp.evaluate({ positions: [1, 2, 3], normals: [0, 0, 1] })
console.log(`moved ${positions}`)
