// A sketch in global mode, on a page that has p5 and warpjet's scripts.
/// <reference types="p5/global" />
/// <reference types="warpjet/globals" />

const { chain, twist, bend } = warpjet
let distort: ReturnType<typeof createWarp>
let airplane: Awaited<ReturnType<typeof loadWarpModel>>

async function setup() {
  createCanvas(600, 600, WEBGL)
  airplane = await addSurfaceVariation(await loadWarpModel('airplane.glb'))
  distort = createWarp(
    chain(
      twist({ axis: 'y', length: 300, angle: ({ glsl }) => glsl.param('angle') }),
      bend({ axis: 'z' }),
      ({ position }) => position.mult(position.noise()),
    ),
    { space: 'world', uniforms: { angle: () => mouseX / 200 } },
  )
}

function draw() {
  background(220)
  distort()
  if (airplane.texture) texture(airplane.texture)
  model(airplane)
  const text: string = AutoDiff.gen((ad) => ad.param('x').output('y')) + warpjet.version
  shader(exactNormals(baseMaterialShader()))
  shader(exactNormals(baseMaterialShader(), { maxIterations: 1000 }))
  createWarp(warpjet.glslOffset('vec3 offset(vec3 p) { return p; }', { returns: 'position' }))
  // @ts-expect-error a shader is needed
  exactNormals()
  // @ts-expect-error no such deformer
  warpjet.twirl()
  void text
}

void [setup, draw, warpjet.compileWarp(twist()), warpjet.WarpError]
