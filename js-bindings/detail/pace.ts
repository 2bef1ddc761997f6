// The frames of a steady motion in which a mesh need not be measured. Creates no garbage.

/** The max difference of a step from the step before, as a share of the step before. It is large, since frames never take equally long. */
const maxChange = 0.5

/** Smaller differences are rounding errors, which the matrices of a moving camera have. */
const rounding = 1e-9

/** The steps between numbers of successive frames. */
class Steps {
  private numbers = new Float64Array()
  private steps = new Float64Array()

  /** Tests whether these are the numbers of the last step. */
  areAt(now: readonly number[], count = now.length): boolean {
    if (count !== this.numbers.length) return false
    for (let i = 0; i < count; i++) if (now[i] !== this.numbers[i]) return false
    return true
  }

  /** Moves to the first `count` numbers of a frame. Returns `true` if each moves on about as in its last step. */
  moveTo(now: readonly number[], count = now.length): boolean {
    let areSteady = count === this.steps.length
    if (!areSteady) {
      this.numbers = new Float64Array(count).fill(NaN)
      this.steps = new Float64Array(count).fill(NaN)
    }
    const { numbers, steps } = this
    for (let i = 0; i < count; i++) {
      const step = now[i]! - numbers[i]!
      const change = Math.abs(step - steps[i]!)
      if (!(change <= maxChange * Math.abs(steps[i]!) + rounding)) areSteady = false
      steps[i] = step
      numbers[i] = now[i]!
    }
    return areSteady
  }
}

/** If a frame is left out, so are this many more calls with equal numbers: other passes of the same frame. */
const maxRepeats = 4

/**
 * Chooses the frames in which a moving mesh is measured. That is every second frame while the motion is steady and the division will stay
 * within the tolerance, and every frame otherwise.
 */
export class Pace {
  private readonly surface = new Steps()
  private readonly views = new Steps()
  private canLeaveOut = false
  private repeats = 0

  /** Moves to the state of the surface, of which there are `count` numbers, and the views of a frame. Returns `true` if it can be left out. */
  leavesOut(state: readonly number[], count: number, views: readonly number[]): boolean {
    if (this.repeats > 0 && this.surface.areAt(state, count) && this.views.areAt(views)) {
      this.repeats--
      return true
    }
    const isSteadySurface = this.surface.moveTo(state, count)
    const areSteadyViews = this.views.moveTo(views)
    const leavesOut = this.canLeaveOut && isSteadySurface && areSteadyViews
    this.canLeaveOut = false
    this.repeats = leavesOut ? maxRepeats : 0
    return leavesOut
  }

  /** Has the next frame measured, since the mesh has changed. */
  forget() {
    this.canLeaveOut = false
    this.repeats = 0
  }

  /** Called after each measurement. `staysExact` is `true` if the division will still be within the tolerance after another step like the last one. */
  measured(staysExact: boolean) {
    this.canLeaveOut = staysExact
  }
}
