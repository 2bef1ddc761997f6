/** Formats numbers for reading. A value that does not exist is a dash. */
const NONE = '–'

/** Formats with about three significant digits, and never as a power of ten. */
export function formatShort(value) {
  if (!Number.isFinite(value)) return NONE
  const digits = Math.max(0, Math.min(9, 2 - Math.floor(Math.log10(Math.abs(value) || 1))))
  return value.toLocaleString('en', {
    minimumFractionDigits: value ? digits : 0,
    maximumFractionDigits: digits,
  })
}

/** Like `formatShort` without trailing zeros, for exact numbers rather than measurements. */
export const formatExact = (value) =>
  Number.isFinite(value) ? value.toLocaleString('en', { maximumSignificantDigits: 3 }) : NONE

/** Formats a ratio with two decimals. */
export const formatRatio = (value) => (Number.isFinite(value) ? value.toFixed(2) : NONE)

/** Formats an integer with its digits in groups of three. */
export const formatInteger = (value) =>
  Number.isFinite(value) ? Math.round(value).toLocaleString('en') : NONE

/** Errors below this many degrees are rounding of float32 and of the comparison. */
export const MIN_ERROR = 1e-5

/** @param value undefined if there is none, NaN if the normal was NaN */
export function formatDegrees(value) {
  if (value === undefined || value === null) return NONE
  if (Number.isNaN(value)) return 'NaN'
  if (value < MIN_ERROR) return '< 0.00001'
  return value < 1
    ? value.toLocaleString('en', { maximumSignificantDigits: 2 })
    : formatShort(value)
}
