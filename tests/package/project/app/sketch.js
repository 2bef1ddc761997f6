'use client'

// Next also renders this module on the server, where p5 cannot load.
import 'warpjet/p5'
import { useEffect } from 'react'
import { compileWarp } from 'warpjet'

export function Sketch() {
  useEffect(() => void import('../sketch.js'), [])
  return <p>{compileWarp(({ position }) => position).code.length > 100 ? 'compiled' : ''}</p>
}
