/** Makes a p5 sketch from code that only defines an offset function; the sketch applies it to a model. */
import { quote } from './strings.js'

/** p5's own shapes. A unit is a pixel, as in space: 'world'. */
const shapes = {
  sphere: 'sphere(150, 160, 120)',
  box: 'warpBox(200, 200, 200, 40)',
  plane: 'plane(400, 400, 120, 120)',
  torus: 'torus(120, 45, 120, 60)',
}
/** The gallery's models; the longest side is 200 units. */
export const models = ['bunny', 'teapot', 'hand', 'airplane', 'spoon']

export const builtIn = [...Object.keys(shapes), ...models.map((name) => `${name}.obj`)]

export const isModelFile = (name) => /\.(?:obj|stl|glb|gltf)$/i.test(name)

export const starter = `// Returns how far each point moves. A unit is a pixel.
const uniforms = { height: 12 }

function offset({ glsl, position, millis, uniforms }) {
  const along = position.y().div(30).add(millis.div(500))
  return glsl.vec3(along.sin().mult(uniforms.height), 0, 0)
}
`

const loaderOf = (name) =>
  /\.(?:obj|stl)$/i.test(name) ? `loadModel(${quote(name)}, true)` : `loadWarpModel(${quote(name)})`

/** Returns the sketch that p5 runs. The user's lines come first, so that they keep their numbers. */
export function completeSketch({ text, host, model = 'sphere', ...rest }) {
  if (host !== 'offset') return { text, host, ...rest }
  const userCode = text.trimEnd()
  if (!/\boffset\b/.test(userCode))
    return {
      text: `throw new Error('Write a function with the name offset, which returns the offset of a point.')`,
      host: 'p5',
      ...rest,
    }
  const isFile = !Object.hasOwn(shapes, model)
  const options = /\buniforms\s*=/.test(userCode)
    ? "{ space: 'world', uniforms }"
    : "{ space: 'world' }"
  return {
    text: `${userCode}

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
