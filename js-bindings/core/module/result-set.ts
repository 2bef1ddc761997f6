/** Some results of programs, by number. What is known of a program for them is found by this object, so each set is made once. */
export class ResultSet {
  constructor(readonly numbers: readonly number[]) {}
}
