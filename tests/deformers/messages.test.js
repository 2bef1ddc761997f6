// Messages of deformers and compositions about wrong options, arguments and results.
import assert from 'node:assert/strict'
import { describe, test } from 'node:test'
import * as deformers from '../../dist/deformers.js'
import { compileWarp } from '../../dist/warpjet.js'
import { columnMajor, product, rotation, scaling, translation } from '../support/browser/matrix.js'
import { throwWarpErrors, throwsWarpError } from '../support/warp-errors.js'
import { deformers as oracles } from '../warps/deformers.js'

describe('deformers throw a message about', () => {
  const { twist, bend, stretch, bulge, wave, genie, inflate } = deformers

  test('unknown options, for every deformer', () => {
    for (const name of Object.keys(oracles)) {
      const hasAmount = !/^(bend|twist)$/.test(name)
      const advice = !hasAmount ? 'the options are ' : 'did you mean amount\\? The options are '
      throwWarpErrors([
        [
          () => deformers[name]({ amout: 1 }),
          new RegExp(`^${name}: there is no option "amout"; ${advice}`),
        ],
        [
          () => deformers[name](5),
          new RegExp(`^${name}: expected an object of options, got the number 5\\.$`),
        ],
        [
          () => deformers[name](null),
          new RegExp(`^${name}: expected an object of options, got null\\.$`),
        ],
      ])
    }
    throwsWarpError(
      () => genie({ ege: 'x' }),
      /^genie: there is no option "ege"; did you mean edge\? The options are center, axis, amount, length, neck, edge\.$/,
    )
    throwsWarpError(
      () => genie({ colour: 'x' }),
      /^genie: there is no option "colour"; the options are center, axis, amount, length, neck, edge\.$/,
    )
  })

  test('invalid constants', () => {
    throwWarpErrors([
      [
        () => twist({ angle: 'fast' }),
        /^twist: expected a number, an expression of one number, or a function that returns one for the option "angle", got the text "fast"\.$/,
      ],
      [
        () => twist({ angle: NaN }),
        /expected a number, .* for the option "angle", got the number NaN/,
      ],
      [
        () => twist({ angle: 1e39 }),
        /expected a number, .* for the option "angle", got the number 1e\+39/,
      ],
      [() => twist({ angle: null }), /expected a number, .* for the option "angle", got null/],
      [
        () => twist({ length: 0 }),
        /expected a number above 0, .* for the option "length", got the number 0/,
      ],
      [() => wave({ wavelength: -1 }), /expected a number above 0, .* for the option "wavelength"/],
      [
        () => twist({ axis: 'w' }),
        /expected "x", "y", "z" or an array of 3 finite numbers that are not all 0, a vec3, or a function that returns one for the option "axis", got the text "w"/,
      ],
      [
        () => twist({ axis: [0, 0, 0] }),
        /expected .* not all 0, .* for the option "axis", got an array of 3/,
      ],
      [() => twist({ axis: [1, 0] }), /expected .* for the option "axis", got an array of 2/],
      [
        () => twist({ center: 5 }),
        /expected an array of 3 finite numbers, a vec3, .* for the option "center", got the number 5/,
      ],
      [() => twist({ center: [0, 'a', 0] }), /expected an array of 3 finite numbers, .* "center"/],
      [
        () => stretch({ keepVolume: 1 }),
        /expected true or false for the option "keepVolume", got the number 1\.$/,
      ],
      [
        () => stretch({ keepVolume: () => true }),
        /expected true or false for the option "keepVolume", got a function\.$/,
      ],
      [
        () => bulge({ axis: 7 }),
        /^bulge: expected "x", .* for the option "axis", got the number 7/,
      ],
      [
        () => inflate({ direction: 'normal' }),
        /expected an array of 3 finite numbers, .* "direction"/,
      ],
      [
        () => deformers.noiseDisplace({ seed: () => 1 }),
        /expected a whole number from -8388608 to 8388608 for the option "seed", got a function/,
      ],
    ])
  })

  test('invalid directions and ranges of a bend', () => {
    throwWarpErrors([
      [
        () => bend({ axis: 'y', along: 'y' }),
        /^bend: the options "axis" and "along" have the same direction/,
      ],
      [() => bend({ axis: [1, 1, 0], along: [-2, -2, 0] }), /the same direction/],
      [
        () => bend({ from: 10, to: 5 }),
        /^bend: expected a number above "from", which is 10, for the option "to", got 5\.$/,
      ],
      [
        () => bend({ to: -100 }),
        /expected a number above "from", which is -100, for the option "to", got -100/,
      ],
    ])
    assert.equal(typeof bend({ axis: 'y' }), 'function')
    assert.equal(typeof bend({ axis: [0, -2, 0] }), 'function')
  })

  test('wrong results of functions, and wrong expressions', () => {
    const compiling = (warp) => () => compileWarp(warp)
    throwWarpErrors([
      [
        compiling(twist({ angle: () => 'x' })),
        /^twist: expected the function of the option "angle" to return a number or an expression of one number, got the text "x"\.$/,
      ],
      [compiling(twist({ angle: ({ position }) => position })), /to return .*, got a vec3\.$/],
      [compiling(twist({ angle: ({ glsl }) => glsl.mat3(1) })), /to return .*, got a matrix\.$/],
      [
        compiling(twist({ length: () => -1 })),
        /to return a number above 0 or .*, got the number -1\.$/,
      ],
      [
        compiling(twist({ axis: ({ millis }) => millis })),
        /to return "x", .*, got a single number\.$/,
      ],
      [compiling(twist({ axis: () => [0, 0, 0] })), /not all 0 or a vec3, got an array of 3\.$/],
      [
        compiling((inputs) => twist({ angle: inputs.uv })(inputs)),
        /expected .* for the option "angle", got a vec2\.$/,
      ],
    ])
    let stolen
    compileWarp(({ glsl, millis }) => ((stolen = millis), glsl.vec3(0)))
    throwsWarpError(
      compiling(twist({ angle: stolen })),
      /^twist: the option "angle" belongs to another warp; pass a function such as/,
    )
  })
})

describe('compositions throw a message about', () => {
  const { add, blend, chain, inSpace, mask, twist, bend } = deformers

  test('missing offset functions', () => {
    for (const [name, make] of Object.entries({ chain, add }))
      throwsWarpError(
        () => make(),
        new RegExp(`^${name}: expected at least one offset function, got none\\.$`),
      )
    throwWarpErrors([
      [
        () => chain(twist(), [0, 1, 2]),
        /^chain: expected an offset function, such as twist\(\{ angle: 1 \}\), for argument 2, got an array of 3\.$/,
      ],
      [
        () => add(twist, {}),
        /^add: expected an offset function, .* for argument 2, got an empty object/,
      ],
      [
        () => blend(twist()),
        /^blend: expected an offset function, .* for argument 2, got undefined/,
      ],
      [
        () => mask(0.5, twist()),
        /^mask: expected an offset function, .* for argument 1, got the number 0\.5/,
      ],
      [() => inSpace(twist(), 5), /^inSpace: expected an offset function, .* for argument 2/],
    ])
  })

  test('wrong results', () => {
    const compiling = (warp) => () => compileWarp(warp)
    throwWarpErrors([
      [
        compiling(chain(twist(), () => twist())),
        /^chain: expected the offset function that is argument 2 to return a vec3, such as .*, got a function\.$/,
      ],
      [
        compiling(add(({ millis }) => millis)),
        /^add: .* argument 1 to return a vec3, got a single number\.$/,
      ],
      [compiling(mask(({ uv }) => uv, 1)), /^mask: .* to return a vec3, got a vec2\.$/],
      [
        compiling(
          inSpace(
            ({ glsl }) => glsl.mat3(1),
            () => undefined,
          ),
        ),
        /^inSpace: .* argument 2 to return .*, got undefined\.$/,
      ],
    ])
  })

  test('a deformer passed instead of its result', () => {
    const message =
      /^twist: got the inputs of an offset function; call it with its options, as in createWarp/
    for (const warp of [twist, chain(bend(), twist)])
      throwsWarpError(() => compileWarp(warp), message)
  })

  test('invalid amounts and weights', () => {
    throwWarpErrors([
      [
        () => blend(twist(), bend(), '1'),
        /^blend: expected a number, .* for the amount, got the text "1"\.$/,
      ],
      [() => mask(twist()), /^mask: expected a number, .* for the weight, got undefined\.$/],
      [
        () => compileWarp(mask(twist(), ({ position }) => position)),
        /^mask: expected the function of the weight to return a number .*, got a vec3\.$/,
      ],
    ])
  })

  test('invalid matrices', () => {
    const identity = columnMajor(translation(0, 0, 0))
    const matrix = (value) => () => inSpace(value, twist())
    throwWarpErrors([
      [
        matrix(5),
        /^inSpace: expected 16 numbers column by column, a mat4 or mat3, or a function that returns one for the matrix, got the number 5\.$/,
      ],
      [matrix([1, 2, 3]), /for the matrix, got an array of 3\.$/],
      [
        matrix(identity.map((x, i) => (i === 2 ? NaN : x))),
        /for the matrix, got an array with the number NaN\.$/,
      ],
      [
        matrix(identity.map((x, i) => ([3, 7, 11].includes(i) ? i : x))),
        /the last row 0, 0, 0, 1, .* last row 3, 7, 11, 1\.$/,
      ],
      [
        matrix(identity.map((x, i) => (i === 3 ? 1 : x))),
        /the last row 0, 0, 0, 1, .* last row 1, 0, 0, 1\.$/,
      ],
      [matrix(columnMajor(scaling(1, 0, 1))), /^inSpace: the matrix has the determinant 0/],
      [
        matrix(columnMajor(product(rotation(0.3, 0, 1), scaling(1, 0, 1), rotation(0.3, 1, 2)))),
        /determinant 0/,
      ],
    ])
    const compiling = (value) => () => compileWarp(inSpace(value, twist()))
    throwWarpErrors([
      [compiling(() => columnMajor(scaling(1, 0, 1))), /the matrix has the determinant 0/],
      [compiling(({ millis }) => millis), /for the matrix, got a single number\.$/],
      [compiling(({ position }) => position), /for the matrix, got a vec3\.$/],
      [compiling(({ glsl }) => glsl.mat2(1)), /for the matrix, got a matrix of another size\.$/],
      [compiling(({ glsl }) => glsl.mat3(0)), /determinant .* is 0/],
    ])
  })
})
