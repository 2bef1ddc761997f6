// Objects whose values are made when they are first read: what a sketch gets has hundreds, of which it reads a few.

interface Lazy {
  /** All names, in order; `false` hides one from lists, as `Object.keys` makes them. */
  names: ReadonlyMap<string, boolean>
  make: (name: string) => unknown
}

/** However one looks at the object, every value is there. A value that is assigned or deleted stays so. */
class Handler implements ProxyHandler<object> {
  private readonly made = new Set<PropertyKey>()

  constructor(private readonly lazy: Lazy) {}

  private makeOn(target: object, name: PropertyKey) {
    const { names, make } = this.lazy
    if (typeof name !== 'string' || this.made.has(name) || !names.has(name)) return
    this.made.add(name)
    Object.defineProperty(target, name, {
      value: make(name),
      configurable: true,
      enumerable: names.get(name)!,
      writable: true,
    })
  }

  get(target: object, name: PropertyKey, receiver: unknown): unknown {
    this.makeOn(target, name)
    return Reflect.get(target, name, receiver)
  }

  has(target: object, name: PropertyKey) {
    this.makeOn(target, name)
    return Reflect.has(target, name)
  }

  getOwnPropertyDescriptor(target: object, name: PropertyKey) {
    this.makeOn(target, name)
    return Reflect.getOwnPropertyDescriptor(target, name)
  }

  defineProperty(target: object, name: PropertyKey, descriptor: PropertyDescriptor) {
    this.makeOn(target, name)
    return Reflect.defineProperty(target, name, descriptor)
  }

  deleteProperty(target: object, name: PropertyKey) {
    this.makeOn(target, name)
    return Reflect.deleteProperty(target, name)
  }

  ownKeys(target: object) {
    const { names } = this.lazy
    const isThere = (name: string) => !this.made.has(name) || Object.hasOwn(target, name)
    return [...new Set([...[...names.keys()].filter(isThere), ...Reflect.ownKeys(target)])]
  }
}

/** `throwingPrototype` of nearest.ts may be the prototype. `Reflect.ownKeys` makes no value. */
export const lazyObject = (prototype: object, lazy: Lazy): object =>
  new Proxy(Object.create(prototype) as object, new Handler(lazy))
