// The call and argument that a message is about.
import { WarpError } from '../errors/errors.js'

/** A call in the user's code, and the argument, option or other part of this call that a message is about. */
export class Place {
  constructor(
    /** The name of the called function, which every message begins with. */
    readonly method: string,
    /** The part of the call, such as `argument 2`; empty for the whole call. */
    readonly subject = '',
    /** The path of a nested option, such as `decoders.draco`. */
    private readonly path = '',
  ) {}

  /** Maps the name of an option → its place. */
  private options: Map<string, Place> | undefined

  toString(): string {
    return this.subject ? `${this.method}: ${this.subject}` : this.method
  }

  /** Returns the place of another part of the same call. */
  part(subject: string): Place {
    return new Place(this.method, subject)
  }

  argument(number: number): Place {
    return this.part(`argument ${number}`)
  }

  uniform(name: string): Place {
    return this.part(`the uniform "${name}"`)
  }

  /**
   * Returns the place of an option of the call; if this place is an option itself, that of an option nested in it. Places of options are
   * kept, since some calls read options in each frame.
   */
  option(name: string): Place {
    this.options ??= new Map<string, Place>()
    let place = this.options.get(name)
    if (!place) this.options.set(name, (place = this.makeOption(name)))
    return place
  }

  private makeOption(name: string): Place {
    const path = this.path ? `${this.path}.${name}` : name
    return new Place(this.method, `the option "${path}"`, path)
  }

  error(message: string): WarpError {
    return new WarpError(`${this.method}: ${message}`)
  }

  /** Removes the name of the called function from the start of a message. */
  withoutMethod(message: string): string {
    const start = `${this.method}: `
    return message.startsWith(start) ? message.slice(start.length) : message
  }

  /** Makes the error for a wrong value. `got` describes the value; `advice` says what to write instead. */
  expected(what: string, got: string, advice?: string): WarpError {
    const subject = this.subject && ` for ${this.subject}`
    return this.error(`expected ${what}${subject}, got ${got}${advice ? `; ${advice}` : ''}.`)
  }
}
