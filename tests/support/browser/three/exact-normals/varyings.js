// Nodes that assign varyings: `position` is a positionNode that assigns them, `colour` a fragmentNode that outputs the varyings. Each
// position has one loop, so that heights.js can count the evaluations of the height.
import * as TSL from 'three/tsl'

const { Fn, If, Loop, float, positionLocal, sin, varying, varyingProperty, vec2, vec3, vec4 } = TSL

/** Returns the sum of three sines. */
const heightAt = (p) => {
  const height = float(0).toVar()
  Loop({ type: 'float', start: float(1), end: TSL.uniform(3), condition: '<=' }, ({ i }) =>
    height.addAssign(sin(p.x.mul(i).mul(2).add(p.y)).div(i.mul(6))),
  )
  return height
}

export const varyings = {
  'a height and a place'() {
    const [height, place] = [varying(float(0)), varying(vec3(0))]
    const position = Fn(() => {
      height.assign(heightAt(positionLocal))
      const moved = positionLocal.add(vec3(0, 0, height)).toVar()
      place.assign(moved.mul(0.5).add(0.5))
      return moved
    })()
    return { position, colour: vec4(height.add(0.5), place) }
  },
  'a component of a varying, and a varying in a branch'() {
    const [pair, side] = [varying(vec2(0.25, 0)), varyingProperty('float', 'shownSide')]
    const position = Fn(() => {
      const height = heightAt(positionLocal).toVar()
      pair.y.assign(height.add(0.5))
      side.assign(0)
      If(positionLocal.x.greaterThan(0.1), () => {
        side.assign(positionLocal.y.add(1))
      })
      return positionLocal.add(vec3(0, 0, height))
    })()
    return { position, colour: vec4(pair, side, 1) }
  },
}

/** Assigns more floats than our vertex function can return. */
varyings['too many'] = () => {
  const all = [0, 1, 2, 3].map((i) => varying(vec4(0), `shownNumbers${i}`))
  const position = Fn(() => {
    const height = heightAt(positionLocal).toVar()
    for (const [i, each] of all.entries()) each.assign(vec4(height, positionLocal.mul(i)))
    return positionLocal.add(vec3(0, 0, height))
  })()
  return {
    position,
    colour: all
      .reduce((sum, each) => sum.add(each))
      .mul(0.1)
      .add(0.5),
  }
}
