// Does the same as program.js by require().
const { compileWarp } = require('warpjet')
const { gen } = require('warpjet/autodiff')
const { twist } = require('warpjet/deformers')
const { bakeWarp, loadMesh } = require('warpjet/mesh')
const { default: warpjet } = require('warpjet/p5')

loadMesh('triangle.obj').then((mesh) => {
  const { positions } = bakeWarp(
    mesh,
    compileWarp(({ position }) => position.mult(0)),
  )
  console.log(`moved ${positions.slice(3, 6)}`, typeof warpjet, typeof gen, typeof twist)
})
