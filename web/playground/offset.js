/** A sketch that is an offset function alone: a model to try it on, and the rest of a sketch of p5 around both. */
import { quote } from './strings.js'

/** What p5 draws by itself; a unit is a pixel, as space: 'world' has it. */
const shapes = {
  sphere: 'sphere(150, 160, 120)',
  box: 'warpBox(200, 200, 200, 40)',
  plane: 'plane(400, 400, 120, 120)',
  torus: 'torus(120, 45, 120, 60)',
}
/** Those of the gallery, 200 units at their longest. */
export const models = ['bunny', 'teapot', 'hand', 'airplane', 'spoon']

export const builtIn = [...Object.keys(shapes), ...models.map((name) => `${name}.obj`)]

export const isModelFile = (name) => /\.(?:obj|stl|glb|gltf)$/i.test(name)

export const starter = `// Where each point goes, from where it is. A unit is a pixel.
const uniforms = { height: 12 }

function offset({ glsl, position, millis, uniforms }) {
  const along = position.y().div(30).add(millis.div(500))
  return glsl.vec3(along.sin().mult(uniforms.height), 0, 0)
}
`

const loaderOf = (name) =>
  /\.(?:obj|stl)$/i.test(name) ? `loadModel(${quote(name)}, true)` : `loadWarpModel(${quote(name)})`

/** The sketch as p5 runs it: its own lines first, so that they keep their numbers. */
export function whole({ text, host, model = 'sphere', ...rest }) {
  if (host !== 'offset') return { text, host, ...rest }
  const own = text.trimEnd()
  if (!/\boffset\b/.test(own))
    return {
      text: `throw new Error('Write a function with the name offset, which returns how far a point goes.')`,
      host: 'p5',
      ...rest,
    }
  const isFile = !Object.hasOwn(shapes, model)
  const options = /\buniforms\s*=/.test(own) ? "{ space: 'world', uniforms }" : "{ space: 'world' }"
  return {
    text: `${own}

let warp${isFile ? ', shape' : ''}

${isFile ? 'async ' : ''}function setup() {
  createCanvas(640, 480, WEBGL)
  noStroke()
${isFile ? `  shape = await ${loaderOf(model)}\n` : ''}  warp = createWarp(offset, ${options})
}

function draw() {
  background('#151823')
  orbitControl()
  ambientLight(100)
  directionalLight(255, 240, 221, -0.5, 0.8, -0.9)
  directionalLight(68, 99, 214, 0.8, -0.3, 0.2)

  rotateX(${model === 'plane' ? '1' : '-0.3'})
  rotateY(0.4)
  specularMaterial(90)
  shininess(40)
  fill('#ff8a5b')
  warp()
  ${isFile ? `scale(1.5)\n  model(shape)` : shapes[model]}
}
`,
    host: 'p5',
    ...rest,
  }
}
