/** The numbers for which something was computed, so that it is computed again only for others. Creates no garbage. */
export class LastNumbers {
  private readonly numbers: number[] = []
  private count = -1

  /** Tests whether these are the first `count` numbers of an array. */
  are(now: readonly number[], count = now.length): boolean {
    if (count !== this.count) return false
    for (let i = 0; i < count; i++) if (now[i] !== this.numbers[i]) return false
    return true
  }

  /** Keeps the first `count` numbers of an array. */
  set(now: readonly number[], count = now.length) {
    for (let i = 0; i < count; i++) this.numbers[i] = now[i]!
    this.count = count
  }

  forget() {
    this.count = -1
  }
}
