/** The panel of the interactive benchmark: the row, the method, and the speed of time. */
import GUI from 'lil-gui'
import { formatExact } from './figures.js'
import { methods } from './methods.js'
import { workloads } from './workloads.js'

/**
 * @param settings { row, method, exponent, moves, speed }, which the panel updates: names of row and method, the decimal
 * logarithm of the step h, whether time passes, and its speed relative to a clock
 * @param findStep called by the button that finds the best step
 * @returns { refresh }: call it after changing the settings elsewhere
 */
export function makePanel(container, settings, findStep) {
  const gui = new GUI({ container, title: 'The picture' })
  gui
    .add(
      settings,
      'row',
      workloads.map(({ name }) => name),
    )
    .onChange(refresh)
  gui
    .add(
      settings,
      'method',
      methods.map(({ name }) => name),
    )
    .onChange(refresh)
  const { steps } = methods.find(({ steps }) => steps)
  const step = gui
    .add(settings, 'exponent', Math.log10(steps[0]), Math.log10(steps.at(-1)))
    .onChange(refresh)
  step.domElement.classList.add('step')
  const find = gui.add({ findStep }, 'findStep').name('find the best h')
  gui.add(settings, 'moves').name('time passes')
  gui.add(settings, 'speed', 0, 3, 0.01).name('speed')
  refresh()
  return { refresh }

  function refresh() {
    const { steps } = methods.find(({ name }) => name === settings.method)
    step
      .name(`h = ${formatExact(10 ** settings.exponent)}`)
      .enable(Boolean(steps))
      .updateDisplay()
    find.enable(Boolean(steps))
  }
}
