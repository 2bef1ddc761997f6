/** Memoizes an asynchronous function by its first argument. Failures are not remembered. */
export function remember(make) {
  const results = new Map()
  return (key, ...rest) => {
    if (!results.has(key)) {
      const result = make(key, ...rest)
      results.set(key, result)
      result.catch(() => results.delete(key))
    }
    return results.get(key)
  }
}
