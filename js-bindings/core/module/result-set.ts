/** Results of programs, by number. Caches use the object as a key, so that each set is made only once. */
export class ResultSet {
  constructor(readonly numbers: readonly number[]) {}
}
