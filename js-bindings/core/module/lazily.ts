/** Wraps `make` so that it is called at most once, when its result is first needed. */
export function lazily<Value>(make: () => Value): () => Value {
  let cached: { value: Value } | undefined
  return () => (cached ??= { value: make() }).value
}
