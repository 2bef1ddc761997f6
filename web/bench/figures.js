/** Numbers as somebody reads them. What does not exist is a dash. */
const NONE = '–'

/** With about three digits that count, and never as a power of ten. */
export function short(value) {
  if (!Number.isFinite(value)) return NONE
  const digits = Math.max(0, Math.min(9, 2 - Math.floor(Math.log10(Math.abs(value) || 1))))
  return value.toLocaleString('en', {
    minimumFractionDigits: value ? digits : 0,
    maximumFractionDigits: digits,
  })
}

/** The same without the zeros at the end, for numbers that are what they are and not measured to three digits. */
export const plain = (value) =>
  Number.isFinite(value) ? value.toLocaleString('en', { maximumSignificantDigits: 3 }) : NONE

/** Of a quotient. */
export const times = (value) => (Number.isFinite(value) ? value.toFixed(2) : NONE)

export const whole = (value) =>
  Number.isFinite(value) ? Math.round(value).toLocaleString('en') : NONE

/** Errors below this are the rounding of float32 and of the comparison. */
export const LEAST_ERROR = 1e-5

/** @param value undefined where there is none, NaN where the normal was not a number */
export function degrees(value) {
  if (value === undefined || value === null) return NONE
  if (Number.isNaN(value)) return 'NaN'
  if (value < LEAST_ERROR) return '< 0.00001'
  return value < 1 ? value.toLocaleString('en', { maximumSignificantDigits: 2 }) : short(value)
}
