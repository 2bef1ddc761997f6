'use client'
// Rendered on the server too, where p5 cannot load.
import 'warpjet/p5'
import { compileWarp } from 'warpjet'
import { useEffect } from 'react'

export function Sketch() {
  useEffect(() => void import('../sketch.js'), [])
  return <p>{compileWarp(({ position }) => position).code.length > 100 ? 'compiled' : ''}</p>
}
