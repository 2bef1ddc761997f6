// Properties of an object that are replaced while it is warped, and restored afterwards.

/** Defines properties; call the result to restore what was there before. */
export function replaceProperties(object: object, properties: PropertyDescriptorMap): () => void {
  const before = Object.keys(properties).map(
    (name) => [name, Object.getOwnPropertyDescriptor(object, name)] as const,
  )
  for (const [name, earlier] of before)
    Object.defineProperty(object, name, {
      configurable: true,
      enumerable: earlier?.enumerable ?? false,
      ...properties[name],
    })
  return () => {
    for (const [name, property] of before) {
      if (property) Object.defineProperty(object, name, property)
      else Reflect.deleteProperty(object, name)
    }
  }
}

type Method = (...given: never[]) => unknown

/**
 * Wraps a method of an object, and any that is assigned to it later; call the result to end that. Whoever reads the method gets the
 * one that wraps the present one for good, so that an assigned method may call it.
 */
export function wrapMethod<Wrapped extends Method>(
  object: object,
  name: string,
  wrap: (own: Wrapped) => Wrapped,
): () => void {
  let own = (object as Record<string, Wrapped>)[name]!
  let wrapper = wrap(own)
  let isAssigned = false
  const restore = replaceProperties(object, {
    [name]: {
      get: () => wrapper,
      set(assigned: Wrapped) {
        isAssigned = true
        own = assigned
        wrapper = wrap(assigned)
      },
    },
  })
  return () => {
    restore()
    if (isAssigned) (object as Record<string, Wrapped>)[name] = own
  }
}

/** A property computed when it is read. It ignores assignments: three.js writes the value without a warp into it. */
export const computedProperty = <Value>(value: () => Value): PropertyDescriptor => ({
  get: value,
  set: () => {},
})

export const asProperties = (values: object): PropertyDescriptorMap =>
  Object.fromEntries(
    Object.entries(values).map(([name, value]) => [name, { value, writable: true }]),
  )
