// The place of a value, as messages name it.
import { WarpError } from '../errors/errors.js'

/** A function that the user called, and the argument, option or other part of the call that a message is about. */
export class Place {
  constructor(
    /** The name of the function. */
    readonly method: string,
    /** Such as `argument 2`; empty for the whole call. */
    readonly subject = '',
    /** The names of nested options, such as `decoders.draco`. */
    private readonly path = '',
  ) {}

  /** The place that a text such as `evaluate: the mesh` names, for callers that have no place. */
  static of(place: Place | string): Place {
    if (typeof place !== 'string') return place
    const [, method, subject] = /^(.*?)(?:: (.*))?$/s.exec(place)!
    return new Place(method!, subject)
  }

  toString(): string {
    return this.subject ? `${this.method}: ${this.subject}` : this.method
  }

  /** Another part of the same call. */
  part(subject: string): Place {
    return new Place(this.method, subject)
  }

  argument(number: number): Place {
    return this.part(`argument ${number}`)
  }

  /** An option of the call, or of the option that this place is. */
  option(name: string): Place {
    const path = this.path ? `${this.path}.${name}` : name
    return new Place(this.method, `the option "${path}"`, path)
  }

  error(message: string): WarpError {
    return new WarpError(`${this.method}: ${message}`)
  }

  /** The error for a wrong value. `got` describes the value; `advice` says what to write instead. */
  expected(what: string, got: string, advice?: string): WarpError {
    const subject = this.subject && ` for ${this.subject}`
    return this.error(`expected ${what}${subject}, got ${got}${advice ? `; ${advice}` : ''}.`)
  }
}
